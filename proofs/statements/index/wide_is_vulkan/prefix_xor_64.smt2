; For every t below 2^32: f = xor_from_above(t) has f = t XOR (f >> 1), that is f_i = t_i XOR
; f_{i+1} at every place, with 0 above the highest. So, from the top down, f_i is the XOR of t_j for
; all j >= i.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const t (_ BitVec 64))
(assert (bvule t (_ bv4294967295 64)))
(define-fun part_a () (_ BitVec 64)
  (bvxor (bvxor t (bvlshr t (_ bv1 64))) (bvlshr (bvxor t (bvlshr t (_ bv1 64))) (_ bv2 64))))
(define-fun part_b () (_ BitVec 64) (bvxor part_a (bvlshr part_a (_ bv4 64))))
(define-fun part_c () (_ BitVec 64) (bvxor part_b (bvlshr part_b (_ bv8 64))))
(define-fun f () (_ BitVec 64) (bvxor part_c (bvlshr part_c (_ bv16 64))))
(assert (not (and (= f (bvxor t (bvlshr f (_ bv1 64)))) (bvule f (_ bv4294967295 64)))))
(check-sat)
