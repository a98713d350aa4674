; Not vacuous: some case fulfils what square_step supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const r Int)
(define-fun S_0 () Int (* 0 0))
(define-fun S_r () Int (* r r))
(define-fun S_next () Int (* (+ r 1) (+ r 1)))
(assert (= r 3))
(check-sat)
