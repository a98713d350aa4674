; One step from a related state, hypotenuse, with M = 2m: the recursion's digit is the reference's,
; and the new state is related at scale m.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; The relation between the recursion and the reference on a triangle of M micro-triangles to a side.
;   u v w      barycentrics on the recursion's current triangle, times M
;   mid top    the recursion's flips
;   iu iv iw   the reference's words, reduced to the bits that are still to come: each in [0, M)
;   above      the XOR of the reference's t over the bits that are done
(define-fun below ((x Real)) Int (- (- 1) (to_int (- x)))) ; the greatest integer below x
(define-fun lesser ((a Int) (b Int)) Int (ite (< a b) a b))
(define-fun common ((M Int) (u Real) (v Real) (w Real) (top Bool) (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (<= 0.0 u) (<= 0.0 v) (<= 0.0 w) (= (+ u v w) (to_real M))
       (<= 0 iu) (< iu M) (<= 0 iv) (< iv M) (<= 0 iw) (< iw M)
       (= above top)))
; On the base triangle's hypotenuse: the reference's words are those of the square below it.
(define-fun hypotenuse ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                        (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (common M u v w top iu iv iw above) (not mid) (= w 0.0)
       (= iw 0) (= iv (lesser (to_int v) (- M 1))) (= iu (- M 1 iv))))
; Off it, on a triangle that is not turned: the micro-triangle that contains the point nudged towards +u, +v.
(define-fun upright ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                     (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (common M u v w top iu iv iw above) (not mid) (< 0.0 w)
       (= iu (to_int u)) (= iv (to_int v)) (= iw (below w))))
; On a middle triangle, which is turned: every bit is the complement, and u and w have changed places.
(define-fun middle ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                    (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (and (common M u v w top iu iv iw above) mid (< 0.0 v) (< 0.0 w)
       (= iw (- M 1 (to_int u))) (= iv (- M 1 (below v))) (= iu (- M 1 (below w)))))
(define-fun related ((M Int) (u Real) (v Real) (w Real) (mid Bool) (top Bool)
                     (iu Int) (iv Int) (iw Int) (above Bool)) Bool
  (or (hypotenuse M u v w mid top iu iv iw above)
      (upright M u v w mid top iu iv iw above)
      (middle M u v w mid top iu iv iw above)))

; The state, and the index so far.
(declare-const m Int)
(define-fun M () Int (* 2 m))
(declare-const u Real)
(declare-const v Real)
(declare-const w Real)
(declare-const mid Bool)
(declare-const top Bool)
(declare-const iu Int)
(declare-const iv Int)
(declare-const iw Int)
(declare-const above Bool)
(declare-const index Int)
(assert (<= 1 m))
(assert (hypotenuse M u v w mid top iu iv iw above))

; The recursion: spec::index::next_step. A coordinate is held times M, so 1 is written M;
; the new ones come out times M and are halved to be times m.
(define-fun part_a () Int
  (ite (< (to_real M) (* 2.0 w))
    (+ (* 4 index) 2)
    (ite (< (* 2.0 v) (to_real M))
      (ite (< (* 2.0 u) (to_real M)) (+ (* 4 index) 1) (+ (* 4 index) 0))
      (+ (* 4 index) 3))))
(define-fun part_b () Int
  (ite (< (to_real M) (* 2.0 w))
    (+ (* 4 index) 0)
    (ite (< (* 2.0 v) (to_real M))
      (ite (< (* 2.0 u) (to_real M)) (+ (* 4 index) 1) (+ (* 4 index) 2))
      (+ (* 4 index) 3))))
(define-fun next_index () Int
  (ite mid
    (ite top
      (ite (= (* 2.0 v) (to_real M))
        (ite (< (to_real M) (* 2.0 w)) (+ (* 4 index) 2) (+ (* 4 index) 1))
        part_a)
      (ite (= (* 2.0 v) (to_real M))
        (ite (< (to_real M) (* 2.0 w)) (+ (* 4 index) 0) (+ (* 4 index) 1))
        part_b))
    (ite top part_a part_b)))
(define-fun part_c () Real
  (ite (< (to_real M) (* 2.0 w))
    (/ (* 2.0 u) 2.0)
    (ite (< (* 2.0 v) (to_real M))
      (ite (< (* 2.0 u) (to_real M)) (/ (- (+ u v) w) 2.0) (/ (- (- u v) w) 2.0))
      (/ (* 2.0 u) 2.0))))
(define-fun next_u () Real
  (ite mid
    (ite (= (* 2.0 v) (to_real M))
      (ite (< (to_real M) (* 2.0 w)) (/ (* 2.0 u) 2.0) (/ (- (+ u v) w) 2.0))
      part_c)
    part_c))
(define-fun part_d () Real
  (ite (< (to_real M) (* 2.0 w))
    (/ (* 2.0 v) 2.0)
    (ite (< (* 2.0 v) (to_real M))
      (ite (< (* 2.0 u) (to_real M)) (/ (- (+ w u) v) 2.0) (/ (* 2.0 v) 2.0))
      (/ (- (- v u) w) 2.0))))
(define-fun next_v () Real
  (ite mid
    (ite (= (* 2.0 v) (to_real M))
      (ite (< (to_real M) (* 2.0 w)) (/ (* 2.0 v) 2.0) (/ (- (+ w u) v) 2.0))
      part_d)
    part_d))
(define-fun part_e () Real
  (ite (< (to_real M) (* 2.0 w))
    (/ (- (- w u) v) 2.0)
    (ite (< (* 2.0 v) (to_real M))
      (ite (< (* 2.0 u) (to_real M)) (/ (- (+ v w) u) 2.0) (/ (* 2.0 w) 2.0))
      (/ (* 2.0 w) 2.0))))
(define-fun next_w () Real
  (ite mid
    (ite (= (* 2.0 v) (to_real M))
      (ite (< (to_real M) (* 2.0 w)) (/ (- (- w u) v) 2.0) (/ (- (+ v w) u) 2.0))
      part_e)
    part_e))
(define-fun next_mid () Bool
  (ite mid
    (ite (= (* 2.0 v) (to_real M))
      (ite (< (to_real M) (* 2.0 w)) true false)
      (ite (< (to_real M) (* 2.0 w))
        true
        (ite (< (* 2.0 v) (to_real M)) (ite (< (* 2.0 u) (to_real M)) false true) true)))
    (ite (< (to_real M) (* 2.0 w))
      false
      (ite (< (* 2.0 v) (to_real M)) (ite (< (* 2.0 u) (to_real M)) true false) false))))
(define-fun part_f () Bool
  (ite (< (to_real M) (* 2.0 w)) true (ite (< (* 2.0 v) (to_real M)) true false)))
(define-fun part_g () Bool
  (ite (< (to_real M) (* 2.0 w)) false (ite (< (* 2.0 v) (to_real M)) false true)))
(define-fun next_top () Bool
  (ite mid
    (ite top
      (ite (= (* 2.0 v) (to_real M)) true part_f)
      (ite (= (* 2.0 v) (to_real M)) false part_g))
    (ite top part_f part_g)))

; The reference: the highest bit of each word, then spec::index::curve_bits on one bit, where
; the prefix XOR is that of the bits above, XOR the bit itself; then what is left of each word.
(define-fun bu () Bool (<= m iu))
(define-fun bv () Bool (<= m iv))
(define-fun bw () Bool (<= m iw))
(define-fun b0 () Bool (and (not (xor bu bw)) true))
(define-fun b1 () Bool
  (or (and (xor (xor above (and (xor bu bv) b0)) bu) (not b0)) (and (xor bu bv) b0)))
(define-fun next_above () Bool (xor above (and (xor bu bv) b0)))
(define-fun next_iu () Int (ite bu (- iu m) iu))
(define-fun next_iv () Int (ite bv (- iv m) iv))
(define-fun next_iw () Int (ite bw (- iw m) iw))
(define-fun digit () Int (+ (ite b0 1 0) (* 2 (ite b1 1 0))))

; Denied: the digit is the same, and the new state is related at scale m.
(assert
  (not
    (and
      (= next_index (+ (* 4 index) digit))
      (related m next_u next_v next_w next_mid next_top next_iu next_iv next_iw next_above))))
(check-sat)
