; Of a triangle of one micro-triangle: upright_within is 1 if it stands upright and 0 if it does
; not.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(assert (= (T (+ 0 1)) (+ (+ (T 0) 0) 1)))

; Denied:
(assert (not (and (= (ite true (T 1) (T (- 1 1))) 1) (= (ite false (T 1) (T (- 1 1))) 0))))
(check-sat)
