; Not vacuous: some case fulfils what parent_means_4 supposes.
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
(declare-const P0 Part)
(declare-const P1 Part)
(declare-const P2 Part)
(declare-const P3 Part)

; What is stored for these children has them: it is found by them, or appended.
(declare-const s Int)
(assert (= (child (stored s) 0) P0))
(assert (= (child (stored s) 1) P1))
(assert (= (child (stored s) 2) P2))
(assert (= (child (stored s) 3) P3))

; spec::dag::parent.
(define-fun R () Part
  (ite ((_ is stored) P0)
    (stored s)
    (ite (= P0 P0)
      (ite ((_ is stored) P1)
        (stored s)
        (ite (= P1 P0)
          (ite ((_ is stored) P2)
            (stored s)
            (ite (= P2 P0)
              (ite ((_ is stored) P3) (stored s) (ite (= P3 P0) P0 (stored s)))
              (stored s)))
          (stored s)))
      (stored s))))

; A map of states, and its part below a digit.
(declare-sort Map 0)
(declare-fun state_at (Map Path) State)
(declare-fun below (Map Int) Map)
(declare-const M Map)
(declare-const p Path)
(assert (= (state_at M p) (state_at (below M (first p)) (rest p))))
(assert (meant R p))

; Supposed of each child.
(assert (meant P0 (rest p)))
(assert (= (means P0 (rest p)) (state_at (below M 0) (rest p))))
(assert (meant P1 (rest p)))
(assert (= (means P1 (rest p)) (state_at (below M 1) (rest p))))
(assert (meant P2 (rest p)))
(assert (= (means P2 (rest p)) (state_at (below M 2) (rest p))))
(assert (meant P3 (rest p)))
(assert (= (means P3 (rest p)) (state_at (below M 3) (rest p))))
(assert (and (and (<= 0 (first p)) (< (first p) 4)) ((_ is stored) R)))
(check-sat)
