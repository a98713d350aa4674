; For every x below 2^32 and every place i below 32: bits 2i and 2i+1 of spread(x) are bit i of x
; and 0.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const x (_ BitVec 64))
(declare-const i (_ BitVec 64))
(assert (bvule x (_ bv4294967295 64)))
(assert (bvule i (_ bv31 64)))
(define-fun part_a () (_ BitVec 64)
  (bvand
    (bvor x (bvshl x (_ bv16 64)))
    (bvudiv (bvnot (_ bv0 64)) (bvadd (bvshl (_ bv1 64) (_ bv16 64)) (_ bv1 64)))))
(define-fun part_b () (_ BitVec 64)
  (bvand
    (bvor part_a (bvshl part_a (_ bv8 64)))
    (bvudiv (bvnot (_ bv0 64)) (bvadd (bvshl (_ bv1 64) (_ bv8 64)) (_ bv1 64)))))
(define-fun part_c () (_ BitVec 64)
  (bvand
    (bvor part_b (bvshl part_b (_ bv4 64)))
    (bvudiv (bvnot (_ bv0 64)) (bvadd (bvshl (_ bv1 64) (_ bv4 64)) (_ bv1 64)))))
(define-fun part_d () (_ BitVec 64)
  (bvand
    (bvor part_c (bvshl part_c (_ bv2 64)))
    (bvudiv (bvnot (_ bv0 64)) (bvadd (bvshl (_ bv1 64) (_ bv2 64)) (_ bv1 64)))))
(define-fun s () (_ BitVec 64)
  (bvand
    (bvor part_d (bvshl part_d (_ bv1 64)))
    (bvudiv (bvnot (_ bv0 64)) (bvadd (bvshl (_ bv1 64) (_ bv1 64)) (_ bv1 64)))))
(assert (not (= (bvand (bvlshr s (bvadd i i)) (_ bv3 64)) (bvand (bvlshr x i) (_ bv1 64)))))
(check-sat)
