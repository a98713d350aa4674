; From the root of a node, tree-lookup goes to the child of the next digit, and finds the state that
; the node means below the path.
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

; What tree-lookup returns from (t, d) on, its digits being those of p.
(declare-fun lookup (Int Int Path) State)
; The induction's statement: from where T stands, tree-lookup finds the state that T means.
(define-fun finds ((T Tree) (t Int) (d Int) (p Path)) Bool
  (=> (stands T t d) (= (lookup t d p) (state_at T p))))

; The tree T.
(declare-const A0 Tree)
(declare-const A1 Tree)
(declare-const A2 Tree)
(declare-const A3 Tree)
(define-fun T () Tree (node A0 A1 A2 A3))
(declare-const t Int)
(declare-const d Int)
(declare-const p Path)
(assert (placed T t d))
(assert (meant T p))

; One turn from there, its digit being the path's first: spec::tree::lookup_turn.
(assert
  (=
    (lookup t d p)
    (ite (internal t)
      (lookup (bit (bitscan (first p) (+ t 1) d)) (datum (bitscan (first p) (+ t 1) d)) (rest p))
      (data d))))

; bitscan passes over the children before (skip_leaf, skip_node) and ends.
(assert (passes A0 (first p) (+ t 1) d))
(assert
  (=
    (bitscan (first p) (+ t 1) d)
    (ite (< (+ t 1) size)
      (ite (< 0 (first p))
        (ite (internal (+ t 1))
          (bitscan (- (+ (first p) 4) 1) (+ (+ t 1) 1) d)
          (bitscan (- (first p) 1) (+ (+ t 1) 1) (+ d 1)))
        (place (+ t 1) d))
      (place (+ t 1) d))))
(assert (passes A1 (- (first p) 1) (+ (+ t 1) (nodes A0)) (+ d (leaves A0))))
(define-fun part_a () Place (place (+ (+ t 1) (nodes A0)) (+ d (leaves A0))))
(assert
  (=
    (bitscan (- (first p) 1) (+ (+ t 1) (nodes A0)) (+ d (leaves A0)))
    (ite (< (+ (+ t 1) (nodes A0)) size)
      (ite (< 0 (- (first p) 1))
        (ite (internal (+ (+ t 1) (nodes A0)))
          (bitscan (- (+ (- (first p) 1) 4) 1) (+ (+ (+ t 1) (nodes A0)) 1) (+ d (leaves A0)))
          (bitscan (- (- (first p) 1) 1) (+ (+ (+ t 1) (nodes A0)) 1) (+ (+ d (leaves A0)) 1)))
        part_a)
      part_a)))
(assert
  (passes
    A2
    (- (first p) 2)
    (+ (+ (+ t 1) (nodes A0)) (nodes A1))
    (+ (+ d (leaves A0)) (leaves A1))))
(define-fun part_b () Place
  (place (+ (+ (+ t 1) (nodes A0)) (nodes A1)) (+ (+ d (leaves A0)) (leaves A1))))
(assert
  (=
    (bitscan
      (- (first p) 2)
      (+ (+ (+ t 1) (nodes A0)) (nodes A1))
      (+ (+ d (leaves A0)) (leaves A1)))
    (ite (< (+ (+ (+ t 1) (nodes A0)) (nodes A1)) size)
      (ite (< 0 (- (first p) 2))
        (ite (internal (+ (+ (+ t 1) (nodes A0)) (nodes A1)))
          (bitscan
            (- (+ (- (first p) 2) 4) 1)
            (+ (+ (+ (+ t 1) (nodes A0)) (nodes A1)) 1)
            (+ (+ d (leaves A0)) (leaves A1)))
          (bitscan
            (- (- (first p) 2) 1)
            (+ (+ (+ (+ t 1) (nodes A0)) (nodes A1)) 1)
            (+ (+ (+ d (leaves A0)) (leaves A1)) 1)))
        part_b)
      part_b)))
(define-fun part_c () Int (+ (+ (+ (+ t 1) (nodes A0)) (nodes A1)) (nodes A2)))
(define-fun part_d () Int (+ (+ (+ d (leaves A0)) (leaves A1)) (leaves A2)))
(define-fun part_e () Int (+ part_c 1))
(define-fun part_f () Place (place part_c part_d))
(assert
  (=
    (bitscan (- (first p) 3) part_c part_d)
    (ite (< part_c size)
      (ite (< 0 (- (first p) 3))
        (ite (internal part_c)
          (bitscan (- (+ (- (first p) 3) 4) 1) part_e part_d)
          (bitscan (- (- (first p) 3) 1) part_e (+ part_d 1)))
        part_f)
      part_f)))

; Supposed of each child, where it stands.
(assert (finds A0 (+ t 1) d (rest p)))
(assert (finds A1 (+ (+ t 1) (nodes A0)) (+ d (leaves A0)) (rest p)))
(assert (finds A2 (+ (+ (+ t 1) (nodes A0)) (nodes A1)) (+ (+ d (leaves A0)) (leaves A1)) (rest p)))
(assert (finds A3 part_c part_d (rest p)))

; Denied:
(assert (not (finds T t d p)))
(check-sat)
