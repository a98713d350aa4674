; Not vacuous: some case fulfils what canonical_64 supposes.
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
        (and (not ((_ is stored) (child A 15))) (= (child A 15) (child A 0)))
        (and (not ((_ is stored) (child A 16))) (= (child A 16) (child A 0)))
        (and (not ((_ is stored) (child A 17))) (= (child A 17) (child A 0)))
        (and (not ((_ is stored) (child A 18))) (= (child A 18) (child A 0)))
        (and (not ((_ is stored) (child A 19))) (= (child A 19) (child A 0)))
        (and (not ((_ is stored) (child A 20))) (= (child A 20) (child A 0)))
        (and (not ((_ is stored) (child A 21))) (= (child A 21) (child A 0)))
        (and (not ((_ is stored) (child A 22))) (= (child A 22) (child A 0)))
        (and (not ((_ is stored) (child A 23))) (= (child A 23) (child A 0)))
        (and (not ((_ is stored) (child A 24))) (= (child A 24) (child A 0)))
        (and (not ((_ is stored) (child A 25))) (= (child A 25) (child A 0)))
        (and (not ((_ is stored) (child A 26))) (= (child A 26) (child A 0)))
        (and (not ((_ is stored) (child A 27))) (= (child A 27) (child A 0)))
        (and (not ((_ is stored) (child A 28))) (= (child A 28) (child A 0)))
        (and (not ((_ is stored) (child A 29))) (= (child A 29) (child A 0)))
        (and (not ((_ is stored) (child A 30))) (= (child A 30) (child A 0)))
        (and (not ((_ is stored) (child A 31))) (= (child A 31) (child A 0)))
        (and (not ((_ is stored) (child A 32))) (= (child A 32) (child A 0)))
        (and (not ((_ is stored) (child A 33))) (= (child A 33) (child A 0)))
        (and (not ((_ is stored) (child A 34))) (= (child A 34) (child A 0)))
        (and (not ((_ is stored) (child A 35))) (= (child A 35) (child A 0)))
        (and (not ((_ is stored) (child A 36))) (= (child A 36) (child A 0)))
        (and (not ((_ is stored) (child A 37))) (= (child A 37) (child A 0)))
        (and (not ((_ is stored) (child A 38))) (= (child A 38) (child A 0)))
        (and (not ((_ is stored) (child A 39))) (= (child A 39) (child A 0)))
        (and (not ((_ is stored) (child A 40))) (= (child A 40) (child A 0)))
        (and (not ((_ is stored) (child A 41))) (= (child A 41) (child A 0)))
        (and (not ((_ is stored) (child A 42))) (= (child A 42) (child A 0)))
        (and (not ((_ is stored) (child A 43))) (= (child A 43) (child A 0)))
        (and (not ((_ is stored) (child A 44))) (= (child A 44) (child A 0)))
        (and (not ((_ is stored) (child A 45))) (= (child A 45) (child A 0)))
        (and (not ((_ is stored) (child A 46))) (= (child A 46) (child A 0)))
        (and (not ((_ is stored) (child A 47))) (= (child A 47) (child A 0)))
        (and (not ((_ is stored) (child A 48))) (= (child A 48) (child A 0)))
        (and (not ((_ is stored) (child A 49))) (= (child A 49) (child A 0)))
        (and (not ((_ is stored) (child A 50))) (= (child A 50) (child A 0)))
        (and (not ((_ is stored) (child A 51))) (= (child A 51) (child A 0)))
        (and (not ((_ is stored) (child A 52))) (= (child A 52) (child A 0)))
        (and (not ((_ is stored) (child A 53))) (= (child A 53) (child A 0)))
        (and (not ((_ is stored) (child A 54))) (= (child A 54) (child A 0)))
        (and (not ((_ is stored) (child A 55))) (= (child A 55) (child A 0)))
        (and (not ((_ is stored) (child A 56))) (= (child A 56) (child A 0)))
        (and (not ((_ is stored) (child A 57))) (= (child A 57) (child A 0)))
        (and (not ((_ is stored) (child A 58))) (= (child A 58) (child A 0)))
        (and (not ((_ is stored) (child A 59))) (= (child A 59) (child A 0)))
        (and (not ((_ is stored) (child A 60))) (= (child A 60) (child A 0)))
        (and (not ((_ is stored) (child A 61))) (= (child A 61) (child A 0)))
        (and (not ((_ is stored) (child A 62))) (= (child A 62) (child A 0)))
        (and (not ((_ is stored) (child A 63))) (= (child A 63) (child A 0)))))))

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
        (and (not ((_ is stored) (child B 15))) (= (child B 15) (child B 0)))
        (and (not ((_ is stored) (child B 16))) (= (child B 16) (child B 0)))
        (and (not ((_ is stored) (child B 17))) (= (child B 17) (child B 0)))
        (and (not ((_ is stored) (child B 18))) (= (child B 18) (child B 0)))
        (and (not ((_ is stored) (child B 19))) (= (child B 19) (child B 0)))
        (and (not ((_ is stored) (child B 20))) (= (child B 20) (child B 0)))
        (and (not ((_ is stored) (child B 21))) (= (child B 21) (child B 0)))
        (and (not ((_ is stored) (child B 22))) (= (child B 22) (child B 0)))
        (and (not ((_ is stored) (child B 23))) (= (child B 23) (child B 0)))
        (and (not ((_ is stored) (child B 24))) (= (child B 24) (child B 0)))
        (and (not ((_ is stored) (child B 25))) (= (child B 25) (child B 0)))
        (and (not ((_ is stored) (child B 26))) (= (child B 26) (child B 0)))
        (and (not ((_ is stored) (child B 27))) (= (child B 27) (child B 0)))
        (and (not ((_ is stored) (child B 28))) (= (child B 28) (child B 0)))
        (and (not ((_ is stored) (child B 29))) (= (child B 29) (child B 0)))
        (and (not ((_ is stored) (child B 30))) (= (child B 30) (child B 0)))
        (and (not ((_ is stored) (child B 31))) (= (child B 31) (child B 0)))
        (and (not ((_ is stored) (child B 32))) (= (child B 32) (child B 0)))
        (and (not ((_ is stored) (child B 33))) (= (child B 33) (child B 0)))
        (and (not ((_ is stored) (child B 34))) (= (child B 34) (child B 0)))
        (and (not ((_ is stored) (child B 35))) (= (child B 35) (child B 0)))
        (and (not ((_ is stored) (child B 36))) (= (child B 36) (child B 0)))
        (and (not ((_ is stored) (child B 37))) (= (child B 37) (child B 0)))
        (and (not ((_ is stored) (child B 38))) (= (child B 38) (child B 0)))
        (and (not ((_ is stored) (child B 39))) (= (child B 39) (child B 0)))
        (and (not ((_ is stored) (child B 40))) (= (child B 40) (child B 0)))
        (and (not ((_ is stored) (child B 41))) (= (child B 41) (child B 0)))
        (and (not ((_ is stored) (child B 42))) (= (child B 42) (child B 0)))
        (and (not ((_ is stored) (child B 43))) (= (child B 43) (child B 0)))
        (and (not ((_ is stored) (child B 44))) (= (child B 44) (child B 0)))
        (and (not ((_ is stored) (child B 45))) (= (child B 45) (child B 0)))
        (and (not ((_ is stored) (child B 46))) (= (child B 46) (child B 0)))
        (and (not ((_ is stored) (child B 47))) (= (child B 47) (child B 0)))
        (and (not ((_ is stored) (child B 48))) (= (child B 48) (child B 0)))
        (and (not ((_ is stored) (child B 49))) (= (child B 49) (child B 0)))
        (and (not ((_ is stored) (child B 50))) (= (child B 50) (child B 0)))
        (and (not ((_ is stored) (child B 51))) (= (child B 51) (child B 0)))
        (and (not ((_ is stored) (child B 52))) (= (child B 52) (child B 0)))
        (and (not ((_ is stored) (child B 53))) (= (child B 53) (child B 0)))
        (and (not ((_ is stored) (child B 54))) (= (child B 54) (child B 0)))
        (and (not ((_ is stored) (child B 55))) (= (child B 55) (child B 0)))
        (and (not ((_ is stored) (child B 56))) (= (child B 56) (child B 0)))
        (and (not ((_ is stored) (child B 57))) (= (child B 57) (child B 0)))
        (and (not ((_ is stored) (child B 58))) (= (child B 58) (child B 0)))
        (and (not ((_ is stored) (child B 59))) (= (child B 59) (child B 0)))
        (and (not ((_ is stored) (child B 60))) (= (child B 60) (child B 0)))
        (and (not ((_ is stored) (child B 61))) (= (child B 61) (child B 0)))
        (and (not ((_ is stored) (child B 62))) (= (child B 62) (child B 0)))
        (and (not ((_ is stored) (child B 63))) (= (child B 63) (child B 0)))))))

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

