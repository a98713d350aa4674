; For every pattern of 32 bits that is no NaN, and every N = 2^n, n <= 16: clamped to [0,1] and
; times N in binary32 it is x 2^n exactly of the number x that the bits stand for; 0 or -0 for a
; sign, N for a number above 1.
; spec::index::within_unit on binary32.
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
(declare-const x_bits (_ BitVec 32))
(assert (bvule (bvand x_bits (_ bv2147483647 32)) (_ bv2139095040 32)))
(define-fun limited () (_ BitVec 32)
  (ite (bvugt x_bits (_ bv2147483647 32))
    (_ bv0 32)
    (ite (bvugt x_bits (_ bv1065353216 32)) (_ bv1065353216 32) x_bits)))
(define-fun clamped () (_ FloatingPoint 8 24)
  (ite (fp.lt ((_ to_fp 8 24) x_bits) ((_ to_fp 8 24) (_ bv0 32)))
    (ite (fp.lt ((_ to_fp 8 24) (_ bv1065353216 32)) ((_ to_fp 8 24) (_ bv0 32)))
      ((_ to_fp 8 24) (_ bv1065353216 32))
      ((_ to_fp 8 24) (_ bv0 32)))
    (ite (fp.lt ((_ to_fp 8 24) (_ bv1065353216 32)) ((_ to_fp 8 24) x_bits))
      ((_ to_fp 8 24) (_ bv1065353216 32))
      ((_ to_fp 8 24) x_bits))))
(define-fun product () (_ FloatingPoint 8 24) (fp.mul RNE ((_ to_fp 8 24) side_bits) clamped))
(declare-const got_bits (_ BitVec 32))
(assert (= ((_ to_fp 8 24) got_bits) product))
(assert
  (not
    (and
      (bvule (bvand got_bits (_ bv2147483647 32)) side_bits)
      (= (exact (bvand got_bits (_ bv2147483647 32)) (_ bv0 8)) (exact limited n)))))
(check-sat)
