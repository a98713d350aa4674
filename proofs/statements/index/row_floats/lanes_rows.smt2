; For every N in 1..2^16, all iu = floor(uN) and iv = floor(vN) in [0, N], whether uf + vf >= 1, and
; whether uf > 0, which no u = 1 has: with the floors of `floors_of_sum` and `floor_of_rest`, row,
; col and dia are the specification's, and the row is below N.
; spec::index::w_minor_place.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const N (_ BitVec 32))
(declare-const iu (_ BitVec 32))
(declare-const iv (_ BitVec 32))
(declare-const carry Bool)
(declare-const beyond Bool)
(assert (bvule N (_ bv65536 32)))
(assert (bvult (_ bv0 32) N))
(assert (bvule iu N))
(assert (bvule iv N))
(assert (not (and (= iu N) beyond)))

; The specification.
(define-fun part_a () (_ BitVec 32) (bvadd (bvadd iu iv) (ite carry (_ bv1 32) (_ bv0 32))))
(define-fun spec_row () (_ BitVec 32)
  (ite (bvult part_a (bvsub N (_ bv1 32))) part_a (bvsub N (_ bv1 32))))
(define-fun spec_col () (_ BitVec 32)
  (ite (bvult part_a (bvsub N (_ bv1 32)))
    (ite (bvult iv part_a) iv part_a)
    (ite (bvult iv (bvsub N (_ bv1 32))) iv (bvsub N (_ bv1 32)))))
(define-fun part_b () (_ BitVec 32) (bvsub N (bvadd iu (ite beyond (_ bv1 32) (_ bv0 32)))))
(define-fun spec_dia () (_ BitVec 32)
  (ite (bvult part_b (bvsub N (_ bv1 32))) part_b (bvsub N (_ bv1 32))))

; impl.
(define-fun part_c () (_ BitVec 32)
  (ite (bvslt (bvsub N (_ bv1 32)) part_a) (bvsub N (_ bv1 32)) part_a))
(assert
  (not
    (and
      (= spec_row part_c)
      (= spec_col (ite (bvslt part_c iv) part_c iv))
      (= spec_dia (ite (bvslt (bvsub N (_ bv1 32)) part_b) (bvsub N (_ bv1 32)) part_b))
      (bvult spec_row N))))
(check-sat)
