; spec::index::square is 0 of 0 and grows by 2r+1: (r+1)(r+1) = r r + 2r + 1, for every r.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const r Int)
(define-fun S_0 () Int (* 0 0))
(define-fun S_r () Int (* r r))
(define-fun S_next () Int (* (+ r 1) (+ r 1)))

; Denied:
(assert (not (and (= S_0 0) (= S_r S_r) (= S_next (+ (+ S_r (* 2 r)) 1)))))
(check-sat)
