; Not vacuous: some case fulfils what square_ordered supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; S(r) = r r, by square_step and square_ordered.
(declare-fun S (Int) Int)
(assert (= (S 0) 0))
(declare-const r Int)
(declare-const q Int)
(assert (and (<= 0 r) (< r q)))
(assert (= (S (+ r 1)) (+ (+ (S r) (* 2 r)) 1)))
(assert (= (S (+ q 1)) (+ (+ (S q) (* 2 q)) 1)))
(assert (<= (S (+ r 1)) (S q)))
(assert (< (+ r 1) q))
(check-sat)
