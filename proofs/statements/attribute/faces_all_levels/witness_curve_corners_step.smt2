; Not vacuous: some case fulfils what curve_corners_step supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

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
(declare-const a Int)
(declare-const b Int)
(declare-const d Int)
(assert (and (<= 1 m) (and (<= 0 d) (< d 4))))
(declare-const mid Bool)
(declare-const above Bool)
(define-fun P0_i () Int (ite above (+ a (* 2 m)) a))
(define-fun P0_j () Int (ite mid (+ b (* 2 m)) b))
(define-fun P1_i () Int (ite above a (+ a (* 2 m))))
(define-fun P1_j () Int P0_j)
(define-fun P2_i () Int (ite mid (+ a (* 2 m)) a))
(define-fun P2_j () Int (ite mid b (+ b (* 2 m))))
(define-fun next_mid () Bool (xor mid (= d 1)))
(define-fun next_above () Bool (xor above (= d 3)))
(define-fun next_a () Int (ite (bit_u d mid above) (+ a m) a))
(define-fun next_b () Int (ite (bit_v d mid above) (+ b m) b))
(define-fun child_P0_i () Int
  (ite (= d 0)
    P0_i
    (ite (= d 1) (div (+ P0_i P2_i) 2) (ite (= d 2) (div (+ P0_i P1_i) 2) (div (+ P1_i P2_i) 2)))))
(define-fun child_P0_j () Int
  (ite (= d 0)
    P0_j
    (ite (= d 1) (div (+ P0_j P2_j) 2) (ite (= d 2) (div (+ P0_j P1_j) 2) (div (+ P1_j P2_j) 2)))))
(define-fun next_P0_i () Int (ite next_above (+ next_a m) next_a))
(define-fun next_P0_j () Int (ite next_mid (+ next_b m) next_b))
(define-fun child_P1_i () Int
  (ite (= d 0)
    (div (+ P0_i P1_i) 2)
    (ite (= d 1) (div (+ P1_i P2_i) 2) (ite (= d 2) P1_i (div (+ P0_i P2_i) 2)))))
(define-fun child_P1_j () Int
  (ite (= d 0)
    (div (+ P0_j P1_j) 2)
    (ite (= d 1) (div (+ P1_j P2_j) 2) (ite (= d 2) P1_j (div (+ P0_j P2_j) 2)))))
(define-fun next_P1_i () Int (ite next_above next_a (+ next_a m)))
(define-fun next_P1_j () Int next_P0_j)
(define-fun child_P2_i () Int
  (ite (= d 0)
    (div (+ P0_i P2_i) 2)
    (ite (= d 1) (div (+ P0_i P1_i) 2) (ite (= d 2) (div (+ P1_i P2_i) 2) P2_i))))
(define-fun child_P2_j () Int
  (ite (= d 0)
    (div (+ P0_j P2_j) 2)
    (ite (= d 1) (div (+ P0_j P1_j) 2) (ite (= d 2) (div (+ P1_j P2_j) 2) P2_j))))
(define-fun next_P2_i () Int (ite next_mid (+ next_a m) next_a))
(define-fun next_P2_j () Int (ite next_mid next_b (+ next_b m)))
(assert (and (< 1 m) (< 0 a) (< a b) (= d 1)))
(check-sat)
