; For every x below 2^16 and every place i below 16: bits 2i and 2i+1 of spread(x) are bit i of x
; and 0.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const x (_ BitVec 32))
(declare-const i (_ BitVec 32))
(assert (bvule x (_ bv65535 32)))
(assert (bvule i (_ bv15 32)))
(define-fun part_a () (_ BitVec 32)
  (bvand
    (bvor x (bvshl x (_ bv8 32)))
    (bvudiv (bvnot (_ bv0 32)) (bvadd (bvshl (_ bv1 32) (_ bv8 32)) (_ bv1 32)))))
(define-fun part_b () (_ BitVec 32)
  (bvand
    (bvor part_a (bvshl part_a (_ bv4 32)))
    (bvudiv (bvnot (_ bv0 32)) (bvadd (bvshl (_ bv1 32) (_ bv4 32)) (_ bv1 32)))))
(define-fun part_c () (_ BitVec 32)
  (bvand
    (bvor part_b (bvshl part_b (_ bv2 32)))
    (bvudiv (bvnot (_ bv0 32)) (bvadd (bvshl (_ bv1 32) (_ bv2 32)) (_ bv1 32)))))
(define-fun s () (_ BitVec 32)
  (bvand
    (bvor part_c (bvshl part_c (_ bv1 32)))
    (bvudiv (bvnot (_ bv0 32)) (bvadd (bvshl (_ bv1 32) (_ bv1 32)) (_ bv1 32)))))
(assert (not (= (bvand (bvlshr s (bvadd i i)) (_ bv3 32)) (bvand (bvlshr x i) (_ bv1 32)))))
(check-sat)
