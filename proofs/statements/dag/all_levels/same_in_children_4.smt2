; Parts that give a path the same state do so in what is below its first digit: so those that mean
; the same map do in each of 4 children.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)

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
(assert (meant A p))
(assert (meant B p))
(assert (meant A (rest p)))
(assert (meant B (rest p)))

; Denied:
(define-fun part_a () Bool (and (and (<= 0 (first p)) (< (first p) 4)) (= (means A p) (means B p))))
(assert
  (not
    (and
      (=> (and (= (first p) 0) part_a) (= (means (part A 0) (rest p)) (means (part B 0) (rest p))))
      (=> (and (= (first p) 1) part_a) (= (means (part A 1) (rest p)) (means (part B 1) (rest p))))
      (=> (and (= (first p) 2) part_a) (= (means (part A 2) (rest p)) (means (part B 2) (rest p))))
      (=> (and (= (first p) 3) part_a) (= (means (part A 3) (rest p)) (means (part B 3) (rest p)))))))
(check-sat)
