; Algorithm 2 with a leaf on top of the stack: its encoding is appended to both sequences, and then
; what was below it is on top. Sequences are as they will be: what is appended stays.
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

; Algorithm 2's stack, its top first.
(declare-datatypes ((Stack 0)) (((bottom) (stacked (top Tree) (below Stack)))))
; Algorithm 2 comes to have this stack, with t bits and d values appended.
(declare-fun reached (Stack Int Int) Bool)
; The induction's statement: once T is on top of S, its encoding is appended, and S is left.
(define-fun written ((T Tree) (S Stack) (t Int) (d Int)) Bool
  (=> (reached (stacked T S) t d)
      (and (stands T t d) (reached S (+ t (nodes T)) (+ d (leaves T))))))

; The tree T.
(declare-const a State)
(define-fun T () Tree (leaf a))
(declare-const S Stack)
(declare-const t Int)
(declare-const d Int)
(assert (counted T))
(assert (placed T t d))

; One turn, with what it appends and the stack it leaves: spec::tree::succinct_turn.
(assert
  (=>
    (reached (stacked T S) t d)
    (ite (not ((_ is leaf) T))
      (and
        (< t size)
        (internal t)
        (reached
          (stacked (child0 T) (stacked (child1 T) (stacked (child2 T) (stacked (child3 T) S))))
          (+ t 1)
          d))
      (and (< t size) (not (internal t)) (= (data d) (value T)) (reached S (+ t 1) (+ d 1))))))

; Denied:
(assert (not (written T S t d)))
(check-sat)
