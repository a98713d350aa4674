; W-minor: every x >= 0 is the index of the vertex that the way back gives; and x < T(N+1) says the
; same as i+j <= N, for every N: the indices below T(N+1) are those of N micro-triangles to a side,
; and a finer level begins with them, number by number.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const x Int)
(declare-const N Int)
(assert (and (<= 0 x) (<= 0 N)))

; The root of it, by triangular_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (T r) x) (< x (T (+ r 1)))))
(assert (= (T (+ r 1)) (+ (+ (T r) r) 1)))
(assert (=> (and (<= 0 r) (< r (+ N 1))) (<= (+ (+ (T r) r) 1) (T (+ N 1)))))
(assert (=> (and (<= 0 (+ N 1)) (< (+ N 1) r)) (<= (+ (+ (T (+ N 1)) (+ N 1)) 1) (T r))))
(define-fun at_i () Int (- r (- x (T r))))
(define-fun at_j () Int (- x (T r)))
(define-fun index () Int (+ (T (+ at_i at_j)) at_j))

; Denied:
(assert (not (and (<= 0 at_i) (<= 0 at_j) (= index x) (= (< x (T (+ N 1))) (<= (+ at_i at_j) N)))))
(check-sat)
