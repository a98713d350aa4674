; bitscan passes over a leaf as over one subtree: with c >= 1 subtrees to pass it comes to where it
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
(declare-const a State)
(define-fun T () Tree (leaf a))
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

; Denied:
(assert (not (passes T c t d)))
(check-sat)
