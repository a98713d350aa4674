; Not vacuous: some case fulfils what rows_back supposes.
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
  (ite (= upper 1) (+ (+ (S (+ (+ iu iv) 1)) (* 2 iv)) 1) (+ (+ (S (+ (+ iu iv) 0)) (* 2 iv)) 0)))

; The root of it, by square_root.
(declare-const r Int)
(assert (<= 0 r))
(assert (and (<= (S r) x) (< x (S (+ r 1)))))
(assert (= (S (+ r 1)) (+ (+ (S r) (* 2 r)) 1)))
(assert
  (=> (and (<= 0 r) (< r (+ (+ iu iv) upper))) (<= (+ (+ (S r) (* 2 r)) 1) (S (+ (+ iu iv) upper)))))
(assert
  (=>
    (and (<= 0 (+ (+ iu iv) upper)) (< (+ (+ iu iv) upper) r))
    (<= (+ (+ (S (+ (+ iu iv) upper)) (* 2 (+ (+ iu iv) upper))) 1) (S r))))
(define-fun back_iu () Int (- (- r (div (- x (S r)) 2)) (mod (- x (S r)) 2)))
(define-fun back_iv () Int (div (- x (S r)) 2))
(define-fun back_upper () Int (mod (- x (S r)) 2))
(assert (and (< 0 iu) (< 0 iv) (= upper 1)))
(check-sat)
