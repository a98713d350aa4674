; From index to corners, one micro-triangle left: the corners are those of the micro-triangle at the
; words' beginning (a, b), a lower one where the frame is not turned and an upper one where it is.
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
(declare-const a Int)
(declare-const b Int)
(declare-const mid Bool)
(declare-const above Bool)
(define-fun P0_i () Int (ite above (+ a 1) a))
(define-fun P0_j () Int (ite mid (+ b 1) b))
(define-fun P1_i () Int (ite above a (+ a 1)))
(define-fun P1_j () Int P0_j)
(define-fun P2_i () Int (ite mid (+ a 1) a))
(define-fun P2_j () Int (ite mid b (+ b 1)))
(define-fun t_iu () Int
  (ite (< P0_i P1_i) (ite (< P0_i P2_i) P0_i P2_i) (ite (< P1_i P2_i) P1_i P2_i)))
(define-fun t_iv () Int
  (ite (< P0_j P1_j) (ite (< P0_j P2_j) P0_j P2_j) (ite (< P1_j P2_j) P1_j P2_j)))
(define-fun part_a () Int
  (ite (= P1_i P0_i)
    (ite (= P1_j P0_j) 0 (ite (= P2_i P0_i) (ite (= P2_j P0_j) 0 1) 1))
    (ite (= P2_i P0_i) (ite (= P2_j P0_j) 0 1) 1)))
(define-fun part_b () Int
  (ite (= P1_i P0_i)
    (ite (= P1_j P2_j) 0 (ite (= P2_i P0_i) (ite (= P2_j P2_j) 0 1) 1))
    (ite (= P2_i P0_i) (ite (= P2_j P2_j) 0 1) 1)))
(define-fun part_c () Int (ite (= P0_i P0_i) (ite (= P0_j P2_j) 0 part_b) part_b))
(define-fun part_d () Int
  (ite (= P1_i P0_i)
    (ite (= P1_j P1_j) 0 (ite (= P2_i P0_i) (ite (= P2_j P1_j) 0 1) 1))
    (ite (= P2_i P0_i) (ite (= P2_j P1_j) 0 1) 1)))
(define-fun part_e () Int
  (ite (= P1_i P2_i)
    (ite (= P1_j P0_j) 0 (ite (= P2_i P2_i) (ite (= P2_j P0_j) 0 1) 1))
    (ite (= P2_i P2_i) (ite (= P2_j P0_j) 0 1) 1)))
(define-fun part_f () Int
  (ite (= P1_i P2_i)
    (ite (= P1_j P2_j) 0 (ite (= P2_i P2_i) (ite (= P2_j P2_j) 0 1) 1))
    (ite (= P2_i P2_i) (ite (= P2_j P2_j) 0 1) 1)))
(define-fun part_g () Int (ite (= P0_i P2_i) (ite (= P0_j P2_j) 0 part_f) part_f))
(define-fun part_h () Int
  (ite (= P1_i P2_i)
    (ite (= P1_j P1_j) 0 (ite (= P2_i P2_i) (ite (= P2_j P1_j) 0 1) 1))
    (ite (= P2_i P2_i) (ite (= P2_j P1_j) 0 1) 1)))
(define-fun part_i () Int
  (ite (< P0_j P1_j)
    (ite (< P0_j P2_j) (ite (= P0_i P2_i) (ite (= P0_j P0_j) 0 part_e) part_e) part_g)
    (ite (< P1_j P2_j) (ite (= P0_i P2_i) (ite (= P0_j P1_j) 0 part_h) part_h) part_g)))
(define-fun part_j () Int
  (ite (= P1_i P1_i)
    (ite (= P1_j P0_j) 0 (ite (= P2_i P1_i) (ite (= P2_j P0_j) 0 1) 1))
    (ite (= P2_i P1_i) (ite (= P2_j P0_j) 0 1) 1)))
(define-fun part_k () Int
  (ite (= P1_i P1_i)
    (ite (= P1_j P2_j) 0 (ite (= P2_i P1_i) (ite (= P2_j P2_j) 0 1) 1))
    (ite (= P2_i P1_i) (ite (= P2_j P2_j) 0 1) 1)))
(define-fun part_l () Int (ite (= P0_i P1_i) (ite (= P0_j P2_j) 0 part_k) part_k))
(define-fun part_m () Int
  (ite (= P1_i P1_i)
    (ite (= P1_j P1_j) 0 (ite (= P2_i P1_i) (ite (= P2_j P1_j) 0 1) 1))
    (ite (= P2_i P1_i) (ite (= P2_j P1_j) 0 1) 1)))
(define-fun t_upper () Int
  (ite (< P0_i P1_i)
    (ite (< P0_i P2_i)
      (ite (< P0_j P1_j)
        (ite (< P0_j P2_j) (ite (= P0_i P0_i) (ite (= P0_j P0_j) 0 part_a) part_a) part_c)
        (ite (< P1_j P2_j) (ite (= P0_i P0_i) (ite (= P0_j P1_j) 0 part_d) part_d) part_c))
      part_i)
    (ite (< P1_i P2_i)
      (ite (< P0_j P1_j)
        (ite (< P0_j P2_j) (ite (= P0_i P1_i) (ite (= P0_j P0_j) 0 part_j) part_j) part_l)
        (ite (< P1_j P2_j) (ite (= P0_i P1_i) (ite (= P0_j P1_j) 0 part_m) part_m) part_l))
      part_i)))

; Denied:
(assert (not (and (= t_iu a) (= t_iv b) (= t_upper (ite mid 1 0)))))
(check-sat)
