; One digit, backwards: for each digit d and all words that d's child holds there are words with M =
; 2m to a side that have this digit and leave these: m more where d's bits are 1.
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
(declare-const d Int)
(declare-const mid Bool)
(declare-const above Bool)
(declare-const iu Int)
(declare-const iv Int)
(declare-const iw Int)
(declare-const upright Bool)
(assert (and (<= 1 m) (and (<= 0 d) (< d 4))))
(define-fun next_mid () Bool (xor mid (= d 1)))
(define-fun next_above () Bool (xor above (= d 3)))
(assert (held m next_mid upright iu iv iw))
(define-fun bu () Bool (bit_u d mid above))
(define-fun bv () Bool (bit_v d mid above))
(define-fun bw () Bool (bit_w d mid above))
(define-fun word_u () Int (ite bu (+ iu m) iu))
(define-fun word_v () Int (ite bv (+ iv m) iv))
(define-fun word_w () Int (ite bw (+ iw m) iw))
(define-fun b0 () Bool (and (not (xor bu bw)) true))
(define-fun b1 () Bool
  (or (and (xor (xor above (and (xor bu bv) b0)) bu) (not b0)) (and (xor bu bv) b0)))
(define-fun digit () Int (+ (ite b0 1 0) (* 2 (ite b1 1 0))))
(define-fun t () Bool (and (xor bu bv) b0))

; Denied:
(assert (not (and (held (* 2 m) mid upright word_u word_v word_w) (= digit d))))
(check-sat)
