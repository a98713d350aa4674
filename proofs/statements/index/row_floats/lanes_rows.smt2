; For every N in 1..2^16, all iu = floor(uN) and iv = floor(vN) in [0, N], whether uf + vf >= 1, and
; whether uf > 0, which no u = 1 has: with the floors of `floors`, the row and how far along it are
; the specification's, and the row is below N.
; spec::index::w_minor_place and along_row.
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
(define-fun part_b () (_ BitVec 32) (bvsub N (bvadd iu (ite beyond (_ bv1 32) (_ bv0 32)))))
(define-fun part_c () Bool (bvult part_b (bvsub N (_ bv1 32))))
(define-fun part_d () (_ BitVec 32) (bvsub (bvsub N (_ bv1 32)) part_a))
(define-fun part_e () (_ BitVec 32) (bvsub part_b part_d))
(define-fun part_f () (_ BitVec 32) (bvsub (bvsub N (_ bv1 32)) part_d))
(define-fun part_g () (_ BitVec 32) (bvsub (bvsub N (_ bv1 32)) (bvsub N (_ bv1 32))))
(define-fun part_h () (_ BitVec 32) (bvsub part_b part_g))
(define-fun part_i () (_ BitVec 32) (bvsub (bvsub N (_ bv1 32)) part_g))
(define-fun spec_along () (_ BitVec 32)
  (ite (bvult part_a (bvsub N (_ bv1 32)))
    (ite (bvult iv part_a)
      (ite part_c (bvadd iv part_e) (bvadd iv part_f))
      (ite part_c (bvadd part_a part_e) (bvadd part_a part_f)))
    (ite (bvult iv (bvsub N (_ bv1 32)))
      (ite part_c (bvadd iv part_h) (bvadd iv part_i))
      (ite part_c (bvadd (bvsub N (_ bv1 32)) part_h) (bvadd (bvsub N (_ bv1 32)) part_i)))))

; impl.
(define-fun impl_row () (_ BitVec 32)
  (ite (bvslt (bvsub N (_ bv1 32)) part_a) (bvsub N (_ bv1 32)) part_a))
(define-fun impl_along () (_ BitVec 32)
  (bvadd
    (ite (bvslt impl_row iv) impl_row iv)
    (bvadd
      impl_row
      (bvsub
        (ite (bvslt (bvsub N (_ bv1 32)) part_b) (bvsub N (_ bv1 32)) part_b)
        (bvsub N (_ bv1 32))))))
(assert (not (and (= spec_row impl_row) (= spec_along impl_along) (bvult spec_row N))))
(check-sat)
