; U-major: from a vertex to its index, which is below T(N+1), and back is that vertex.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const N Int)
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j) (<= (+ i j) N)))
(define-fun x () Int (+ (- (* i (+ N 2)) (T i)) j))

; u_major_reversed.
(assert
  (=>
    (and (<= 0 i) (<= 0 j) (<= (+ i j) N))
    (= x (- (- (T (+ N 1)) 1) (+ (T (- N i)) (- (- N i) j))))))
(define-fun y () Int (- (- (T (+ N 1)) 1) x))

; The root of it, by triangular_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (T r) y) (< y (T (+ r 1)))))
(assert (= (T (+ r 1)) (+ (+ (T r) r) 1)))
(assert (=> (and (<= 0 r) (< r (- N i))) (<= (+ (+ (T r) r) 1) (T (- N i)))))
(assert (=> (and (<= 0 (- N i)) (< (- N i) r)) (<= (+ (+ (T (- N i)) (- N i)) 1) (T r))))
(assert
  (=> (and (<= 0 (- N i)) (< (- N i) (+ N 1))) (<= (+ (+ (T (- N i)) (- N i)) 1) (T (+ N 1)))))
(assert (=> (and (<= 0 0) (< 0 (- N i))) (<= (+ (+ (T 0) 0) 1) (T (- N i)))))
(define-fun back_i () Int (- N r))
(define-fun back_j () Int (- r (- y (T r))))

; Denied:
(assert (not (and (and (<= 0 x) (< x (T (+ N 1)))) (and (= back_i i) (= back_j j)))))
(check-sat)
