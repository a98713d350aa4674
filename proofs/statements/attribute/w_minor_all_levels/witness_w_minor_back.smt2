; Not vacuous: some case fulfils what w_minor_back supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j)))
(define-fun x () Int (+ (T (+ i j)) j))

; The root of it, by triangular_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (T r) x) (< x (T (+ r 1)))))
(assert (= (T (+ r 1)) (+ (+ (T r) r) 1)))
(assert (=> (and (<= 0 r) (< r (+ i j))) (<= (+ (+ (T r) r) 1) (T (+ i j)))))
(assert (=> (and (<= 0 (+ i j)) (< (+ i j) r)) (<= (+ (+ (T (+ i j)) (+ i j)) 1) (T r))))
(define-fun back_i () Int (- r (- x (T r))))
(define-fun back_j () Int (- x (T r)))
(assert (and (< 0 i) (< i j)))
(check-sat)
