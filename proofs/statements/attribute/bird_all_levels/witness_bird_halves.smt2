; Not vacuous: some case fulfils what bird_halves supposes.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)
(declare-const N Int)
(assert (<= 1 N))
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j) (<= (+ i j) (* 2 N))))
(define-fun halved () Bool (ite (= (mod i 2) 0) (ite (= (mod j 2) 0) true false) false))
(define-fun halved_at_i () Int (ite (= (mod i 2) 0) (ite (= (mod j 2) 0) (div i 2) i) i))
(define-fun halved_at_j () Int (ite (= (mod i 2) 0) (ite (= (mod j 2) 0) (div j 2) j) j))
(define-fun corner () Int
  (ite (= i 0)
    (ite (= j 0) 0 (ite (= i (* 2 N)) 1 (ite (= j (* 2 N)) 2 3)))
    (ite (= i (* 2 N)) 1 (ite (= j (* 2 N)) 2 3))))
(assert (and halved (< 0 i) (< 0 j)))
(check-sat)
