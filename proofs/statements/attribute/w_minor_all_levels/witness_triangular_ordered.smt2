; Not vacuous: some case fulfils what triangular_ordered supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const r Int)
(declare-const q Int)
(assert (and (<= 0 r) (< r q)))
(assert (= (T (+ r 1)) (+ (+ (T r) r) 1)))
(assert (= (T (+ q 1)) (+ (+ (T q) q) 1)))
(assert (<= (T (+ r 1)) (T q)))
(assert (< (+ r 1) q))
(check-sat)
