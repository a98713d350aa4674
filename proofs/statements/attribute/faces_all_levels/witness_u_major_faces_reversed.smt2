; Not vacuous: some case fulfils what u_major_faces_reversed supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

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
(define-fun row () Int (- (- N 1) iu))
(assert (= (S iu) (* iu iu)))
(assert (= (S row) (* row row)))
(assert (= (S N) (* N N)))
(define-fun turned_iv () Int (- (- row iv) upper))
(define-fun turned () Int
  (ite (= upper 1)
    (+ (+ (S (+ (+ iv turned_iv) 1)) (* 2 turned_iv)) 1)
    (+ (+ (S (+ (+ iv turned_iv) 0)) (* 2 turned_iv)) 0)))
(assert (and (< 0 iu) (< 0 iv) (= upper 1)))
(check-sat)
