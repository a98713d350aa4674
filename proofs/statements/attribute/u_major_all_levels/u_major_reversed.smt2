; U-major(i, j) = T(N+1) - 1 - W-minor(j, N-i-j): the rows from the u-corner, backwards.
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
(assert (=> (<= 0 i) (= (* 2 (T i)) (* i (+ i 1)))))
(assert (=> (<= 0 (- N i)) (= (* 2 (T (- N i))) (* (- N i) (+ (- N i) 1)))))
(assert (=> (<= 0 (+ N 1)) (= (* 2 (T (+ N 1))) (* (+ N 1) (+ (+ N 1) 1)))))
(define-fun x () Int (+ (- (* i (+ N 2)) (T i)) j))
(define-fun turned () Int (+ (T (+ j (- (- N i) j))) (- (- N i) j)))

; Denied:
(assert (not (= x (- (- (T (+ N 1)) 1) turned))))
(check-sat)
