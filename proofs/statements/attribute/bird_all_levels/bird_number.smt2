; T(2M+1) - T(M+1) = 3 T(M): doubling the side adds three vertices for each upright micro-triangle. 
; The index of edge e of upright one `before` of T(M) lies in [T(M+1), T(2M+1)), and the way back
; gives both.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const M Int)
(declare-const before Int)
(declare-const edge Int)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(assert (=> (<= 0 M) (= (* 2 (T M)) (* M (+ M 1)))))
(assert (=> (<= 0 (+ M 1)) (= (* 2 (T (+ M 1))) (* (+ M 1) (+ (+ M 1) 1)))))
(assert (=> (<= 0 (+ (* 2 M) 1)) (= (* 2 (T (+ (* 2 M) 1))) (* (+ (* 2 M) 1) (+ (+ (* 2 M) 1) 1)))))
(assert (and (<= 1 M) (and (<= 0 before) (< before (T M))) (and (<= 0 edge) (< edge 3))))
(define-fun x () Int (+ (+ (T (+ M 1)) (* 3 before)) edge))
(define-fun back_before () Int (div (- x (T (+ M 1))) 3))
(define-fun back_edge () Int (mod (- x (T (+ M 1))) 3))

; Denied:
(assert
  (not
    (and
      (= (- (T (+ (* 2 M) 1)) (T (+ M 1))) (* 3 (T M)))
      (and (<= (T (+ M 1)) x) (< x (T (+ (* 2 M) 1))))
      (= back_before before)
      (= back_edge edge))))
(check-sat)
