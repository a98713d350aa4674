; Not vacuous: some case fulfils what u_major_moves supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const N Int)
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j) (<= (+ i j) N)))
(assert (<= 1 N))
(assert (=> (<= 0 i) (= (* 2 (T i)) (* i (+ i 1)))))
(assert (=> (<= 0 (* 2 i)) (= (* 2 (T (* 2 i))) (* (* 2 i) (+ (* 2 i) 1)))))
(assert (=> (and (<= 0 0) (< 0 i)) (<= (+ (+ (T 0) 0) 1) (T i))))

; A product of two numbers that are not negative.
(assert (<= 0 (* i (- N i))))
(define-fun here () Int (+ (- (* i (+ N 2)) (T i)) j))
(define-fun next () Int (+ (- (* (* 2 i) (+ (* 2 N) 2)) (T (* 2 i))) (* 2 j)))
(assert (and (< 0 i) (< 0 j) (< (+ i j) N)))
(check-sat)
