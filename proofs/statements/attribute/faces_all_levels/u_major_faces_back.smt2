; Faces in U-major: from a face to its index, which is below N N, and back is that face.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; S(r) = r r, by square_step and square_ordered.
(declare-fun S (Int) Int)
(assert (= (S 0) 0))
(declare-const N Int)
(declare-const iu Int)
(declare-const iv Int)
(declare-const upper Int)
(assert (and (<= 0 iu) (<= 0 iv) (and (<= 0 upper) (< upper 2)) (< (+ (+ iu iv) upper) N)))
(define-fun x () Int
  (ite (= upper 1)
    (+ (+ (- (* (* 2 N) iu) (S iu)) (* 2 iv)) 1)
    (+ (+ (- (* (* 2 N) iu) (S iu)) (* 2 iv)) 0)))

; u_major_faces_reversed.
(assert
  (=>
    (and (<= 0 iu) (<= 0 iv) (and (<= 0 upper) (< upper 2)) (< (+ (+ iu iv) upper) N))
    (= x (- (- (S N) 1) (+ (+ (S (- (- N 1) iu)) (* 2 (- (- (- (- N 1) iu) iv) upper))) upper)))))
(define-fun y () Int (- (- (S N) 1) x))

; The root of it, by square_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (S r) y) (< y (S (+ r 1)))))
(assert (= (S (+ r 1)) (+ (+ (S r) (* 2 r)) 1)))
(assert (=> (and (<= 0 r) (< r (- (- N 1) iu))) (<= (+ (+ (S r) (* 2 r)) 1) (S (- (- N 1) iu)))))
(assert
  (=>
    (and (<= 0 (- (- N 1) iu)) (< (- (- N 1) iu) r))
    (<= (+ (+ (S (- (- N 1) iu)) (* 2 (- (- N 1) iu))) 1) (S r))))
(assert
  (=>
    (and (<= 0 (- (- N 1) iu)) (< (- (- N 1) iu) N))
    (<= (+ (+ (S (- (- N 1) iu)) (* 2 (- (- N 1) iu))) 1) (S N))))
(assert (=> (and (<= 0 0) (< 0 (- (- N 1) iu))) (<= (+ (+ (S 0) (* 2 0)) 1) (S (- (- N 1) iu)))))
(define-fun back_iu () Int (- (- N 1) r))
(define-fun back_iv () Int (div (- x (+ (+ (- (* (* 2 N) back_iu) (S back_iu)) (* 2 0)) 0)) 2))
(define-fun back_upper () Int (mod (- x (+ (+ (- (* (* 2 N) back_iu) (S back_iu)) (* 2 0)) 0)) 2))

; Denied:
(assert
  (not (and (and (<= 0 x) (< x (S N))) (and (= back_iu iu) (= back_iv iv) (= back_upper upper)))))
(check-sat)
