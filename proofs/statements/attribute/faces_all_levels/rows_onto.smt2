; Faces in rows: every x >= 0 is the index of the face that the way back gives; and x < S(N) says
; the same as that it is a face with N to a side, for every N.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; S(r) = r r, by square_step and square_ordered.
(declare-fun S (Int) Int)
(assert (= (S 0) 0))
(declare-const x Int)
(declare-const N Int)
(assert (and (<= 0 x) (<= 1 N)))

; The root of it, by square_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (S r) x) (< x (S (+ r 1)))))
(assert (= (S (+ r 1)) (+ (+ (S r) (* 2 r)) 1)))
(assert (=> (and (<= 0 r) (< r N)) (<= (+ (+ (S r) (* 2 r)) 1) (S N))))
(assert (=> (and (<= 0 N) (< N r)) (<= (+ (+ (S N) (* 2 N)) 1) (S r))))
(define-fun t_iu () Int (- (- r (div (- x (S r)) 2)) (mod (- x (S r)) 2)))
(define-fun t_iv () Int (div (- x (S r)) 2))
(define-fun t_upper () Int (mod (- x (S r)) 2))
(define-fun index () Int
  (ite (= t_upper 1)
    (+ (+ (S (+ (+ t_iu t_iv) 1)) (* 2 t_iv)) 1)
    (+ (+ (S (+ (+ t_iu t_iv) 0)) (* 2 t_iv)) 0)))

; Denied:
(assert
  (not
    (and
      (and (<= 0 t_upper) (< t_upper 2))
      (<= 0 t_iu)
      (<= 0 t_iv)
      (= index x)
      (=
        (< x (S N))
        (and
          (<= 0 t_iu)
          (<= 0 t_iv)
          (and (<= 0 t_upper) (< t_upper 2))
          (< (+ (+ t_iu t_iv) t_upper) N))))))
(check-sat)
