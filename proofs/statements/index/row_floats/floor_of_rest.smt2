; For every N in 1..2^16, and every uN = iu + uf in [0, N], uf any multiple of 2^-149 in [0, 1):
; floor(N - uN) is N - iu, one less where uf > 0.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const N (_ BitVec 32))
(declare-const iu (_ BitVec 32))
(declare-const iv (_ BitVec 32))
(declare-const uf (_ BitVec 184))
(declare-const vf (_ BitVec 184))
(assert (bvule N (_ bv65536 32)))
(assert (bvule iu N))
(assert (bvule iv N))
(assert (bvult uf (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))))
(assert (bvult vf (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))))
(define-fun un () (_ BitVec 184) (bvadd (bvshl ((_ zero_extend 152) iu) (_ bv149 184)) uf))
(define-fun vn () (_ BitVec 184) (bvadd (bvshl ((_ zero_extend 152) iv) (_ bv149 184)) vf))
(assert (bvult (_ bv0 32) N))
(assert (not (bvslt (bvshl ((_ zero_extend 152) N) (_ bv149 184)) un)))
(assert (not (bvslt (bvshl ((_ zero_extend 152) N) (_ bv149 184)) vn)))
(assert
  (not
    (=
      ((_ extract 31 0)
        (bvlshr (bvsub (bvshl ((_ zero_extend 152) N) (_ bv149 184)) un) (_ bv149 184)))
      (bvsub
        N
        (bvadd
          iu
          (ite (bvslt (bvshl ((_ zero_extend 152) (_ bv0 32)) (_ bv149 184)) uf)
            (_ bv1 32)
            (_ bv0 32)))))))
(check-sat)
