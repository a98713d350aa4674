; Trees that give a path the same state do so in the quarter that its first digit names: so those
; that mean the same map do in each quarter.
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

; The tree of a quarter: a node's child; a leaf means the same state in each.
(define-fun part0 ((T Tree)) Tree (ite ((_ is leaf) T) T (child0 T)))
(define-fun part1 ((T Tree)) Tree (ite ((_ is leaf) T) T (child1 T)))
(define-fun part2 ((T Tree)) Tree (ite ((_ is leaf) T) T (child2 T)))
(define-fun part3 ((T Tree)) Tree (ite ((_ is leaf) T) T (child3 T)))
(declare-const T Tree)
(declare-const S Tree)
(declare-const p Path)
(assert (meant T p))
(assert (meant S p))
(assert (meant T (rest p)))
(assert (meant S (rest p)))

; Denied:
(assert
  (not
    (and
      (=>
        (and (= (first p) 0) (= (state_at T p) (state_at S p)))
        (= (state_at (part0 T) (rest p)) (state_at (part0 S) (rest p))))
      (=>
        (and (= (first p) 1) (= (state_at T p) (state_at S p)))
        (= (state_at (part1 T) (rest p)) (state_at (part1 S) (rest p))))
      (=>
        (and (= (first p) 2) (= (state_at T p) (state_at S p)))
        (= (state_at (part2 T) (rest p)) (state_at (part2 S) (rest p))))
      (=>
        (and (= (first p) 3) (= (state_at T p) (state_at S p)))
        (= (state_at (part3 T) (rest p)) (state_at (part3 S) (rest p)))))))
(check-sat)
