; The way back, one digit: for every k below upright_within(2m), upright_child gives a digit d and a
; k' below d's upright_within(m), and x' + excess' = 2k' makes x + excess = 2k.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

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

; Denied:
(assert
  (not
    (and
      (and (<= 0 found_digit) (< found_digit 4))
      (and (<= 0 found_number) (< found_number (ite next_upright (T m) (T (- m 1)))))
      (=
        (+
          (+
            (+
              (ite (= found_digit 0)
                0
                (ite (= found_digit 1) (* m m) (ite (= found_digit 2) (* 2 (* m m)) (* 3 (* m m)))))
              number_inside)
            added)
          excess_inside)
        (* 2 k)))))
(check-sat)
