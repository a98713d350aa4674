; Not vacuous: some words fulfil what the agreement supposes, at the highest level and strictly
; inside.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const N (_ BitVec 32))
(declare-const iu (_ BitVec 32))
(declare-const iv (_ BitVec 32))
(assert (bvule (_ bv1 32) N))
(assert (bvule N (_ bv65536 32)))
(assert (= (bvand N (bvsub N (_ bv1 32))) (_ bv0 32)))
(assert (bvule iu N))
(assert (bvule iv N))
(assert (= N (_ bv65536 32)))
(assert (and (bvule (_ bv1 32) iu) (not (bvule N iu))))
(assert (and (bvule (_ bv1 32) iv) (not (bvule N iv))))
(check-sat)
