; A node and a leaf whose encodings both begin at the same place are the same tree: sequences are
; read in one way.
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

; The induction's statement.
(define-fun one ((T Tree) (S Tree) (t Int) (d Int)) Bool
  (=> (and (stands T t d) (stands S t d)) (= T S)))

; The tree T.
(declare-const A0 Tree)
(declare-const A1 Tree)
(declare-const A2 Tree)
(declare-const A3 Tree)
(define-fun T () Tree (node A0 A1 A2 A3))

; The tree S.
(declare-const b State)
(define-fun S () Tree (leaf b))
(declare-const t Int)
(declare-const d Int)
(assert (placed T t d))
(assert (placed S t d))

; Denied:
(assert (not (one T S t d)))
(check-sat)
