; bitscan passes over a node as over one subtree: with c >= 1 subtrees to pass it comes to where it
; would come from the place behind it with c-1.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; A tree: a leaf with its state, or an internal node with its children.
; A function on trees is declared, and what defines it, one level deep, is a predicate that is asserted
; of the trees in question.
(declare-sort State 0)
(declare-datatypes ((Tree 0)) (((leaf (value State))
                                (node (child0 Tree) (child1 Tree) (child2 Tree) (child3 Tree)))))

; Nodes and leaves, which are the bits and values of an encoding, and internal nodes.
(declare-fun nodes (Tree) Int)
(declare-fun leaves (Tree) Int)
(declare-fun inner (Tree) Int)
(define-fun counted ((T Tree)) Bool
  (ite ((_ is leaf) T)
    (and (= (nodes T) 1) (= (leaves T) 1) (= (inner T) 0))
    (and (= (nodes T) (+ 1 (nodes (child0 T)) (nodes (child1 T)) (nodes (child2 T)) (nodes (child3 T))))
         (= (leaves T) (+ (leaves (child0 T)) (leaves (child1 T)) (leaves (child2 T)) (leaves (child3 T))))
         (= (inner T) (+ 1 (inner (child0 T)) (inner (child1 T)) (inner (child2 T)) (inner (child3 T)))))))

; Succinct-Tree, `size` bits, true for internal nodes; Data.
(declare-const size Int)
(declare-fun internal (Int) Bool)
(declare-fun data (Int) State)
; The encoding of T begins at bit t and value d: pre-order, children first to last.
(declare-fun stands (Tree Int Int) Bool)
(define-fun placed ((T Tree) (t Int) (d Int)) Bool
  (= (stands T t d)
     (and (< t size)
          (ite ((_ is leaf) T)
            (and (not (internal t)) (= (data d) (value T)))
            (and (internal t)
                 (stands (child0 T) (+ t 1) d)
                 (stands (child1 T) (+ t 1 (nodes (child0 T))) (+ d (leaves (child0 T))))
                 (stands (child2 T) (+ t 1 (nodes (child0 T)) (nodes (child1 T)))
                                    (+ d (leaves (child0 T)) (leaves (child1 T))))
                 (stands (child3 T) (+ t 1 (nodes (child0 T)) (nodes (child1 T)) (nodes (child2 T)))
                                    (+ d (leaves (child0 T)) (leaves (child1 T)) (leaves (child2 T)))))))))

; Where bitscan(child, t, d) ends.
(declare-datatypes ((Place 0)) (((place (bit Int) (datum Int)))))
(declare-fun bitscan (Int Int Int) Place)
; The induction's statement: bitscan passes over T, which stands at (t, d), as over one of c subtrees.
(define-fun passes ((T Tree) (c Int) (t Int) (d Int)) Bool
  (=> (and (<= 1 c) (stands T t d))
      (= (bitscan c t d) (bitscan (- c 1) (+ t (nodes T)) (+ d (leaves T))))))

; The tree T.
(declare-const A0 Tree)
(declare-const A1 Tree)
(declare-const A2 Tree)
(declare-const A3 Tree)
(define-fun T () Tree (node A0 A1 A2 A3))
(declare-const c Int)
(declare-const t Int)
(declare-const d Int)
(assert (counted T))
(assert (placed T t d))

; One turn from there: spec::tree::bitscan_turn.
(assert
  (=
    (bitscan c t d)
    (ite (< t size)
      (ite (< 0 c)
        (ite (internal t) (bitscan (- (+ c 4) 1) (+ t 1) d) (bitscan (- c 1) (+ t 1) (+ d 1)))
        (place t d))
      (place t d))))

; Subtrees left to pass after that turn, and where the children stand.
(define-fun c0 () Int (ite (< t size) (ite (< 0 c) (ite (internal t) (- (+ c 4) 1) (- c 1)) c) c))
(define-fun t0 () Int (ite (< t size) (ite (< 0 c) (+ t 1) t) t))
(define-fun d0 () Int (ite (< t size) (ite (< 0 c) (ite (internal t) d (+ d 1)) d) d))
(define-fun t1 () Int (+ t0 (nodes A0)))
(define-fun d1 () Int (+ d0 (leaves A0)))
(define-fun t2 () Int (+ t1 (nodes A1)))
(define-fun d2 () Int (+ d1 (leaves A1)))
(define-fun t3 () Int (+ t2 (nodes A2)))
(define-fun d3 () Int (+ d2 (leaves A2)))

; Supposed of each child, where it stands and for the subtrees that are left then.
(assert (passes A0 c0 t0 d0))
(assert (passes A1 (- c0 1) t1 d1))
(assert (passes A2 (- c0 2) t2 d2))
(assert (passes A3 (- c0 3) t3 d3))

; Denied:
(assert (not (passes T c t d)))
(check-sat)
