; The induction's step. Supposed that half of r(r+1) is a whole number h,
; spec::attribute::triangular(r) is h and triangular(r+1) is h+r+1, which is half of (r+1)(r+2). So
; for every r >= 0, 2 T(r) = r(r+1) and T(r+1) = T(r) + r + 1.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const r Int)
(declare-const h Int)
(assert (<= 0 r))
(assert (= (* 2 h) (* r (+ r 1))))
(define-fun T_r () Int (div (* r (+ r 1)) 2))
(define-fun T_next () Int (div (* (+ r 1) (+ (+ r 1) 1)) 2))

; Denied:
(assert
  (not (and (= T_r h) (= T_next (+ (+ h r) 1)) (= (* 2 (+ (+ h r) 1)) (* (+ r 1) (+ (+ r 1) 1))))))
(check-sat)
