; Not vacuous: some case fulfils what triangular_root supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const x Int)
(declare-const r Int)
(declare-const b Int)
(assert (and (<= 0 r) (<= 1 b) (<= 0 x)))
(assert (and (<= (T r) x) (< x (T (+ r (* 2 b))))))
(define-fun next () Int (ite (< x (T (+ r b))) r (+ r b)))
(assert (and (< 1 r) (< 1 b)))
(check-sat)
