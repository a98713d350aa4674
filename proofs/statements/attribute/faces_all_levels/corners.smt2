; A face's corners are vertices of its level, wind like the base triangle, (x1-x0)(y2-y0) -
; (x2-x0)(y1-y0) = 1, and the first two tell the face.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const N Int)
(declare-const iu Int)
(declare-const iv Int)
(declare-const upper Int)
(assert (and (<= 0 iu) (<= 0 iv) (and (<= 0 upper) (< upper 2)) (< (+ (+ iu iv) upper) N)))
(define-fun c0_i () Int (ite (= upper 1) (+ iu 1) iu))
(define-fun c0_j () Int (ite (= upper 1) (+ iv 1) iv))
(define-fun c1_i () Int (ite (= upper 1) iu (+ iu 1)))
(define-fun c1_j () Int c0_j)
(define-fun c2_i () Int c0_i)
(define-fun c2_j () Int (ite (= upper 1) iv (+ iv 1)))
(define-fun back_iu () Int (ite (< c0_i c1_i) c0_i c1_i))
(define-fun back_iv () Int (ite (< c0_i c1_i) c0_j (- c1_j 1)))
(define-fun back_upper () Int (ite (< c0_i c1_i) 0 1))

; Denied:
(assert
  (not
    (and
      (and (<= 0 c0_i) (<= 0 c0_j) (<= (+ c0_i c0_j) N))
      (and (<= 0 c1_i) (<= 0 c1_j) (<= (+ c1_i c1_j) N))
      (and (<= 0 c2_i) (<= 0 c2_j) (<= (+ c2_i c2_j) N))
      (= (- (* (- c1_i c0_i) (- c2_j c0_j)) (* (- c2_i c0_i) (- c1_j c0_j))) 1)
      (and (= back_iu iu) (= back_iv iv) (= back_upper upper)))))
(check-sat)
