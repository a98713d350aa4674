; Not vacuous: some case fulfils what square_root supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; S(r) = r r, by square_step and square_ordered.
(declare-fun S (Int) Int)
(assert (= (S 0) 0))
(declare-const x Int)
(declare-const r Int)
(declare-const b Int)
(assert (and (<= 0 r) (<= 1 b) (<= 0 x)))
(assert (and (<= (S r) x) (< x (S (+ r (* 2 b))))))
(define-fun next () Int (ite (< x (S (+ r b))) r (+ r b)))
(assert (and (< 1 r) (< 1 b)))
(check-sat)
