; At level n, M = 2^n, for every point of the closed triangle: the state that the recursion opens
; with and the words that the reference quantises to are related, nothing flipped, no bit done, no
; digit yet.
; iw is negative, and its low n bits are those of iw + M, which is in [0, M). Holds for every M >=
; 1, powers of two or not.
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

; The point, times M.
(declare-const M Int)
(declare-const u Real)
(declare-const v Real)
(assert (<= 1 M))
(assert (<= 0.0 u))
(assert (<= 0.0 v))
(assert (<= (+ u v) (to_real M)))

; The reference: spec::index::quantise_scaled.
(define-fun iu () Int
  (ite (< (to_int u) M)
    (ite (< (to_int v) M)
      (ite (< (+ (to_int u) (to_int v)) M)
        (to_int u)
        (- (to_int u) (+ (- (+ (to_int u) (to_int v)) M) 1)))
      (ite (< (+ (to_int u) (- M 1)) M)
        (to_int u)
        (- (to_int u) (+ (- (+ (to_int u) (- M 1)) M) 1))))
    (ite (< (to_int v) M)
      (ite (< (+ (- M 1) (to_int v)) M) (- M 1) (- (- M 1) (+ (- (+ (- M 1) (to_int v)) M) 1)))
      (ite (< (+ (- M 1) (- M 1)) M) (- M 1) (- (- M 1) (+ (- (+ (- M 1) (- M 1)) M) 1))))))
(define-fun iv () Int (ite (< (to_int v) M) (to_int v) (- M 1)))
(define-fun part_a () Int
  (- (- (+ (- (to_int u) (+ (- (+ (to_int u) (to_int v)) M) 1)) (to_int v))) 1))
(define-fun part_b () Int (- (- (+ (- (to_int u) (+ (- (+ (to_int u) (- M 1)) M) 1)) (- M 1))) 1))
(define-fun part_c () Int (- (- (+ (- (- M 1) (+ (- (+ (- M 1) (to_int v)) M) 1)) (to_int v))) 1))
(define-fun part_d () Int (- (- (+ (- (- M 1) (+ (- (+ (- M 1) (- M 1)) M) 1)) (- M 1))) 1))
(define-fun iw () Int
  (ite (< (+ (- u (to_real (to_int u))) (- v (to_real (to_int v)))) 1.0)
    (ite (< (to_int u) M)
      (ite (< (to_int v) M)
        (ite (< (+ (to_int u) (to_int v)) M) (- (- (+ (to_int u) (to_int v))) 1) part_a)
        (ite (< (+ (to_int u) (- M 1)) M) (- (- (+ (to_int u) (- M 1))) 1) part_b))
      (ite (< (to_int v) M)
        (ite (< (+ (- M 1) (to_int v)) M) (- (- (+ (- M 1) (to_int v))) 1) part_c)
        (ite (< (+ (- M 1) (- M 1)) M) (- (- (+ (- M 1) (- M 1))) 1) part_d)))
    (ite (< (to_int u) M)
      (ite (< (to_int v) M)
        (ite (< (+ (to_int u) (to_int v)) M)
          (ite (< (+ (to_int u) (to_int v)) (- M 1))
            (- (- (- (+ (to_int u) (to_int v))) 1) 1)
            (- (- (+ (to_int u) (to_int v))) 1))
          (ite (< (+ (to_int u) (to_int v)) (- M 1)) (- part_a 1) part_a))
        (ite (< (+ (to_int u) (- M 1)) M)
          (ite (< (+ (to_int u) (- M 1)) (- M 1))
            (- (- (- (+ (to_int u) (- M 1))) 1) 1)
            (- (- (+ (to_int u) (- M 1))) 1))
          (ite (< (+ (to_int u) (- M 1)) (- M 1)) (- part_b 1) part_b)))
      (ite (< (to_int v) M)
        (ite (< (+ (- M 1) (to_int v)) M)
          (ite (< (+ (- M 1) (to_int v)) (- M 1))
            (- (- (- (+ (- M 1) (to_int v))) 1) 1)
            (- (- (+ (- M 1) (to_int v))) 1))
          (ite (< (+ (- M 1) (to_int v)) (- M 1)) (- part_c 1) part_c))
        (ite (< (+ (- M 1) (- M 1)) M)
          (ite (< (+ (- M 1) (- M 1)) (- M 1))
            (- (- (- (+ (- M 1) (- M 1))) 1) 1)
            (- (- (+ (- M 1) (- M 1))) 1))
          (ite (< (+ (- M 1) (- M 1)) (- M 1)) (- part_d 1) part_d))))))

; The recursion: spec::index::first_step.
(define-fun w () Real (- (- (to_real M) u) v))
(define-fun index () Int 0)

; Denied: they are related.
(assert (not (and (related M u v w false false iu iv (+ iw M) false) (= index 0))))
(check-sat)
