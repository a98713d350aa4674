; U-major: every x in [0, T(N+1)) is the index of the vertex that the way back gives.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const x Int)
(declare-const N Int)
(assert (<= 0 N))
(assert (and (<= 0 x) (< x (T (+ N 1)))))
(define-fun y () Int (- (- (T (+ N 1)) 1) x))

; The root of it, by triangular_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (T r) y) (< y (T (+ r 1)))))
(assert (= (T (+ r 1)) (+ (+ (T r) r) 1)))
(assert (=> (and (<= 0 r) (< r (+ N 1))) (<= (+ (+ (T r) r) 1) (T (+ N 1)))))
(assert (=> (and (<= 0 (+ N 1)) (< (+ N 1) r)) (<= (+ (+ (T (+ N 1)) (+ N 1)) 1) (T r))))
(define-fun at_i () Int (- N r))
(define-fun at_j () Int (- r (- y (T r))))
(define-fun index () Int (+ (- (* at_i (+ N 2)) (T at_i)) at_j))

; u_major_reversed.
(assert
  (=>
    (and (<= 0 at_i) (<= 0 at_j) (<= (+ at_i at_j) N))
    (= index (- (- (T (+ N 1)) 1) (+ (T (- N at_i)) (- (- N at_i) at_j))))))

; Denied:
(assert (not (and (and (<= 0 at_i) (<= 0 at_j) (<= (+ at_i at_j) N)) (= index x))))
(check-sat)
