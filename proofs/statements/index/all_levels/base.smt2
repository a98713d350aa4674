; The induction's base, scale M = 1 (level 0, or all levels done): the reference's words have no bit
; left, and the recursion takes no step: neither index gets another digit.
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
(define-fun M () Int 1)
(declare-const u Real)
(declare-const v Real)
(declare-const w Real)
(declare-const mid Bool)
(declare-const top Bool)
(declare-const iu Int)
(declare-const iv Int)
(declare-const iw Int)
(declare-const above Bool)
(assert (related M u v w mid top iu iv iw above))
(assert (not (and (= iu 0) (= iv 0) (= iw 0))))
(check-sat)
