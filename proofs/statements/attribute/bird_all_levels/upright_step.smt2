; Upright ones before a number on the curve, one digit. In a triangle with 2m to a side the number x
; = d m m + x' is in child d, where it is the upright one k', that is x' + excess' = 2k'. Then x +
; excess = 2k for a k below upright_within(2m), and upright_child finds d and k' from k.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const m Int)
(declare-const d Int)
(declare-const number_inside Int)
(declare-const excess_inside Int)
(declare-const k_inside Int)
(declare-const upright Bool)
(assert (and (<= 1 m) (and (<= 0 d) (< d 4))))
(assert (=> (<= 0 m) (= (* 2 (T m)) (* m (+ m 1)))))
(assert (=> (<= 0 (- m 1)) (= (* 2 (T (- m 1))) (* (- m 1) (+ (- m 1) 1)))))
(assert (=> (<= 0 (* 2 m)) (= (* 2 (T (* 2 m))) (* (* 2 m) (+ (* 2 m) 1)))))
(assert (=> (<= 0 (- (* 2 m) 1)) (= (* 2 (T (- (* 2 m) 1))) (* (- (* 2 m) 1) (+ (- (* 2 m) 1) 1)))))

; A product of two numbers that are not negative.
(assert (<= 0 (* (- m 1) m)))
(declare-const excess Int)
(define-fun excess_after () Int
  (ite (= d 0)
    excess
    (ite (= d 1)
      (ite upright (+ excess m) (- excess m))
      (ite (= d 2) excess (ite upright (+ excess m) (- excess m))))))
(define-fun next_upright () Bool
  (ite (= d 0)
    (ite upright true false)
    (ite (= d 1) (ite upright false true) (ite upright true false))))
(define-fun added () Int (- excess_after excess))
(assert (and (<= 0 k_inside) (< k_inside (ite next_upright (T m) (T (- m 1))))))
(assert (= (+ number_inside excess_inside) (* 2 k_inside)))
(define-fun twice_k () Int
  (+
    (+
      (+
        (ite (= d 0) 0 (ite (= d 1) (* m m) (ite (= d 2) (* 2 (* m m)) (* 3 (* m m)))))
        number_inside)
      added)
    excess_inside))
(define-fun k () Int (div twice_k 2))
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

; Denied:
(assert
  (not
    (and
      (= twice_k (* 2 k))
      (and (<= 0 k) (< k (ite upright (T (* 2 m)) (T (- (* 2 m) 1)))))
      (= found_digit d)
      (= found_number k_inside))))
(check-sat)
