; Algorithm 1: what it makes of four children means the same map as the node that has them.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

; A tree: a leaf with its state, or an internal node with its children.
; A function on trees is declared, and what defines it, one level deep, is a predicate that is asserted
; of the trees in question.
(declare-sort State 0)
(declare-datatypes ((Tree 0)) (((leaf (value State))
                                (node (child0 Tree) (child1 Tree) (child2 Tree) (child3 Tree)))))

; The way from a root to a micro-triangle: a digit, and the rest.
(declare-sort Path 0)
(declare-fun first (Path) Int)
(declare-fun rest (Path) Path)
; The map that T means: the state at the end of each path.
(declare-fun state_at (Tree Path) State)
(define-fun meant ((T Tree) (p Path)) Bool
  (and (<= 0 (first p)) (<= (first p) 3)
       (= (state_at T p)
          (ite ((_ is leaf) T) (value T)
          (ite (= (first p) 0) (state_at (child0 T) (rest p))
          (ite (= (first p) 1) (state_at (child1 T) (rest p))
          (ite (= (first p) 2) (state_at (child2 T) (rest p)) (state_at (child3 T) (rest p)))))))))

; What Algorithm 1 compares of two children: their states; internal nodes have none.
(define-fun same_state ((A Tree) (B Tree)) Bool
  (and (= ((_ is leaf) A) ((_ is leaf) B)) (=> ((_ is leaf) A) (= (value A) (value B)))))

; The tree T.
(declare-const A0 Tree)
(declare-const A1 Tree)
(declare-const A2 Tree)
(declare-const A3 Tree)
(define-fun T () Tree (node A0 A1 A2 A3))
(declare-const p Path)

; spec::tree::merged.
(define-fun M () Tree
  (ite ((_ is leaf) A0)
    (ite (same_state A0 A1)
      (ite (same_state A0 A2) (ite (same_state A0 A3) (ite ((_ is leaf) A0) A0 T) T) T)
      T)
    T))
(assert (meant T p))
(assert (meant M p))
(assert (meant A0 (rest p)))
(assert (meant A1 (rest p)))
(assert (meant A2 (rest p)))
(assert (meant A3 (rest p)))

; Denied:
(assert (not (= (state_at M p) (state_at T p))))
(check-sat)
