; A vertex with 2M to a side that is not halved is the middle of one edge of one upright
; micro-triangle with M to a side, and the way back leads to it.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const M Int)
(assert (<= 1 M))
(declare-const i Int)
(declare-const j Int)
(assert (and (<= 0 i) (<= 0 j) (<= (+ i j) (* 2 M))))
(define-fun halved () Bool (ite (= (mod i 2) 0) (ite (= (mod j 2) 0) true false) false))
(define-fun halved_at_i () Int (ite (= (mod i 2) 0) (ite (= (mod j 2) 0) (div i 2) i) i))
(define-fun halved_at_j () Int (ite (= (mod i 2) 0) (ite (= (mod j 2) 0) (div j 2) j) j))
(assert (not halved))
(define-fun on_iu () Int (div i 2))
(define-fun on_iv () Int (div j 2))
(define-fun on_edge () Int (ite (= (mod i 2) 0) 0 (ite (= (mod j 2) 0) 2 1)))
(define-fun back_i () Int (ite (= on_edge 0) (* 2 on_iu) (+ (* 2 on_iu) 1)))
(define-fun back_j () Int (ite (= on_edge 2) (* 2 on_iv) (+ (* 2 on_iv) 1)))

; Denied:
(assert
  (not
    (and
      (and (<= 0 on_iu) (<= 0 on_iv) (< (+ on_iu on_iv) M) (and (<= 0 on_edge) (< on_edge 3)))
      (and (= back_i i) (= back_j j)))))
(check-sat)
