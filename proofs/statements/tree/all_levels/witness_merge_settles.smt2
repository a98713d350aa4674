; Not vacuous: some case fulfils what merge_settles supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; A tree: a leaf with its state, or an internal node with its children.
; A function on trees is declared, and what defines it, one level deep, is a predicate that is asserted
; of the trees in question.
(declare-sort State 0)
(declare-datatypes ((Tree 0)) (((leaf (value State))
                                (node (child0 Tree) (child1 Tree) (child2 Tree) (child3 Tree)))))

; What Algorithm 1 compares of two children: their states; internal nodes have none.
(define-fun same_state ((A Tree) (B Tree)) Bool
  (and (= ((_ is leaf) A) ((_ is leaf) B)) (=> ((_ is leaf) A) (= (value A) (value B)))))

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

; The tree T.
(declare-const A0 Tree)
(declare-const A1 Tree)
(declare-const A2 Tree)
(declare-const A3 Tree)
(define-fun T () Tree (node A0 A1 A2 A3))

; spec::tree::merged.
(define-fun M () Tree
  (ite ((_ is leaf) A0)
    (ite (same_state A0 A1)
      (ite (same_state A0 A2) (ite (same_state A0 A3) (ite ((_ is leaf) A0) A0 T) T) T)
      T)
    T))
(assert (settles M))
(assert (and (and (settled A0) (settled A1) (settled A2) (settled A3)) (not ((_ is leaf) M))))
(check-sat)
