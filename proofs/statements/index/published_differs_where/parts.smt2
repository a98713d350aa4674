; For every N = 2^n, n <= 16, and every binary32 number y in [-0, N]: the whole part is y's, in [0,
; N], and what is left in binary32 is the rest exactly, in [-0, 1).
; whole and the difference of spec::index::quantise_scaled on binary32.
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
(declare-const n (_ BitVec 8))
(assert (bvule n (_ bv16 8)))
(define-fun side_bits () (_ BitVec 32) (concat #b0 (bvadd n (_ bv127 8)) (_ bv0 23)))
(declare-const y_bits (_ BitVec 32))
(assert
  (and (bvule (bvand y_bits (_ bv2147483647 32)) side_bits) (bvule y_bits (_ bv2147483648 32))))
(define-fun whole () (_ BitVec 32) ((_ fp.to_ubv 32) RTZ ((_ to_fp 8 24) y_bits)))
(declare-const rest_bits (_ BitVec 32))
(assert
  (=
    ((_ to_fp 8 24) rest_bits)
    (fp.sub RNE ((_ to_fp 8 24) y_bits) ((_ to_fp_unsigned 8 24) RNE whole))))
(assert
  (not
    (and
      (bvule whole (bvshl (_ bv1 32) ((_ zero_extend 24) n)))
      (and
        (bvult (bvand rest_bits (_ bv2147483647 32)) (_ bv1065353216 32))
        (bvule rest_bits (_ bv2147483648 32)))
      (=
        (exact (bvand y_bits (_ bv2147483647 32)) (_ bv0 8))
        (bvadd
          (bvshl ((_ zero_extend 152) whole) (_ bv149 184))
          (exact (bvand rest_bits (_ bv2147483647 32)) (_ bv0 8)))))))
(check-sat)
