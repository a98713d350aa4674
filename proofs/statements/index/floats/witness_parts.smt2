; Not vacuous: some number fulfils what `parts` supposes, above 1 and not whole.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; IEEE 754: what 32 bits without a sign, finite, stand for, in units of 2^-149.
(define-fun significand ((x (_ BitVec 32))) (_ BitVec 184)
  ((_ zero_extend 160)
    (concat (ite (= ((_ extract 30 23) x) #x00) #b0 #b1) ((_ extract 22 0) x))))
(define-fun exponent ((x (_ BitVec 32))) (_ BitVec 8)
  (ite (= ((_ extract 30 23) x) #x00) #x00 (bvsub ((_ extract 30 23) x) #x01)))
(define-fun exact ((x (_ BitVec 32)) (n (_ BitVec 8))) (_ BitVec 184)
  (bvshl (significand x) ((_ zero_extend 176) (bvadd (exponent x) n))))
(declare-const n (_ BitVec 8))
(assert (bvule n (_ bv30 8)))
(define-fun side_bits () (_ BitVec 32) (concat #b0 (bvadd n (_ bv127 8)) (_ bv0 23)))
(declare-const y_bits (_ BitVec 32))
(assert (bvule y_bits side_bits))
(assert (bvult (_ bv1065353216 32) y_bits))
(assert (not (= (fp.roundToIntegral RTZ ((_ to_fp 8 24) y_bits)) ((_ to_fp 8 24) y_bits))))
(check-sat)
