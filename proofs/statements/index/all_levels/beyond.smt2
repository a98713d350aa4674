; At the places above the highest of a level, where iu and iv (below M) and the mask have no bit,
; whatever iw has there: spec::index::curve_bits gives 0 and 0, and t is 0. So the index has no
; digit there, and the prefix XOR begins with nothing.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const bw Bool)
(define-fun b0 () Bool (and (not (xor false bw)) false))
(define-fun part_a () Bool (and (xor false false) b0))
(define-fun b1 () Bool (or (and (xor (xor false part_a) false) (not b0)) part_a))
(assert (not (and (not b0) (not b1) (not part_a))))
(check-sat)
