; Not vacuous: some case fulfils what sizes_leaf supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

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

; The induction's statements.
(define-fun balanced ((T Tree)) Bool
  (and (= (nodes T) (+ (* 4 (inner T)) 1)) (= (leaves T) (+ (* 3 (inner T)) 1))))
(define-fun within ((T Tree) (x Int)) Bool
  (and (<= (* 3 (nodes T)) (- (* 4 x) 1)) (<= (leaves T) x)))
(define-fun full ((T Tree) (x Int)) Bool (= (* 3 (nodes T)) (- (* 4 x) 1)))

; The tree T.
(declare-const a State)
(define-fun T () Tree (leaf a))
(declare-const y Int)
(assert (counted T))
(assert (<= 1 y))
(assert (<= 2 y))
(check-sat)
