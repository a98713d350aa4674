; Not vacuous: some case fulfils what upright_onto supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const m Int)
(declare-const k Int)
(declare-const number_inside Int)
(declare-const excess_inside Int)
(declare-const upright Bool)
(assert (<= 1 m))
(assert (=> (<= 0 m) (= (* 2 (T m)) (* m (+ m 1)))))
(assert (=> (<= 0 (- m 1)) (= (* 2 (T (- m 1))) (* (- m 1) (+ (- m 1) 1)))))
(assert (=> (<= 0 (* 2 m)) (= (* 2 (T (* 2 m))) (* (* 2 m) (+ (* 2 m) 1)))))
(assert (=> (<= 0 (- (* 2 m) 1)) (= (* 2 (T (- (* 2 m) 1))) (* (- (* 2 m) 1) (+ (- (* 2 m) 1) 1)))))

; A product of two numbers that are not negative.
(assert (<= 0 (* (- m 1) m)))
(assert (and (<= 0 k) (< k (ite upright (T (* 2 m)) (T (- (* 2 m) 1))))))
(define-fun found_digit () Int
  (ite upright
    (ite (< k (T m))
      0
      (ite (< (- k (T m)) (T (- m 1))) 1 (ite (< (- (- k (T m)) (T (- m 1))) (T m)) 2 3)))
    (ite (< k (T (- m 1)))
      0
      (ite (< (- k (T (- m 1))) (T m)) 1 (ite (< (- (- k (T (- m 1))) (T m)) (T (- m 1))) 2 3)))))
(define-fun found_number () Int
  (ite upright
    (ite (< k (T m))
      k
      (ite (< (- k (T m)) (T (- m 1)))
        (- k (T m))
        (ite (< (- (- k (T m)) (T (- m 1))) (T m))
          (- (- k (T m)) (T (- m 1)))
          (- (- (- k (T m)) (T (- m 1))) (T m)))))
    (ite (< k (T (- m 1)))
      k
      (ite (< (- k (T (- m 1))) (T m))
        (- k (T (- m 1)))
        (ite (< (- (- k (T (- m 1))) (T m)) (T (- m 1)))
          (- (- k (T (- m 1))) (T m))
          (- (- (- k (T (- m 1))) (T m)) (T (- m 1))))))))
(declare-const excess Int)
(define-fun excess_after () Int
  (ite (= found_digit 0)
    excess
    (ite (= found_digit 1)
      (ite upright (+ excess m) (- excess m))
      (ite (= found_digit 2) excess (ite upright (+ excess m) (- excess m))))))
(define-fun next_upright () Bool
  (ite (= found_digit 0)
    (ite upright true false)
    (ite (= found_digit 1) (ite upright false true) (ite upright true false))))
(define-fun added () Int (- excess_after excess))
(assert (= (+ number_inside excess_inside) (* 2 found_number)))
(assert (and (< 1 m) (= found_digit 2) (< 0 found_number)))
(check-sat)
