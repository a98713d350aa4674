; Where graphs take no more than their maps flat and 64 bits for each, so they do with a map more.
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

; Bits before and after; 32 times so many words that tiles and nodes would grow by; the map's words
; flat;

; what flat grows by where it is laid there, none where it is there.
(declare-const before Int)
(declare-const most Int)
(declare-const grown Int)
(declare-const flat Int)
(declare-const laid Int)
(assert (<= 0 grown))
(assert (<= 0 laid))
(assert (<= laid flat))

; spec::dag::kept.
(define-fun after () Int (+ before 64 (* 32 (ite (< flat grown) laid grown))))

; Denied:
(assert (not (=> (<= before most) (<= after (+ most 64 (* 32 flat))))))
(check-sat)
