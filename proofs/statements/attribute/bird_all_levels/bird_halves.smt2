; What a halving leaves is a vertex of the level before, and the vertex is twice that.  A corner of
; 2N to a side is halved, too: what is not halved is no corner.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
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

; Denied:
(assert
  (not
    (and
      (=>
        halved
        (and
          (and (<= 0 halved_at_i) (<= 0 halved_at_j) (<= (+ halved_at_i halved_at_j) N))
          (and (= i (* 2 halved_at_i)) (= j (* 2 halved_at_j)))))
      (=> (< corner 3) halved))))
(check-sat)
