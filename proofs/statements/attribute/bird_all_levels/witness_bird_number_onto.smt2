; Not vacuous: some case fulfils what bird_number_onto supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const M Int)
(declare-const wanted Int)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(assert (=> (<= 0 M) (= (* 2 (T M)) (* M (+ M 1)))))
(assert (=> (<= 0 (+ M 1)) (= (* 2 (T (+ M 1))) (* (+ M 1) (+ (+ M 1) 1)))))
(assert (=> (<= 0 (+ (* 2 M) 1)) (= (* 2 (T (+ (* 2 M) 1))) (* (+ (* 2 M) 1) (+ (+ (* 2 M) 1) 1)))))
(assert (<= 1 M))
(assert (and (<= (T (+ M 1)) wanted) (< wanted (T (+ (* 2 M) 1)))))
(define-fun before () Int (div (- wanted (T (+ M 1))) 3))
(define-fun edge () Int (mod (- wanted (T (+ M 1))) 3))
(define-fun x () Int (+ (+ (T (+ M 1)) (* 3 before)) edge))
(assert (and (< 1 M) (< 0 before) (= edge 2)))
(check-sat)
