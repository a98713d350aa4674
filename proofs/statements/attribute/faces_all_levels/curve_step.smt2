; One digit: the words of a micro-triangle with M = 2m to a side have a digit, that of
; spec::index::curve_bits; what is left of them is held by the digit's child, m to a side, and
; stands as before; child 1 alone is turned, below child 3 alone 0 and 2 change places; and the
; digit and the frame tell the words' highest bits.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; A triangle with M micro-triangles to a side, and the words iu iv iw of one of them, reduced to the bits
; that are still to come.
;   mid        the triangle is turned, an odd number of middle children having been entered
;   above      the XOR of the formula's t over the bits that are done
;   upright    how the micro-triangle itself stands
(define-fun held ((M Int) (mid Bool) (upright Bool) (iu Int) (iv Int) (iw Int)) Bool
  (and (<= 0 iu) (< iu M) (<= 0 iv) (< iv M) (<= 0 iw) (< iw M)
       (= (+ iu iv iw) (- (ite mid (- (* 2 M) 1) (- M 1)) (ite upright 0 1)))))
; The words' highest bits in child d: all alike in the middle one, and else one differs.
(define-fun bit_u ((d Int) (mid Bool) (above Bool)) Bool (ite (or (= d 0) (= d 2)) (xor above (= d 2)) mid))
(define-fun bit_v ((d Int) (mid Bool) (above Bool)) Bool (ite (= d 3) (not mid) mid))
(define-fun bit_w ((d Int) (mid Bool) (above Bool)) Bool
  (ite (or (= d 0) (= d 2)) (not (bit_u d mid above)) mid))
(declare-const m Int)
(define-fun M () Int (* 2 m))
(declare-const mid Bool)
(declare-const above Bool)
(declare-const iu Int)
(declare-const iv Int)
(declare-const iw Int)
(declare-const upright Bool)
(assert (<= 1 m))
(assert (held M mid upright iu iv iw))
(define-fun bu () Bool (<= m iu))
(define-fun bv () Bool (<= m iv))
(define-fun bw () Bool (<= m iw))
(define-fun b0 () Bool (and (not (xor bu bw)) true))
(define-fun b1 () Bool
  (or (and (xor (xor above (and (xor bu bv) b0)) bu) (not b0)) (and (xor bu bv) b0)))
(define-fun digit () Int (+ (ite b0 1 0) (* 2 (ite b1 1 0))))
(define-fun t () Bool (and (xor bu bv) b0))
(define-fun next_mid () Bool (xor mid (= digit 1)))
(define-fun next_above () Bool (xor above (= digit 3)))
(define-fun next_iu () Int (ite bu (- iu m) iu))
(define-fun next_iv () Int (ite bv (- iv m) iv))
(define-fun next_iw () Int (ite bw (- iw m) iw))

; Denied:
(assert
  (not
    (and
      (and (<= 0 digit) (< digit 4))
      (held m next_mid upright next_iu next_iv next_iw)
      (= t (= digit 3))
      (= bu (bit_u digit mid above))
      (= bv (bit_v digit mid above))
      (= bw (bit_w digit mid above)))))
(check-sat)
