; Not vacuous: some point fulfils what the opening supposes, off the grid and inside.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const M Int)
(declare-const u Real)
(declare-const v Real)
(assert (<= 1 M))
(assert (and (<= 0.0 u) (<= 0.0 v)))
(assert (< (+ u v) (to_real M)))
(assert (< (to_real (to_int u)) u))
(assert (< (to_real (to_int v)) v))
(check-sat)
