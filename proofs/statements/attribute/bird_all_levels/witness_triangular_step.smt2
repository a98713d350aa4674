; Not vacuous: some case fulfils what triangular_step supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const r Int)
(declare-const h Int)
(assert (<= 0 r))
(assert (= (* 2 h) (* r (+ r 1))))
(define-fun T_r () Int (div (* r (+ r 1)) 2))
(define-fun T_next () Int (div (* (+ r 1) (+ (+ r 1) 1)) 2))
(assert (and (= r 3)))
(check-sat)
