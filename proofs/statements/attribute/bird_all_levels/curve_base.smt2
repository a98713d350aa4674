; One micro-triangle left: the words have no bit left, and it stands upright if the triangle is not
; turned.
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
(declare-const mid Bool)
(declare-const above Bool)
(declare-const iu Int)
(declare-const iv Int)
(declare-const iw Int)
(declare-const upright Bool)
(assert (held 1 mid upright iu iv iw))

; Denied:
(assert (not (and (= iu 0) (= iv 0) (= iw 0) (= upright (not mid)))))
(check-sat)
