; Not vacuous: some case fulfils what bird_corners supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(assert (=> (<= 0 2) (= (* 2 (T 2)) (* 2 (+ 2 1)))))
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j) (<= (+ i j) 1)))
(define-fun x () Int
  (ite (= i 0) (ite (= j 0) 0 (ite (= i 1) 1 (ite (= j 1) 2 3))) (ite (= i 1) 1 (ite (= j 1) 2 3))))
(assert (= j 1))
(check-sat)
