; For every two binary32 numbers uf and vf in [0, 1): with 0 in the place of what is below 2^-96,
; the answer is still whether uf + vf >= 1 exactly.
; A processor that takes numbers below 2^-126 for 0 loses less, even times 2^30.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; IEEE 754: what 32 bits without a sign, finite, stand for, in units of 2^-149.
(define-fun significand ((x (_ BitVec 32))) (_ BitVec 184)
  ((_ zero_extend 160)
    (concat (ite (= ((_ extract 30 23) x) #x00) #b0 #b1) ((_ extract 22 0) x))))
(define-fun exponent ((x (_ BitVec 32))) (_ BitVec 8)
  (ite (= ((_ extract 30 23) x) #x00) #x00 (bvsub ((_ extract 30 23) x) #x01)))
(define-fun exact ((x (_ BitVec 32)) (n (_ BitVec 8))) (_ BitVec 184)
  (bvshl (significand x) ((_ zero_extend 176) (bvadd (exponent x) n))))
(declare-const uf_bits (_ BitVec 32))
(declare-const vf_bits (_ BitVec 32))
(assert (bvult uf_bits (_ bv1065353216 32)))
(assert (bvult vf_bits (_ bv1065353216 32)))
(define-fun part_a () (_ FloatingPoint 8 24)
  ((_ to_fp 8 24) (ite (bvult uf_bits (_ bv260046848 32)) (_ bv0 32) uf_bits)))
(define-fun part_b () (_ FloatingPoint 8 24)
  ((_ to_fp 8 24) (ite (bvult vf_bits (_ bv260046848 32)) (_ bv0 32) vf_bits)))
(define-fun part_c () Bool (fp.lt part_b part_a))
(define-fun part_d () (_ FloatingPoint 8 24)
  (fp.sub RNE ((_ to_fp 8 24) (_ bv1065353216 32)) part_b))
(define-fun part_e () (_ FloatingPoint 8 24)
  (fp.sub RNE ((_ to_fp 8 24) (_ bv1065353216 32)) part_a))
(define-fun got () (_ BitVec 32)
  (ite (fp.lt part_a part_b)
    (ite part_c
      (ite (fp.geq part_b part_d) (_ bv1 32) (_ bv0 32))
      (ite (fp.geq part_a part_d) (_ bv1 32) (_ bv0 32)))
    (ite part_c
      (ite (fp.geq part_b part_e) (_ bv1 32) (_ bv0 32))
      (ite (fp.geq part_a part_e) (_ bv1 32) (_ bv0 32)))))
(assert
  (not
    (=
      got
      (ite (not (bvslt (bvadd (exact uf_bits (_ bv0 8)) (exact vf_bits (_ bv0 8))) (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))))
        (_ bv1 32)
        (_ bv0 32)))))
(check-sat)
