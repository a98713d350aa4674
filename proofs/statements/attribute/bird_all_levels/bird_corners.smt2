; With one micro-triangle to a side every vertex is a corner, and the corners' indices are 0, 1 and
; 2: all below T(2) = 3.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(assert (=> (<= 0 2) (= (* 2 (T 2)) (* 2 (+ 2 1)))))
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j) (<= (+ i j) 1)))
(define-fun x () Int
  (ite (= i 0) (ite (= j 0) 0 (ite (= i 1) 1 (ite (= j 1) 2 3))) (ite (= i 1) 1 (ite (= j 1) 2 3))))

; Denied:
(assert
  (not
    (and
      (< x (T (+ 1 1)))
      (= (T (+ 1 1)) 3)
      (= (= x 0) (and (= i 0) (= j 0)))
      (= (= x 1) (= i 1))
      (= (= x 2) (= j 1)))))
(check-sat)
