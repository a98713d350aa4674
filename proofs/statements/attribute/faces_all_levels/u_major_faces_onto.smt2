; Faces in U-major: every x in [0, N N) is the index of the face that the way back gives.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; S(r) = r r, by square_step and square_ordered.
(declare-fun S (Int) Int)
(assert (= (S 0) 0))
(declare-const x Int)
(declare-const N Int)
(assert (<= 1 N))
(assert (and (<= 0 x) (< x (S N))))
(define-fun y () Int (- (- (S N) 1) x))

; The root of it, by square_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (S r) y) (< y (S (+ r 1)))))
(assert (= (S (+ r 1)) (+ (+ (S r) (* 2 r)) 1)))
(assert (=> (and (<= 0 r) (< r N)) (<= (+ (+ (S r) (* 2 r)) 1) (S N))))
(assert (=> (and (<= 0 N) (< N r)) (<= (+ (+ (S N) (* 2 N)) 1) (S r))))
(define-fun t_iu () Int (- (- N 1) r))
(define-fun t_iv () Int (div (- x (+ (+ (- (* (* 2 N) t_iu) (S t_iu)) (* 2 0)) 0)) 2))
(define-fun t_upper () Int (mod (- x (+ (+ (- (* (* 2 N) t_iu) (S t_iu)) (* 2 0)) 0)) 2))
(define-fun index () Int
  (ite (= t_upper 1)
    (+ (+ (- (* (* 2 N) t_iu) (S t_iu)) (* 2 t_iv)) 1)
    (+ (+ (- (* (* 2 N) t_iu) (S t_iu)) (* 2 t_iv)) 0)))
(assert (= (S t_iu) (* t_iu t_iu)))
(assert (= (S r) (* r r)))
(assert (= (S N) (* N N)))

; Denied:
(assert
  (not
    (and
      (and
        (<= 0 t_iu)
        (<= 0 t_iv)
        (and (<= 0 t_upper) (< t_upper 2))
        (< (+ (+ t_iu t_iv) t_upper) N))
      (= index x))))
(check-sat)
