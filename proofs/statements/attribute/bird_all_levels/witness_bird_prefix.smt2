; Not vacuous: some case fulfils what bird_prefix supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const N Int)
(assert (<= 1 N))
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j) (<= (+ i j) N)))
(define-fun here () Int
  (ite (= i 0) (ite (= j 0) 0 (ite (= i N) 1 (ite (= j N) 2 3))) (ite (= i N) 1 (ite (= j N) 2 3))))
(define-fun part_a () Int (ite (= (* 2 i) (* 2 N)) 1 (ite (= (* 2 j) (* 2 N)) 2 3)))
(define-fun next () Int (ite (= (* 2 i) 0) (ite (= (* 2 j) 0) 0 part_a) part_a))
(define-fun halved () Bool (ite (= (mod (* 2 i) 2) 0) (ite (= (mod (* 2 j) 2) 0) true false) false))
(define-fun halved_at_i () Int
  (ite (= (mod (* 2 i) 2) 0) (ite (= (mod (* 2 j) 2) 0) (div (* 2 i) 2) (* 2 i)) (* 2 i)))
(define-fun halved_at_j () Int
  (ite (= (mod (* 2 i) 2) 0) (ite (= (mod (* 2 j) 2) 0) (div (* 2 j) 2) (* 2 j)) (* 2 j)))
(assert (and (< 0 i) (< i j)))
(check-sat)
