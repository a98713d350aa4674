; W-minor: a vertex (i, j) is (2i, 2j) a level on, and its index there is greater, but for the
; w-corner's, which is 0 on both.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j)))
(assert (=> (<= 0 (+ i j)) (= (* 2 (T (+ i j))) (* (+ i j) (+ (+ i j) 1)))))
(assert (=> (and (<= 0 0) (< 0 (+ i j))) (<= (+ (+ (T 0) 0) 1) (T (+ i j)))))
(assert
  (=>
    (<= 0 (+ (* 2 i) (* 2 j)))
    (= (* 2 (T (+ (* 2 i) (* 2 j)))) (* (+ (* 2 i) (* 2 j)) (+ (+ (* 2 i) (* 2 j)) 1)))))
(assert
  (=> (and (<= 0 0) (< 0 (+ (* 2 i) (* 2 j)))) (<= (+ (+ (T 0) 0) 1) (T (+ (* 2 i) (* 2 j))))))
(assert
  (=>
    (and (<= 0 (+ i j)) (< (+ i j) (+ (* 2 i) (* 2 j))))
    (<= (+ (+ (T (+ i j)) (+ i j)) 1) (T (+ (* 2 i) (* 2 j))))))
(define-fun here () Int (+ (T (+ i j)) j))
(define-fun next () Int (+ (T (+ (* 2 i) (* 2 j))) (* 2 j)))

; Denied:
(assert
  (not
    (and
      (=> (not (and (= i 0) (= j 0))) (< here next))
      (=> (and (= i 0) (= j 0)) (and (= here 0) (= next 0))))))
(check-sat)
