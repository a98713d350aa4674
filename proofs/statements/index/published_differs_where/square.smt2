; For all whole parts iu and iv in [0, N], N <= 2^16, and rests uf and vf, binary32 numbers in [-0,
; 1): in binary32 the specification's square is that of iu, iv and uf + vf >= 1 - 2^-25 exactly.
; spec::index::quantise_scaled on binary32; grid_square.
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
(declare-const N (_ BitVec 32))
(declare-const iu (_ BitVec 32))
(declare-const iv (_ BitVec 32))
(assert (bvule N (_ bv65536 32)))
(assert (bvule iu N))
(assert (bvule iv N))
(declare-const uf_bits (_ BitVec 32))
(declare-const vf_bits (_ BitVec 32))
(assert
  (and
    (bvult (bvand uf_bits (_ bv2147483647 32)) (_ bv1065353216 32))
    (bvule uf_bits (_ bv2147483648 32))))
(assert
  (and
    (bvult (bvand vf_bits (_ bv2147483647 32)) (_ bv1065353216 32))
    (bvule vf_bits (_ bv2147483648 32))))
(define-fun upper_half () Bool
  (not
    (bvslt
      (bvadd
        (exact (bvand uf_bits (_ bv2147483647 32)) (_ bv0 8))
        (exact (bvand vf_bits (_ bv2147483647 32)) (_ bv0 8)))
      (bvsub
        (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))
        (bvshl (_ bv1 184) (_ bv124 184))))))
(define-fun part_a () (_ BitVec 32) (bvsub iu (bvadd (bvsub (bvadd iu iv) N) (_ bv1 32))))
(define-fun part_b () (_ BitVec 32)
  (bvsub iu (bvadd (bvsub (bvadd iu (bvsub N (_ bv1 32))) N) (_ bv1 32))))
(define-fun part_c () (_ BitVec 32)
  (bvsub (bvsub N (_ bv1 32)) (bvadd (bvsub (bvadd (bvsub N (_ bv1 32)) iv) N) (_ bv1 32))))
(define-fun part_d () (_ BitVec 32) (bvadd (bvsub N (_ bv1 32)) (bvsub N (_ bv1 32))))
(define-fun part_e () Bool (bvult part_d N))
(define-fun part_f () (_ BitVec 32)
  (bvsub (bvsub N (_ bv1 32)) (bvadd (bvsub part_d N) (_ bv1 32))))
(define-fun part_g () (_ BitVec 32)
  (ite (bvult iu N)
    (ite (bvult iv N)
      (ite (bvult (bvadd iu iv) N) iu part_a)
      (ite (bvult (bvadd iu (bvsub N (_ bv1 32))) N) iu part_b))
    (ite (bvult iv N)
      (ite (bvult (bvadd (bvsub N (_ bv1 32)) iv) N) (bvsub N (_ bv1 32)) part_c)
      (ite part_e (bvsub N (_ bv1 32)) part_f))))
(define-fun part_h () (_ BitVec 32) (bvnot (bvadd part_a iv)))
(define-fun part_i () (_ BitVec 32) (bvnot (bvadd part_b (bvsub N (_ bv1 32)))))
(define-fun part_j () (_ BitVec 32) (bvnot (bvadd part_c iv)))
(define-fun part_k () (_ BitVec 32) (bvnot part_d))
(define-fun part_l () (_ BitVec 32) (bvnot (bvadd part_f (bvsub N (_ bv1 32)))))
(define-fun part_m () (_ BitVec 32)
  (ite (bvult iu N)
    (ite (bvult iv N)
      (ite (bvult (bvadd iu iv) N) (bvnot (bvadd iu iv)) part_h)
      (ite (bvult (bvadd iu (bvsub N (_ bv1 32))) N) (bvnot (bvadd iu (bvsub N (_ bv1 32)))) part_i))
    (ite (bvult iv N)
      (ite (bvult (bvadd (bvsub N (_ bv1 32)) iv) N) (bvnot (bvadd (bvsub N (_ bv1 32)) iv)) part_j)
      (ite part_e part_k part_l))))
(define-fun part_n () Bool (bvult (bvadd iu (bvsub N (_ bv1 32))) (bvsub N (_ bv1 32))))
(define-fun part_o () Bool (bvult (bvadd (bvsub N (_ bv1 32)) iv) (bvsub N (_ bv1 32))))
(define-fun part_p () Bool (bvult part_d (bvsub N (_ bv1 32))))
(define-fun part_q () (_ BitVec 32)
  (ite (bvult iu N)
    (ite (bvult iv N)
      (ite (bvult (bvadd iu iv) N)
        (ite (bvult (bvadd iu iv) (bvsub N (_ bv1 32)))
          (bvsub (bvnot (bvadd iu iv)) (_ bv1 32))
          (bvnot (bvadd iu iv)))
        (ite (bvult (bvadd iu iv) (bvsub N (_ bv1 32))) (bvsub part_h (_ bv1 32)) part_h))
      (ite (bvult (bvadd iu (bvsub N (_ bv1 32))) N)
        (ite part_n
          (bvsub (bvnot (bvadd iu (bvsub N (_ bv1 32)))) (_ bv1 32))
          (bvnot (bvadd iu (bvsub N (_ bv1 32)))))
        (ite part_n (bvsub part_i (_ bv1 32)) part_i)))
    (ite (bvult iv N)
      (ite (bvult (bvadd (bvsub N (_ bv1 32)) iv) N)
        (ite part_o
          (bvsub (bvnot (bvadd (bvsub N (_ bv1 32)) iv)) (_ bv1 32))
          (bvnot (bvadd (bvsub N (_ bv1 32)) iv)))
        (ite part_o (bvsub part_j (_ bv1 32)) part_j))
      (ite part_e
        (ite part_p (bvsub part_k (_ bv1 32)) part_k)
        (ite part_p (bvsub part_l (_ bv1 32)) part_l)))))
(assert
  (not
    (and
      (= part_g part_g)
      (= (ite (bvult iv N) iv (bvsub N (_ bv1 32))) (ite (bvult iv N) iv (bvsub N (_ bv1 32))))
      (=
        (ite (fp.lt (fp.add RNE ((_ to_fp 8 24) uf_bits) ((_ to_fp 8 24) vf_bits)) ((_ to_fp 8 24) (_ bv1065353216 32)))
          part_m
          part_q)
        (ite upper_half part_q part_m)))))
(check-sat)
