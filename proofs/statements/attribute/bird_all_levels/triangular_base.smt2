; The induction's base: spec::attribute::triangular(0) is 0, half of 0 times 1.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(define-fun T_0 () Int (div (* 0 (+ 0 1)) 2))

; Denied:
(assert (not (and (= T_0 0) (= (* 2 T_0) 0))))
(check-sat)
