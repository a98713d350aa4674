; For n <= 30: the word 1 << n as a float is the number 2^n, which `scale` supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const n (_ BitVec 8))
(assert (bvule n (_ bv30 8)))
(define-fun side_bits () (_ BitVec 32) (concat #b0 (bvadd n (_ bv127 8)) (_ bv0 23)))
(assert
  (not
    (= ((_ to_fp 8 24) RNE (bvshl (_ bv1 32) ((_ zero_extend 24) n))) ((_ to_fp 8 24) side_bits))))
(check-sat)
