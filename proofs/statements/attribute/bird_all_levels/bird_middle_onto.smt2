; The middle of each of the three edges of each upright micro-triangle is a vertex with 2M to a side
; that is not halved, and no other edge's.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const M Int)
(assert (<= 1 M))
(declare-const iu Int)
(declare-const iv Int)
(declare-const edge Int)
(assert (and (<= 0 iu) (<= 0 iv) (< (+ iu iv) M) (and (<= 0 edge) (< edge 3))))
(define-fun at_i () Int (ite (= edge 0) (* 2 iu) (+ (* 2 iu) 1)))
(define-fun at_j () Int (ite (= edge 2) (* 2 iv) (+ (* 2 iv) 1)))
(define-fun halved () Bool (ite (= (mod at_i 2) 0) (ite (= (mod at_j 2) 0) true false) false))
(define-fun halved_at_i () Int
  (ite (= (mod at_i 2) 0) (ite (= (mod at_j 2) 0) (div at_i 2) at_i) at_i))
(define-fun halved_at_j () Int
  (ite (= (mod at_i 2) 0) (ite (= (mod at_j 2) 0) (div at_j 2) at_j) at_j))
(define-fun back_iu () Int (div at_i 2))
(define-fun back_iv () Int (div at_j 2))
(define-fun back_edge () Int (ite (= (mod at_i 2) 0) 0 (ite (= (mod at_j 2) 0) 2 1)))

; Denied:
(assert
  (not
    (and
      (and (<= 0 at_i) (<= 0 at_j) (<= (+ at_i at_j) (* 2 M)))
      (not halved)
      (= back_iu iu)
      (= back_iv iv)
      (= back_edge edge))))
(check-sat)
