; Not vacuous: some case fulfils what upright_base supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(assert (= (T (+ 0 1)) (+ (+ (T 0) 0) 1)))
(assert true)
(check-sat)