; Supposed of each pair of children.
(assert (alike (part A 16) (part B 16)))

; Supposed of each pair of children.
(assert (alike (part A 17) (part B 17)))

; Supposed of each pair of children.
(assert (alike (part A 18) (part B 18)))

; Supposed of each pair of children.
(assert (alike (part A 19) (part B 19)))

; Supposed of each pair of children.
(assert (alike (part A 20) (part B 20)))

; Supposed of each pair of children.
(assert (alike (part A 21) (part B 21)))

; Supposed of each pair of children.
(assert (alike (part A 22) (part B 22)))

; Supposed of each pair of children.
(assert (alike (part A 23) (part B 23)))

; Supposed of each pair of children.
(assert (alike (part A 24) (part B 24)))

; Supposed of each pair of children.
(assert (alike (part A 25) (part B 25)))

; Supposed of each pair of children.
(assert (alike (part A 26) (part B 26)))

; Supposed of each pair of children.
(assert (alike (part A 27) (part B 27)))

; Supposed of each pair of children.
(assert (alike (part A 28) (part B 28)))

; Supposed of each pair of children.
(assert (alike (part A 29) (part B 29)))

; Supposed of each pair of children.
(assert (alike (part A 30) (part B 30)))

; Supposed of each pair of children.
(assert (alike (part A 31) (part B 31)))

