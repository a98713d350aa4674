; The reference's clamp, spec::index::within_unit, changes no number of [0,1]: on the closed
; triangle u and v are scaled as they are.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const q Real)
(assert (<= 0.0 q))
(assert (<= q 1.0))
(define-fun clamped () Real (ite (< q 0.0) (ite (< 1.0 0.0) 1.0 0.0) (ite (< 1.0 q) 1.0 q)))
(assert (not (= clamped q)))
(check-sat)
