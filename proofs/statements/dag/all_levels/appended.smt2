; What was stored before something was appended means what it meant.
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

; The graph before: what was stored under numbers below `size`, which is there still.
(declare-const size Int)
(declare-fun child_before (Int Int) Part)
(declare-fun means_before (Part Path) State)
(define-fun meant_before ((A Part) (p Path)) Bool
  (= (means_before A p)
     (ite ((_ is one) A) (state A) (means_before (child_before (number A) (first p)) (rest p)))))
(define-fun there ((A Part)) Bool (or ((_ is one) A) (< (number A) size)))
; The induction's statement.
(define-fun stays ((A Part) (p Path)) Bool (=> (there A) (= (means A p) (means_before A p))))
(declare-const A Part)
(declare-const p Path)
(assert (meant A p))
(assert (meant_before A p))

; Nothing that is there changes, and children were stored before what has them.
(assert
  (=> (and ((_ is stored) A) (there A)) (= (child A (first p)) (child_before (number A) (first p)))))
(assert
  (=>
    (and (and ((_ is stored) A) (there A)) ((_ is stored) (child_before (number A) (first p))))
    (< (number (child_before (number A) (first p))) (number A))))

; Supposed of the child.
(assert (stays (child_before (number A) (first p)) (rest p)))

; Denied:
(assert (not (stays A p)))
(check-sat)
