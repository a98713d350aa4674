; Parts that give a path the same state do so in what is below its first digit: so those that mean
; the same map do in each of 64 children.
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
(define-fun part_a () Bool
  (and (and (<= 0 (first p)) (< (first p) 64)) (= (means A p) (means B p))))
(assert
  (not
    (and
      (=> (and (= (first p) 0) part_a) (= (means (part A 0) (rest p)) (means (part B 0) (rest p))))
      (=> (and (= (first p) 1) part_a) (= (means (part A 1) (rest p)) (means (part B 1) (rest p))))
      (=> (and (= (first p) 2) part_a) (= (means (part A 2) (rest p)) (means (part B 2) (rest p))))
      (=> (and (= (first p) 3) part_a) (= (means (part A 3) (rest p)) (means (part B 3) (rest p))))
      (=> (and (= (first p) 4) part_a) (= (means (part A 4) (rest p)) (means (part B 4) (rest p))))
      (=> (and (= (first p) 5) part_a) (= (means (part A 5) (rest p)) (means (part B 5) (rest p))))
      (=> (and (= (first p) 6) part_a) (= (means (part A 6) (rest p)) (means (part B 6) (rest p))))
      (=> (and (= (first p) 7) part_a) (= (means (part A 7) (rest p)) (means (part B 7) (rest p))))
      (=> (and (= (first p) 8) part_a) (= (means (part A 8) (rest p)) (means (part B 8) (rest p))))
      (=> (and (= (first p) 9) part_a) (= (means (part A 9) (rest p)) (means (part B 9) (rest p))))
      (=>
        (and (= (first p) 10) part_a)
        (= (means (part A 10) (rest p)) (means (part B 10) (rest p))))
      (=>
        (and (= (first p) 11) part_a)
        (= (means (part A 11) (rest p)) (means (part B 11) (rest p))))
      (=>
        (and (= (first p) 12) part_a)
        (= (means (part A 12) (rest p)) (means (part B 12) (rest p))))
      (=>
        (and (= (first p) 13) part_a)
        (= (means (part A 13) (rest p)) (means (part B 13) (rest p))))
      (=>
        (and (= (first p) 14) part_a)
        (= (means (part A 14) (rest p)) (means (part B 14) (rest p))))
      (=>
        (and (= (first p) 15) part_a)
        (= (means (part A 15) (rest p)) (means (part B 15) (rest p))))
      (=>
        (and (= (first p) 16) part_a)
        (= (means (part A 16) (rest p)) (means (part B 16) (rest p))))
      (=>
        (and (= (first p) 17) part_a)
        (= (means (part A 17) (rest p)) (means (part B 17) (rest p))))
      (=>
        (and (= (first p) 18) part_a)
        (= (means (part A 18) (rest p)) (means (part B 18) (rest p))))
      (=>
        (and (= (first p) 19) part_a)
        (= (means (part A 19) (rest p)) (means (part B 19) (rest p))))
      (=>
        (and (= (first p) 20) part_a)
        (= (means (part A 20) (rest p)) (means (part B 20) (rest p))))
      (=>
        (and (= (first p) 21) part_a)
        (= (means (part A 21) (rest p)) (means (part B 21) (rest p))))
      (=>
        (and (= (first p) 22) part_a)
        (= (means (part A 22) (rest p)) (means (part B 22) (rest p))))
      (=>
        (and (= (first p) 23) part_a)
        (= (means (part A 23) (rest p)) (means (part B 23) (rest p))))
      (=>
        (and (= (first p) 24) part_a)
        (= (means (part A 24) (rest p)) (means (part B 24) (rest p))))
      (=>
        (and (= (first p) 25) part_a)
        (= (means (part A 25) (rest p)) (means (part B 25) (rest p))))
      (=>
        (and (= (first p) 26) part_a)
        (= (means (part A 26) (rest p)) (means (part B 26) (rest p))))
      (=>
        (and (= (first p) 27) part_a)
        (= (means (part A 27) (rest p)) (means (part B 27) (rest p))))
      (=>
        (and (= (first p) 28) part_a)
        (= (means (part A 28) (rest p)) (means (part B 28) (rest p))))
      (=>
        (and (= (first p) 29) part_a)
        (= (means (part A 29) (rest p)) (means (part B 29) (rest p))))
      (=>
        (and (= (first p) 30) part_a)
        (= (means (part A 30) (rest p)) (means (part B 30) (rest p))))
      (=>
        (and (= (first p) 31) part_a)
        (= (means (part A 31) (rest p)) (means (part B 31) (rest p))))
      (=>
        (and (= (first p) 32) part_a)
        (= (means (part A 32) (rest p)) (means (part B 32) (rest p))))
      (=>
        (and (= (first p) 33) part_a)
        (= (means (part A 33) (rest p)) (means (part B 33) (rest p))))
      (=>
        (and (= (first p) 34) part_a)
        (= (means (part A 34) (rest p)) (means (part B 34) (rest p))))
      (=>
        (and (= (first p) 35) part_a)
        (= (means (part A 35) (rest p)) (means (part B 35) (rest p))))
      (=>
        (and (= (first p) 36) part_a)
        (= (means (part A 36) (rest p)) (means (part B 36) (rest p))))
      (=>
        (and (= (first p) 37) part_a)
        (= (means (part A 37) (rest p)) (means (part B 37) (rest p))))
      (=>
        (and (= (first p) 38) part_a)
        (= (means (part A 38) (rest p)) (means (part B 38) (rest p))))
      (=>
        (and (= (first p) 39) part_a)
        (= (means (part A 39) (rest p)) (means (part B 39) (rest p))))
      (=>
        (and (= (first p) 40) part_a)
        (= (means (part A 40) (rest p)) (means (part B 40) (rest p))))
      (=>
        (and (= (first p) 41) part_a)
        (= (means (part A 41) (rest p)) (means (part B 41) (rest p))))
      (=>
        (and (= (first p) 42) part_a)
        (= (means (part A 42) (rest p)) (means (part B 42) (rest p))))
      (=>
        (and (= (first p) 43) part_a)
        (= (means (part A 43) (rest p)) (means (part B 43) (rest p))))
      (=>
        (and (= (first p) 44) part_a)
        (= (means (part A 44) (rest p)) (means (part B 44) (rest p))))
      (=>
        (and (= (first p) 45) part_a)
        (= (means (part A 45) (rest p)) (means (part B 45) (rest p))))
      (=>
        (and (= (first p) 46) part_a)
        (= (means (part A 46) (rest p)) (means (part B 46) (rest p))))
      (=>
        (and (= (first p) 47) part_a)
        (= (means (part A 47) (rest p)) (means (part B 47) (rest p))))
      (=>
        (and (= (first p) 48) part_a)
        (= (means (part A 48) (rest p)) (means (part B 48) (rest p))))
      (=>
        (and (= (first p) 49) part_a)
        (= (means (part A 49) (rest p)) (means (part B 49) (rest p))))
      (=>
        (and (= (first p) 50) part_a)
        (= (means (part A 50) (rest p)) (means (part B 50) (rest p))))
      (=>
        (and (= (first p) 51) part_a)
        (= (means (part A 51) (rest p)) (means (part B 51) (rest p))))
      (=>
        (and (= (first p) 52) part_a)
        (= (means (part A 52) (rest p)) (means (part B 52) (rest p))))
      (=>
        (and (= (first p) 53) part_a)
        (= (means (part A 53) (rest p)) (means (part B 53) (rest p))))
      (=>
        (and (= (first p) 54) part_a)
        (= (means (part A 54) (rest p)) (means (part B 54) (rest p))))
      (=>
        (and (= (first p) 55) part_a)
        (= (means (part A 55) (rest p)) (means (part B 55) (rest p))))
      (=>
        (and (= (first p) 56) part_a)
        (= (means (part A 56) (rest p)) (means (part B 56) (rest p))))
      (=>
        (and (= (first p) 57) part_a)
        (= (means (part A 57) (rest p)) (means (part B 57) (rest p))))
      (=>
        (and (= (first p) 58) part_a)
        (= (means (part A 58) (rest p)) (means (part B 58) (rest p))))
      (=>
        (and (= (first p) 59) part_a)
        (= (means (part A 59) (rest p)) (means (part B 59) (rest p))))
      (=>
        (and (= (first p) 60) part_a)
        (= (means (part A 60) (rest p)) (means (part B 60) (rest p))))
      (=>
        (and (= (first p) 61) part_a)
        (= (means (part A 61) (rest p)) (means (part B 61) (rest p))))
      (=>
        (and (= (first p) 62) part_a)
        (= (means (part A 62) (rest p)) (means (part B 62) (rest p))))
      (=>
        (and (= (first p) 63) part_a)
        (= (means (part A 63) (rest p)) (means (part B 63) (rest p)))))))
(check-sat)
