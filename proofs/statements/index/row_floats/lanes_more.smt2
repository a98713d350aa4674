; For every binary32 number uf in [0, 1): the answer is 1 where uf > 0 exactly, and 0 elsewhere.
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
(assert (bvult uf_bits (_ bv1065353216 32)))
(define-fun got () (_ BitVec 32)
  (bvsub
    (_ bv0 32)
    (ite (fp.gt ((_ to_fp 8 24) uf_bits) ((_ to_fp 8 24) (_ bv0 32)))
      (_ bv4294967295 32)
      (_ bv0 32))))
(assert
  (not
    (=
      got
      (ite (bvslt (bvshl ((_ zero_extend 152) (_ bv0 32)) (_ bv149 184)) (exact uf_bits (_ bv0 8)))
        (_ bv1 32)
        (_ bv0 32)))))
(check-sat)