; Supposed of each pair of children.
(assert (alike (part A 32) (part B 32)))

; Supposed of each pair of children.
(assert (alike (part A 33) (part B 33)))

; Supposed of each pair of children.
(assert (alike (part A 34) (part B 34)))

; Supposed of each pair of children.
(assert (alike (part A 35) (part B 35)))

; Supposed of each pair of children.
(assert (alike (part A 36) (part B 36)))

; Supposed of each pair of children.
(assert (alike (part A 37) (part B 37)))

; Supposed of each pair of children.
(assert (alike (part A 38) (part B 38)))

; Supposed of each pair of children.
(assert (alike (part A 39) (part B 39)))

; Supposed of each pair of children.
(assert (alike (part A 40) (part B 40)))

; Supposed of each pair of children.
(assert (alike (part A 41) (part B 41)))

; Supposed of each pair of children.
(assert (alike (part A 42) (part B 42)))

; Supposed of each pair of children.
(assert (alike (part A 43) (part B 43)))

; Supposed of each pair of children.
(assert (alike (part A 44) (part B 44)))

; Supposed of each pair of children.
(assert (alike (part A 45) (part B 45)))

; Supposed of each pair of children.
(assert (alike (part A 46) (part B 46)))

; Supposed of each pair of children.
(assert (alike (part A 47) (part B 47)))

; Supposed of each pair of children.
(assert (alike (part A 48) (part B 48)))

; Supposed of each pair of children.
(assert (alike (part A 49) (part B 49)))

; Supposed of each pair of children.
(assert (alike (part A 50) (part B 50)))

; Supposed of each pair of children.
(assert (alike (part A 51) (part B 51)))

; Supposed of each pair of children.
(assert (alike (part A 52) (part B 52)))

; Supposed of each pair of children.
(assert (alike (part A 53) (part B 53)))

; Supposed of each pair of children.
(assert (alike (part A 54) (part B 54)))

; Supposed of each pair of children.
(assert (alike (part A 55) (part B 55)))

; Supposed of each pair of children.
(assert (alike (part A 56) (part B 56)))

; Supposed of each pair of children.
(assert (alike (part A 57) (part B 57)))

; Supposed of each pair of children.
(assert (alike (part A 58) (part B 58)))

; Supposed of each pair of children.
(assert (alike (part A 59) (part B 59)))

; Supposed of each pair of children.
(assert (alike (part A 60) (part B 60)))

; Supposed of each pair of children.
(assert (alike (part A 61) (part B 61)))

