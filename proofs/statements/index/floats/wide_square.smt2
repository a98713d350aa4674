; For every N = 2^n, n <= 30, all iu = floor(uN) and iv = floor(vN) in [0, N], and both halves of
; the square, in 64-bit words: impl's square has the specification's iu and iv, and its row is the
; low n bits of NOT iw.
; impl::index::detail::square; spec::index::grid_square.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const N (_ BitVec 64))
(declare-const iu (_ BitVec 64))
(declare-const iv (_ BitVec 64))
(assert (bvule (_ bv1 64) N))
(assert (bvule N (_ bv1073741824 64)))
(assert (= (bvand N (bvsub N (_ bv1 64))) (_ bv0 64)))
(assert (bvule iu N))
(assert (bvule iv N))
(declare-const upper_half Bool)

; The specification.
(define-fun part_a () (_ BitVec 64) (bvadd (bvsub N (_ bv1 64)) (bvsub N (_ bv1 64))))
(define-fun spec_iu () (_ BitVec 64)
  (ite (bvult iu N)
    (ite (bvult iv N)
      (ite (bvult (bvadd iu iv) N) iu (bvsub iu (bvadd (bvsub (bvadd iu iv) N) (_ bv1 64))))
      (ite (bvult (bvadd iu (bvsub N (_ bv1 64))) N)
        iu
        (bvsub iu (bvadd (bvsub (bvadd iu (bvsub N (_ bv1 64))) N) (_ bv1 64)))))
    (ite (bvult iv N)
      (ite (bvult (bvadd (bvsub N (_ bv1 64)) iv) N)
        (bvsub N (_ bv1 64))
        (bvsub (bvsub N (_ bv1 64)) (bvadd (bvsub (bvadd (bvsub N (_ bv1 64)) iv) N) (_ bv1 64))))
      (ite (bvult part_a N)
        (bvsub N (_ bv1 64))
        (bvsub (bvsub N (_ bv1 64)) (bvadd (bvsub part_a N) (_ bv1 64)))))))
(define-fun spec_iv () (_ BitVec 64) (ite (bvult iv N) iv (bvsub N (_ bv1 64))))
(define-fun part_b () (_ BitVec 64)
  (bvnot (bvadd (bvsub iu (bvadd (bvsub (bvadd iu iv) N) (_ bv1 64))) iv)))
(define-fun part_c () Bool (bvult (bvadd iu (bvsub N (_ bv1 64))) (bvsub N (_ bv1 64))))
(define-fun part_d () (_ BitVec 64)
  (bvnot
    (bvadd
      (bvsub iu (bvadd (bvsub (bvadd iu (bvsub N (_ bv1 64))) N) (_ bv1 64)))
      (bvsub N (_ bv1 64)))))
(define-fun part_e () Bool (bvult (bvadd (bvsub N (_ bv1 64)) iv) (bvsub N (_ bv1 64))))
(define-fun part_f () (_ BitVec 64)
  (bvnot
    (bvadd
      (bvsub (bvsub N (_ bv1 64)) (bvadd (bvsub (bvadd (bvsub N (_ bv1 64)) iv) N) (_ bv1 64)))
      iv)))
(define-fun part_g () Bool (bvult part_a N))
(define-fun part_h () Bool (bvult part_a (bvsub N (_ bv1 64))))
(define-fun part_i () (_ BitVec 64) (bvnot part_a))
(define-fun part_j () (_ BitVec 64)
  (bvnot
    (bvadd (bvsub (bvsub N (_ bv1 64)) (bvadd (bvsub part_a N) (_ bv1 64))) (bvsub N (_ bv1 64)))))
(define-fun spec_row () (_ BitVec 64)
  (bvand
    (bvnot
      (ite upper_half
        (ite (bvult iu N)
          (ite (bvult iv N)
            (ite (bvult (bvadd iu iv) N)
              (ite (bvult (bvadd iu iv) (bvsub N (_ bv1 64)))
                (bvsub (bvnot (bvadd iu iv)) (_ bv1 64))
                (bvnot (bvadd iu iv)))
              (ite (bvult (bvadd iu iv) (bvsub N (_ bv1 64))) (bvsub part_b (_ bv1 64)) part_b))
            (ite (bvult (bvadd iu (bvsub N (_ bv1 64))) N)
              (ite part_c
                (bvsub (bvnot (bvadd iu (bvsub N (_ bv1 64)))) (_ bv1 64))
                (bvnot (bvadd iu (bvsub N (_ bv1 64)))))
              (ite part_c (bvsub part_d (_ bv1 64)) part_d)))
          (ite (bvult iv N)
            (ite (bvult (bvadd (bvsub N (_ bv1 64)) iv) N)
              (ite part_e
                (bvsub (bvnot (bvadd (bvsub N (_ bv1 64)) iv)) (_ bv1 64))
                (bvnot (bvadd (bvsub N (_ bv1 64)) iv)))
              (ite part_e (bvsub part_f (_ bv1 64)) part_f))
            (ite part_g
              (ite part_h (bvsub part_i (_ bv1 64)) part_i)
              (ite part_h (bvsub part_j (_ bv1 64)) part_j))))
        (ite (bvult iu N)
          (ite (bvult iv N)
            (ite (bvult (bvadd iu iv) N) (bvnot (bvadd iu iv)) part_b)
            (ite (bvult (bvadd iu (bvsub N (_ bv1 64))) N)
              (bvnot (bvadd iu (bvsub N (_ bv1 64))))
              part_d))
          (ite (bvult iv N)
            (ite (bvult (bvadd (bvsub N (_ bv1 64)) iv) N)
              (bvnot (bvadd (bvsub N (_ bv1 64)) iv))
              part_f)
            (ite part_g part_i part_j)))))
    (bvsub N (_ bv1 64))))

; impl.
(define-fun part_k () (_ BitVec 64) (bvsub (bvsub N (_ bv1 64)) (bvsub N (_ bv1 64))))
(define-fun impl_iu () (_ BitVec 64)
  (ite (bvult iv (bvsub N (_ bv1 64)))
    (ite (bvult iu (bvsub (bvsub N (_ bv1 64)) iv)) iu (bvsub (bvsub N (_ bv1 64)) iv))
    (ite (bvult iu part_k) iu part_k)))
(define-fun impl_iv () (_ BitVec 64) (ite (bvult iv (bvsub N (_ bv1 64))) iv (bvsub N (_ bv1 64))))
(define-fun impl_row () (_ BitVec 64)
  (ite upper_half
    (ite (bvult (bvadd (bvadd iu iv) (_ bv1 64)) (bvsub N (_ bv1 64)))
      (bvadd (bvadd iu iv) (_ bv1 64))
      (bvsub N (_ bv1 64)))
    (ite (bvult (bvadd (bvadd iu iv) (_ bv0 64)) (bvsub N (_ bv1 64)))
      (bvadd (bvadd iu iv) (_ bv0 64))
      (bvsub N (_ bv1 64)))))

; Denied: they are the same, and below N.
(assert
  (not
    (and
      (= spec_iu impl_iu)
      (= spec_iv impl_iv)
      (= spec_row impl_row)
      (bvule spec_iu (bvsub N (_ bv1 64)))
      (bvule spec_iv (bvsub N (_ bv1 64)))
      (bvule spec_row (bvsub N (_ bv1 64))))))
(check-sat)
