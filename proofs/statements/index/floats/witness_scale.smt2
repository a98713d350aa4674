; Not vacuous: `scale` supposes a level alone; there is one, above a number below 2^-126.
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
(declare-const x_bits (_ BitVec 32))
(assert (and (= n (_ bv30 8)) (bvult x_bits (_ bv8388608 32)) (bvult (_ bv0 32) x_bits)))
(check-sat)
