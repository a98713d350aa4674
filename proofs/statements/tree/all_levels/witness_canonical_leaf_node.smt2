; Not vacuous: some case fulfils what canonical_leaf_node supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

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

; No four siblings in T are leaves of one state.
(declare-fun settled (Tree) Bool)
(define-fun settles ((T Tree)) Bool
  (= (settled T)
     (or ((_ is leaf) T)
         (and (settled (child0 T)) (settled (child1 T)) (settled (child2 T)) (settled (child3 T))
              (not (and ((_ is leaf) (child0 T)) ((_ is leaf) (child1 T))
                        ((_ is leaf) (child2 T)) ((_ is leaf) (child3 T))
                        (= (value (child0 T)) (value (child1 T)))
                        (= (value (child0 T)) (value (child2 T)))
                        (= (value (child0 T)) (value (child3 T)))))))))

; The tree of a quarter: a node's child; a leaf means the same state in each.
(define-fun part0 ((T Tree)) Tree (ite ((_ is leaf) T) T (child0 T)))
(define-fun part1 ((T Tree)) Tree (ite ((_ is leaf) T) T (child1 T)))
(define-fun part2 ((T Tree)) Tree (ite ((_ is leaf) T) T (child2 T)))
(define-fun part3 ((T Tree)) Tree (ite ((_ is leaf) T) T (child3 T)))

; T and S mean the same map: state_at is the same on every path.
(declare-fun same (Tree Tree) Bool)
; The induction's statement.
(define-fun alike ((T Tree) (S Tree)) Bool
  (=> (and (settled T) (settled S) (same T S)) (= T S)))

; The tree T.
(declare-const a State)
(define-fun T () Tree (leaf a))

; The tree S.
(declare-const B0 Tree)
(declare-const B1 Tree)
(declare-const B2 Tree)
(declare-const B3 Tree)
(define-fun S () Tree (node B0 B1 B2 B3))
(assert (settles T))
(assert (settles S))

; By same_in_quarters.
(assert
  (=>
    (same T S)
    (and
      (same (part0 T) (part0 S))
      (same (part1 T) (part1 S))
      (same (part2 T) (part2 S))
      (same (part3 T) (part3 S)))))

; Supposed of each quarter, where one of the two trees is smaller, or both.
(assert (alike (part0 T) (part0 S)))
(assert (alike (part1 T) (part1 S)))
(assert (alike (part2 T) (part2 S)))
(assert (alike (part3 T) (part3 S)))
(assert (and (settled T) (settled S)))
(check-sat)
