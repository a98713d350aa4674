; From a part of one state a lookup ends with the state that it means.
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

; What a lookup from a part finds, its digits being those of p.
(declare-fun lookup (Part Path) State)
(define-fun finds ((A Part) (p Path)) Bool (= (lookup A p) (means A p)))
(declare-const A Part)
(declare-const p Path)
(assert (not ((_ is stored) A)))
(assert (meant A p))

; One turn from there, its digit being the path's first: spec::dag::lookup_turn.
(assert (= (lookup A p) (ite ((_ is stored) A) (lookup (child A (first p)) (rest p)) (state A))))

; Denied:
(assert (not (finds A p)))
(check-sat)
