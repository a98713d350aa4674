; Not vacuous: some case fulfils what same_in_children_64 supposes.
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
(assert (meant A p))
(assert (meant B p))
(assert (meant A (rest p)))
(assert (meant B (rest p)))
(assert
  (and (and (and (<= 0 (first p)) (< (first p) 64)) (= (means A p) (means B p))) ((_ is stored) A)))
(check-sat)
