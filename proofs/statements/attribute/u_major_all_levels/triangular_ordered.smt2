; T grows, by an induction over q from r+1 on, where it is the step's: if T(q) >= T(r+1) then T(q+1)
; >= T(r+1).
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const r Int)
(declare-const q Int)
(assert (and (<= 0 r) (< r q)))
(assert (= (T (+ r 1)) (+ (+ (T r) r) 1)))
(assert (= (T (+ q 1)) (+ (+ (T q) q) 1)))
(assert (<= (T (+ r 1)) (T q)))

; Denied:
(assert (not (and (<= (+ (+ (T r) r) 1) (T q)) (<= (T (+ r 1)) (T (+ q 1))))))
(check-sat)
