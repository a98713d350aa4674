; Not vacuous: some words fulfil what the statement about squares supposes, at the highest level and
; strictly inside.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const N (_ BitVec 64))
(declare-const iu (_ BitVec 64))
(declare-const iv (_ BitVec 64))
(assert (bvule (_ bv1 64) N))
(assert (bvule N (_ bv1073741824 64)))
(assert (= (bvand N (bvsub N (_ bv1 64))) (_ bv0 64)))
(assert (bvule iu N))
(assert (bvule iv N))
(assert (= N (_ bv1073741824 64)))
(assert (and (bvule (_ bv1 64) iu) (not (bvule N iu))))
(assert (and (bvule (_ bv1 64) iv) (not (bvule N iv))))
(check-sat)
