; For every t below 2^16: f = xor_from_above(t) has f = t XOR (f >> 1), that is f_i = t_i XOR
; f_{i+1} at every place, with 0 above the highest. So, from the top down, f_i is the XOR of t_j for
; all j >= i.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const t (_ BitVec 32))
(assert (bvule t (_ bv65535 32)))
(define-fun part_a () (_ BitVec 32)
  (bvxor (bvxor t (bvlshr t (_ bv1 32))) (bvlshr (bvxor t (bvlshr t (_ bv1 32))) (_ bv2 32))))
(define-fun part_b () (_ BitVec 32) (bvxor part_a (bvlshr part_a (_ bv4 32))))
(define-fun f () (_ BitVec 32) (bvxor part_b (bvlshr part_b (_ bv8 32))))
(assert (not (and (= f (bvxor t (bvlshr f (_ bv1 32)))) (bvule f (_ bv65535 32)))))
(check-sat)
