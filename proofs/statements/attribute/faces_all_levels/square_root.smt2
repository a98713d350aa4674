; The loop of w_minor_row: it begins with r = 0 and a bit b with x < S(2b); a turn keeps S(r) <= x <
; S(r + 2b), with half the bit, and after the turn with b = 1 it is S(r) <= x < S(r + 1).
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; S(r) = r r, by square_step and square_ordered.
(declare-fun S (Int) Int)
(assert (= (S 0) 0))
(declare-const x Int)
(declare-const r Int)
(declare-const b Int)
(assert (and (<= 0 r) (<= 1 b) (<= 0 x)))
(assert (and (<= (S r) x) (< x (S (+ r (* 2 b))))))
(define-fun next () Int (ite (< x (S (+ r b))) r (+ r b)))

; Denied:
(assert (not (and (<= r next) (<= (S next) x) (< x (S (+ next b))) (<= (S 0) x))))
(check-sat)
