; Not vacuous: some case fulfils what upright_ordered supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; T(r) = r(r+1)/2, by triangular_step and triangular_ordered.
(declare-fun T (Int) Int)
(assert (= (T 0) 0))
(declare-const m Int)
(declare-const k Int)
(declare-const later Int)
(declare-const upright Bool)
(assert (<= 1 m))
(assert (=> (<= 0 m) (= (* 2 (T m)) (* m (+ m 1)))))
(assert (=> (<= 0 (- m 1)) (= (* 2 (T (- m 1))) (* (- m 1) (+ (- m 1) 1)))))
(assert (=> (<= 0 (* 2 m)) (= (* 2 (T (* 2 m))) (* (* 2 m) (+ (* 2 m) 1)))))
(assert (=> (<= 0 (- (* 2 m) 1)) (= (* 2 (T (- (* 2 m) 1))) (* (- (* 2 m) 1) (+ (- (* 2 m) 1) 1)))))

; A product of two numbers that are not negative.
(assert (<= 0 (* (- m 1) m)))
(assert (and (<= 0 k) (< k later) (< later (ite upright (T (* 2 m)) (T (- (* 2 m) 1))))))
(define-fun first_digit () Int
  (ite upright
    (ite (< k (T m))
      0
      (ite (< (- k (T m)) (T (- m 1))) 1 (ite (< (- (- k (T m)) (T (- m 1))) (T m)) 2 3)))
    (ite (< k (T (- m 1)))
      0
      (ite (< (- k (T (- m 1))) (T m)) 1 (ite (< (- (- k (T (- m 1))) (T m)) (T (- m 1))) 2 3)))))
(define-fun first_number () Int
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
(define-fun second_digit () Int
  (ite upright
    (ite (< later (T m))
      0
      (ite (< (- later (T m)) (T (- m 1))) 1 (ite (< (- (- later (T m)) (T (- m 1))) (T m)) 2 3)))
    (ite (< later (T (- m 1)))
      0
      (ite (< (- later (T (- m 1))) (T m))
        1
        (ite (< (- (- later (T (- m 1))) (T m)) (T (- m 1))) 2 3)))))
(define-fun second_number () Int
  (ite upright
    (ite (< later (T m))
      later
      (ite (< (- later (T m)) (T (- m 1)))
        (- later (T m))
        (ite (< (- (- later (T m)) (T (- m 1))) (T m))
          (- (- later (T m)) (T (- m 1)))
          (- (- (- later (T m)) (T (- m 1))) (T m)))))
    (ite (< later (T (- m 1)))
      later
      (ite (< (- later (T (- m 1))) (T m))
        (- later (T (- m 1)))
        (ite (< (- (- later (T (- m 1))) (T m)) (T (- m 1)))
          (- (- later (T (- m 1))) (T m))
          (- (- (- later (T (- m 1))) (T m)) (T (- m 1))))))))
(assert (and (< 1 m) (< first_digit second_digit)))
(check-sat)