; Supposed of each pair of children.
(assert (alike (part A 62) (part B 62)))

; Supposed of each pair of children.
(assert (alike (part A 63) (part B 63)))

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
      (same (part A 15) (part B 15))
      (same (part A 16) (part B 16))
      (same (part A 17) (part B 17))
      (same (part A 18) (part B 18))
      (same (part A 19) (part B 19))
      (same (part A 20) (part B 20))
      (same (part A 21) (part B 21))
      (same (part A 22) (part B 22))
      (same (part A 23) (part B 23))
      (same (part A 24) (part B 24))
      (same (part A 25) (part B 25))
      (same (part A 26) (part B 26))
      (same (part A 27) (part B 27))
      (same (part A 28) (part B 28))
      (same (part A 29) (part B 29))
      (same (part A 30) (part B 30))
      (same (part A 31) (part B 31))
      (same (part A 32) (part B 32))
      (same (part A 33) (part B 33))
      (same (part A 34) (part B 34))
      (same (part A 35) (part B 35))
      (same (part A 36) (part B 36))
      (same (part A 37) (part B 37))
      (same (part A 38) (part B 38))
      (same (part A 39) (part B 39))
      (same (part A 40) (part B 40))
      (same (part A 41) (part B 41))
      (same (part A 42) (part B 42))
      (same (part A 43) (part B 43))
      (same (part A 44) (part B 44))
      (same (part A 45) (part B 45))
      (same (part A 46) (part B 46))
      (same (part A 47) (part B 47))
      (same (part A 48) (part B 48))
      (same (part A 49) (part B 49))
      (same (part A 50) (part B 50))
      (same (part A 51) (part B 51))
      (same (part A 52) (part B 52))
      (same (part A 53) (part B 53))
      (same (part A 54) (part B 54))
      (same (part A 55) (part B 55))
      (same (part A 56) (part B 56))
      (same (part A 57) (part B 57))
      (same (part A 58) (part B 58))
      (same (part A 59) (part B 59))
      (same (part A 60) (part B 60))
      (same (part A 61) (part B 61))
      (same (part A 62) (part B 62))
      (same (part A 63) (part B 63)))))

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
        (= (part A 15) (part B 15))
        (= (part A 16) (part B 16))
        (= (part A 17) (part B 17))
        (= (part A 18) (part B 18))
        (= (part A 19) (part B 19))
        (= (part A 20) (part B 20))
        (= (part A 21) (part B 21))
        (= (part A 22) (part B 22))
        (= (part A 23) (part B 23))
        (= (part A 24) (part B 24))
        (= (part A 25) (part B 25))
        (= (part A 26) (part B 26))
        (= (part A 27) (part B 27))
        (= (part A 28) (part B 28))
        (= (part A 29) (part B 29))
        (= (part A 30) (part B 30))
        (= (part A 31) (part B 31))
        (= (part A 32) (part B 32))
        (= (part A 33) (part B 33))
        (= (part A 34) (part B 34))
        (= (part A 35) (part B 35))
        (= (part A 36) (part B 36))
        (= (part A 37) (part B 37))
        (= (part A 38) (part B 38))
        (= (part A 39) (part B 39))
        (= (part A 40) (part B 40))
        (= (part A 41) (part B 41))
        (= (part A 42) (part B 42))
        (= (part A 43) (part B 43))
        (= (part A 44) (part B 44))
        (= (part A 45) (part B 45))
        (= (part A 46) (part B 46))
        (= (part A 47) (part B 47))
        (= (part A 48) (part B 48))
        (= (part A 49) (part B 49))
        (= (part A 50) (part B 50))
        (= (part A 51) (part B 51))
        (= (part A 52) (part B 52))
        (= (part A 53) (part B 53))
        (= (part A 54) (part B 54))
        (= (part A 55) (part B 55))
        (= (part A 56) (part B 56))
        (= (part A 57) (part B 57))
        (= (part A 58) (part B 58))
        (= (part A 59) (part B 59))
        (= (part A 60) (part B 60))
        (= (part A 61) (part B 61))
        (= (part A 62) (part B 62))
        (= (part A 63) (part B 63))))
    (= A B)))
(assert (and (same A B) ((_ is stored) A)))
(check-sat)
