; Algorithm 2 with a node on top of the stack: its encoding is appended to both sequences, and then
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
(declare-const A0 Tree)
(declare-const A1 Tree)
(declare-const A2 Tree)
(declare-const A3 Tree)
(define-fun T () Tree (node A0 A1 A2 A3))
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

; Where the children stand.
(define-fun t0 () Int (+ t 1))
(define-fun d0 () Int d)
(define-fun t1 () Int (+ t0 (nodes A0)))
(define-fun d1 () Int (+ d0 (leaves A0)))
(define-fun t2 () Int (+ t1 (nodes A1)))
(define-fun d2 () Int (+ d1 (leaves A1)))
(define-fun t3 () Int (+ t2 (nodes A2)))
(define-fun d3 () Int (+ d2 (leaves A2)))

; Supposed of each child, on top of those after it.
(assert (written A0 (stacked A1 (stacked A2 (stacked A3 S))) t0 d0))
(assert (written A1 (stacked A2 (stacked A3 S)) t1 d1))
(assert (written A2 (stacked A3 S) t2 d2))
(assert (written A3 S t3 d3))

; Denied:
(assert (not (written T S t d)))
(check-sat)
