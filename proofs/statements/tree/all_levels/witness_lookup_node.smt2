; Not vacuous: some case fulfils what lookup_node supposes.
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

; Where the children stand.
(define-fun t0 () Int (+ t 1))
(define-fun d0 () Int d)
(define-fun t1 () Int (+ t0 (nodes A0)))
(define-fun d1 () Int (+ d0 (leaves A0)))
(define-fun t2 () Int (+ t1 (nodes A1)))
(define-fun d2 () Int (+ d1 (leaves A1)))
(define-fun t3 () Int (+ t2 (nodes A2)))
(define-fun d3 () Int (+ d2 (leaves A2)))

; bitscan passes over the children before (skip_leaf, skip_node) and ends.
(assert (passes A0 (first p) t0 d0))
(assert
  (=
    (bitscan (first p) t0 d0)
    (ite (< t0 size)
      (ite (< 0 (first p))
        (ite (internal t0)
          (bitscan (- (+ (first p) 4) 1) (+ t0 1) d0)
          (bitscan (- (first p) 1) (+ t0 1) (+ d0 1)))
        (place t0 d0))
      (place t0 d0))))
(assert (passes A1 (- (first p) 1) t1 d1))
(assert
  (=
    (bitscan (- (first p) 1) t1 d1)
    (ite (< t1 size)
      (ite (< 0 (- (first p) 1))
        (ite (internal t1)
          (bitscan (- (+ (- (first p) 1) 4) 1) (+ t1 1) d1)
          (bitscan (- (- (first p) 1) 1) (+ t1 1) (+ d1 1)))
        (place t1 d1))
      (place t1 d1))))
(assert (passes A2 (- (first p) 2) t2 d2))
(assert
  (=
    (bitscan (- (first p) 2) t2 d2)
    (ite (< t2 size)
      (ite (< 0 (- (first p) 2))
        (ite (internal t2)
          (bitscan (- (+ (- (first p) 2) 4) 1) (+ t2 1) d2)
          (bitscan (- (- (first p) 2) 1) (+ t2 1) (+ d2 1)))
        (place t2 d2))
      (place t2 d2))))
(assert
  (=
    (bitscan (- (first p) 3) t3 d3)
    (ite (< t3 size)
      (ite (< 0 (- (first p) 3))
        (ite (internal t3)
          (bitscan (- (+ (- (first p) 3) 4) 1) (+ t3 1) d3)
          (bitscan (- (- (first p) 3) 1) (+ t3 1) (+ d3 1)))
        (place t3 d3))
      (place t3 d3))))

; Supposed of each child, where it stands.
(assert (finds A0 t0 d0 (rest p)))
(assert (finds A1 t1 d1 (rest p)))
(assert (finds A2 t2 d2 (rest p)))
(assert (finds A3 t3 d3 (rest p)))
(assert (stands T t d))
(check-sat)
