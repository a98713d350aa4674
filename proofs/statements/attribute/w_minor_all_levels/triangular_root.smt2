; The loop of triangular_root: it begins with r = 0 and a bit b with x < T(2b); a turn keeps T(r) <=
; x < T(r + 2b), with half the bit, and after the turn with b = 1 it is T(r) <= x < T(r + 1).
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const x Int)
(declare-const r Int)
(declare-const b Int)
(assert (and (<= 0 r) (<= 1 b) (<= 0 x)))
(assert (and (<= (T r) x) (< x (T (+ r (* 2 b))))))
(define-fun next () Int (ite (< x (T (+ r b))) r (+ r b)))

; Denied:
(assert (not (and (<= r next) (<= (T next) x) (< x (T (+ next b))) (<= (T 0) x))))
(check-sat)
