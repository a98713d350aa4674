; Not vacuous: some case fulfils what canonical_16 supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; A part of a graph: one state for all of a subtree, or what is stored under a number.  Numbers of tiles and of nodes of
; each level are taken to be different ones.
(declare-sort State 0)
(declare-datatypes ((Part 0)) (((one (state State)) (stored (number Int)))))
(declare-fun child_of (Int Int) Part)
(define-fun child ((A Part) (k Int)) Part (child_of (number A) k))
; The way from a subtree to a micro-triangle: a digit, and the rest.
(declare-sort Path 0)
(declare-fun first (Path) Int)
(declare-fun rest (Path) Path)
; What a part means: the state at the end of each path.
(declare-fun means (Part Path) State)
(define-fun meant ((A Part) (p Path)) Bool
  (= (means A p) (ite ((_ is one) A) (state A) (means (child A (first p)) (rest p)))))

(define-fun part ((A Part) (k Int)) Part (ite ((_ is one) A) A (child A k)))
; A and B mean the same map: means is the same on every path.
(declare-fun same (Part Part) Bool)
; The induction's statement.
(define-fun alike ((A Part) (B Part)) Bool (=> (same A B) (= A B)))
(declare-const A Part)
(declare-const B Part)
(declare-const p Path)

; Of one state both: that of any path.
(assert (meant A p))
(assert (meant B p))
(assert (=> (same A B) (= (means A p) (means B p))))

; What is stored has not one state in all children: parent_settles.
(assert
  (=>
    ((_ is stored) A)
    (not
      (and
        (and (not ((_ is stored) (child A 0))) (= (child A 0) (child A 0)))
        (and (not ((_ is stored) (child A 1))) (= (child A 1) (child A 0)))
        (and (not ((_ is stored) (child A 2))) (= (child A 2) (child A 0)))
        (and (not ((_ is stored) (child A 3))) (= (child A 3) (child A 0)))
        (and (not ((_ is stored) (child A 4))) (= (child A 4) (child A 0)))
        (and (not ((_ is stored) (child A 5))) (= (child A 5) (child A 0)))
        (and (not ((_ is stored) (child A 6))) (= (child A 6) (child A 0)))
        (and (not ((_ is stored) (child A 7))) (= (child A 7) (child A 0)))
        (and (not ((_ is stored) (child A 8))) (= (child A 8) (child A 0)))
        (and (not ((_ is stored) (child A 9))) (= (child A 9) (child A 0)))
        (and (not ((_ is stored) (child A 10))) (= (child A 10) (child A 0)))
        (and (not ((_ is stored) (child A 11))) (= (child A 11) (child A 0)))
        (and (not ((_ is stored) (child A 12))) (= (child A 12) (child A 0)))
        (and (not ((_ is stored) (child A 13))) (= (child A 13) (child A 0)))
        (and (not ((_ is stored) (child A 14))) (= (child A 14) (child A 0)))
        (and (not ((_ is stored) (child A 15))) (= (child A 15) (child A 0)))))))

; What is stored has not one state in all children: parent_settles.
(assert
  (=>
    ((_ is stored) B)
    (not
      (and
        (and (not ((_ is stored) (child B 0))) (= (child B 0) (child B 0)))
        (and (not ((_ is stored) (child B 1))) (= (child B 1) (child B 0)))
        (and (not ((_ is stored) (child B 2))) (= (child B 2) (child B 0)))
        (and (not ((_ is stored) (child B 3))) (= (child B 3) (child B 0)))
        (and (not ((_ is stored) (child B 4))) (= (child B 4) (child B 0)))
        (and (not ((_ is stored) (child B 5))) (= (child B 5) (child B 0)))
        (and (not ((_ is stored) (child B 6))) (= (child B 6) (child B 0)))
        (and (not ((_ is stored) (child B 7))) (= (child B 7) (child B 0)))
        (and (not ((_ is stored) (child B 8))) (= (child B 8) (child B 0)))
        (and (not ((_ is stored) (child B 9))) (= (child B 9) (child B 0)))
        (and (not ((_ is stored) (child B 10))) (= (child B 10) (child B 0)))
        (and (not ((_ is stored) (child B 11))) (= (child B 11) (child B 0)))
        (and (not ((_ is stored) (child B 12))) (= (child B 12) (child B 0)))
        (and (not ((_ is stored) (child B 13))) (= (child B 13) (child B 0)))
        (and (not ((_ is stored) (child B 14))) (= (child B 14) (child B 0)))
        (and (not ((_ is stored) (child B 15))) (= (child B 15) (child B 0)))))))

; Supposed of each pair of children.
(assert (alike (part A 0) (part B 0)))

; Supposed of each pair of children.
(assert (alike (part A 1) (part B 1)))

; Supposed of each pair of children.
(assert (alike (part A 2) (part B 2)))

; Supposed of each pair of children.
(assert (alike (part A 3) (part B 3)))

; Supposed of each pair of children.
(assert (alike (part A 4) (part B 4)))

; Supposed of each pair of children.
(assert (alike (part A 5) (part B 5)))

; Supposed of each pair of children.
(assert (alike (part A 6) (part B 6)))

; Supposed of each pair of children.
(assert (alike (part A 7) (part B 7)))

; Supposed of each pair of children.
(assert (alike (part A 8) (part B 8)))

; Supposed of each pair of children.
(assert (alike (part A 9) (part B 9)))

; Supposed of each pair of children.
(assert (alike (part A 10) (part B 10)))

; Supposed of each pair of children.
(assert (alike (part A 11) (part B 11)))

; Supposed of each pair of children.
(assert (alike (part A 12) (part B 12)))

; Supposed of each pair of children.
(assert (alike (part A 13) (part B 13)))

; Supposed of each pair of children.
(assert (alike (part A 14) (part B 14)))

; Supposed of each pair of children.
(assert (alike (part A 15) (part B 15)))

; By same_in_children, where one of them has children.
(assert
  (=>
    (and (same A B) (not (and (not ((_ is stored) A)) (not ((_ is stored) B)))))
    (and
      (same (part A 0) (part B 0))
      (same (part A 1) (part B 1))
      (same (part A 2) (part B 2))
      (same (part A 3) (part B 3))
      (same (part A 4) (part B 4))
      (same (part A 5) (part B 5))
      (same (part A 6) (part B 6))
      (same (part A 7) (part B 7))
      (same (part A 8) (part B 8))
      (same (part A 9) (part B 9))
      (same (part A 10) (part B 10))
      (same (part A 11) (part B 11))
      (same (part A 12) (part B 12))
      (same (part A 13) (part B 13))
      (same (part A 14) (part B 14))
      (same (part A 15) (part B 15)))))

; No two that are stored have the same children: they are found by them.
(assert
  (=>
    (and
      ((_ is stored) A)
      ((_ is stored) B)
      (and
        (= (part A 0) (part B 0))
        (= (part A 1) (part B 1))
        (= (part A 2) (part B 2))
        (= (part A 3) (part B 3))
        (= (part A 4) (part B 4))
        (= (part A 5) (part B 5))
        (= (part A 6) (part B 6))
        (= (part A 7) (part B 7))
        (= (part A 8) (part B 8))
        (= (part A 9) (part B 9))
        (= (part A 10) (part B 10))
        (= (part A 11) (part B 11))
        (= (part A 12) (part B 12))
        (= (part A 13) (part B 13))
        (= (part A 14) (part B 14))
        (= (part A 15) (part B 15))))
    (= A B)))
(assert (and (same A B) ((_ is stored) A)))
(check-sat)
