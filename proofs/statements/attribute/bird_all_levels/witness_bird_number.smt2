; Not vacuous: some case fulfils what bird_number supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const M Int)
(declare-const before Int)
(declare-const edge Int)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(assert (=> (<= 0 M) (= (* 2 (T M)) (* M (+ M 1)))))
(assert (=> (<= 0 (+ M 1)) (= (* 2 (T (+ M 1))) (* (+ M 1) (+ (+ M 1) 1)))))
(assert (=> (<= 0 (+ (* 2 M) 1)) (= (* 2 (T (+ (* 2 M) 1))) (* (+ (* 2 M) 1) (+ (+ (* 2 M) 1) 1)))))
(assert (and (<= 1 M) (and (<= 0 before) (< before (T M))) (and (<= 0 edge) (< edge 3))))
(define-fun x () Int (+ (+ (T (+ M 1)) (* 3 before)) edge))
(define-fun back_before () Int (div (- x (T (+ M 1))) 3))
(define-fun back_edge () Int (mod (- x (T (+ M 1))) 3))
(assert (and (< 1 M) (< 0 before) (= edge 2)))
(check-sat)
