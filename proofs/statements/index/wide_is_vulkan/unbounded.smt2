; For every N up to 2^31 and all iu, iv in [0, N]: spec::index::grid_square in 64-bit words, written
; as integers modulo 2^64, has the iu and iv of integers without bounds; its iw is 2^64 more than
; theirs, which is negative.
; So the low n bits, N = 2^n, are the same.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status unsat)
(declare-const N Int)
(declare-const iu Int)
(declare-const iv Int)
(declare-const upper_half Bool)
(assert (and (<= 1 N) (<= N 2147483648)))
(assert (and (<= 0 iu) (<= iu N)))
(assert (and (<= 0 iv) (<= iv N)))

; Without bounds.
(define-fun free_iu () Int
  (ite (< iu N)
    (ite (< iv N)
      (ite (< (+ iu iv) N) iu (- iu (+ (- (+ iu iv) N) 1)))
      (ite (< (+ iu (- N 1)) N) iu (- iu (+ (- (+ iu (- N 1)) N) 1))))
    (ite (< iv N)
      (ite (< (+ (- N 1) iv) N) (- N 1) (- (- N 1) (+ (- (+ (- N 1) iv) N) 1)))
      (ite (< (+ (- N 1) (- N 1)) N) (- N 1) (- (- N 1) (+ (- (+ (- N 1) (- N 1)) N) 1))))))
(define-fun free_iv () Int (ite (< iv N) iv (- N 1)))
(define-fun part_a () Int (- (- (+ (- iu (+ (- (+ iu (- N 1)) N) 1)) (- N 1))) 1))
(define-fun part_b () Int (- (- (+ (- (- N 1) (+ (- (+ (- N 1) iv) N) 1)) iv)) 1))
(define-fun part_c () Int (- (- (+ (- (- N 1) (+ (- (+ (- N 1) (- N 1)) N) 1)) (- N 1))) 1))
(define-fun free_iw () Int
  (ite upper_half
    (ite (< iu N)
      (ite (< iv N)
        (ite (< (+ iu iv) N)
          (ite (< (+ iu iv) (- N 1)) (- (- (- (+ iu iv)) 1) 1) (- (- (+ iu iv)) 1))
          (ite (< (+ iu iv) (- N 1))
            (- (- (- (+ (- iu (+ (- (+ iu iv) N) 1)) iv)) 1) 1)
            (- (- (+ (- iu (+ (- (+ iu iv) N) 1)) iv)) 1)))
        (ite (< (+ iu (- N 1)) N)
          (ite (< (+ iu (- N 1)) (- N 1)) (- (- (- (+ iu (- N 1))) 1) 1) (- (- (+ iu (- N 1))) 1))
          (ite (< (+ iu (- N 1)) (- N 1)) (- part_a 1) part_a)))
      (ite (< iv N)
        (ite (< (+ (- N 1) iv) N)
          (ite (< (+ (- N 1) iv) (- N 1)) (- (- (- (+ (- N 1) iv)) 1) 1) (- (- (+ (- N 1) iv)) 1))
          (ite (< (+ (- N 1) iv) (- N 1)) (- part_b 1) part_b))
        (ite (< (+ (- N 1) (- N 1)) N)
          (ite (< (+ (- N 1) (- N 1)) (- N 1))
            (- (- (- (+ (- N 1) (- N 1))) 1) 1)
            (- (- (+ (- N 1) (- N 1))) 1))
          (ite (< (+ (- N 1) (- N 1)) (- N 1)) (- part_c 1) part_c))))
    (ite (< iu N)
      (ite (< iv N)
        (ite (< (+ iu iv) N) (- (- (+ iu iv)) 1) (- (- (+ (- iu (+ (- (+ iu iv) N) 1)) iv)) 1))
        (ite (< (+ iu (- N 1)) N) (- (- (+ iu (- N 1))) 1) part_a))
      (ite (< iv N)
        (ite (< (+ (- N 1) iv) N) (- (- (+ (- N 1) iv)) 1) part_b)
        (ite (< (+ (- N 1) (- N 1)) N) (- (- (+ (- N 1) (- N 1))) 1) part_c)))))

; Modulo 2^64.
(define-fun part_d () Int (mod (+ iu (mod (- N 1) 18446744073709551616)) 18446744073709551616))
(define-fun part_e () Int (mod (+ (mod (- N 1) 18446744073709551616) iv) 18446744073709551616))
(define-fun part_f () Int
  (mod
    (+ (mod (- N 1) 18446744073709551616) (mod (- N 1) 18446744073709551616))
    18446744073709551616))
(define-fun wide_iu () Int
  (ite (< iu N)
    (ite (< iv N)
      (ite (< (mod (+ iu iv) 18446744073709551616) N)
        iu
        (mod
          (-
            iu
            (mod
              (+ (mod (- (mod (+ iu iv) 18446744073709551616) N) 18446744073709551616) 1)
              18446744073709551616))
          18446744073709551616))
      (ite (< part_d N)
        iu
        (mod
          (- iu (mod (+ (mod (- part_d N) 18446744073709551616) 1) 18446744073709551616))
          18446744073709551616)))
    (ite (< iv N)
      (ite (< part_e N)
        (mod (- N 1) 18446744073709551616)
        (mod
          (-
            (mod (- N 1) 18446744073709551616)
            (mod (+ (mod (- part_e N) 18446744073709551616) 1) 18446744073709551616))
          18446744073709551616))
      (ite (< part_f N)
        (mod (- N 1) 18446744073709551616)
        (mod
          (-
            (mod (- N 1) 18446744073709551616)
            (mod (+ (mod (- part_f N) 18446744073709551616) 1) 18446744073709551616))
          18446744073709551616)))))
(define-fun wide_iv () Int (ite (< iv N) iv (mod (- N 1) 18446744073709551616)))
(define-fun part_g () Bool
  (< (mod (+ iu iv) 18446744073709551616) (mod (- N 1) 18446744073709551616)))
(define-fun part_h () Int (mod (- (- (mod (+ iu iv) 18446744073709551616)) 1) 18446744073709551616))
(define-fun part_i () Int
  (mod
    (-
      (-
        (mod
          (+
            (mod
              (-
                iu
                (mod
                  (+ (mod (- (mod (+ iu iv) 18446744073709551616) N) 18446744073709551616) 1)
                  18446744073709551616))
              18446744073709551616)
            iv)
          18446744073709551616))
      1)
    18446744073709551616))
(define-fun part_j () Bool (< part_d N))
(define-fun part_k () Bool (< part_d (mod (- N 1) 18446744073709551616)))
(define-fun part_l () Int (mod (- (- part_d) 1) 18446744073709551616))
(define-fun part_m () Int
  (mod
    (-
      (-
        (mod
          (+
            (mod
              (- iu (mod (+ (mod (- part_d N) 18446744073709551616) 1) 18446744073709551616))
              18446744073709551616)
            (mod (- N 1) 18446744073709551616))
          18446744073709551616))
      1)
    18446744073709551616))
(define-fun part_n () Bool (< part_e N))
(define-fun part_o () Bool (< part_e (mod (- N 1) 18446744073709551616)))
(define-fun part_p () Int (mod (- (- part_e) 1) 18446744073709551616))
(define-fun part_q () Int
  (mod
    (-
      (-
        (mod
          (+
            (mod
              (-
                (mod (- N 1) 18446744073709551616)
                (mod (+ (mod (- part_e N) 18446744073709551616) 1) 18446744073709551616))
              18446744073709551616)
            iv)
          18446744073709551616))
      1)
    18446744073709551616))
(define-fun part_r () Bool (< part_f N))
(define-fun part_s () Bool (< part_f (mod (- N 1) 18446744073709551616)))
(define-fun part_t () Int (mod (- (- part_f) 1) 18446744073709551616))
(define-fun part_u () Int
  (mod
    (-
      (-
        (mod
          (+
            (mod
              (-
                (mod (- N 1) 18446744073709551616)
                (mod (+ (mod (- part_f N) 18446744073709551616) 1) 18446744073709551616))
              18446744073709551616)
            (mod (- N 1) 18446744073709551616))
          18446744073709551616))
      1)
    18446744073709551616))
(define-fun wide_iw () Int
  (ite upper_half
    (ite (< iu N)
      (ite (< iv N)
        (ite (< (mod (+ iu iv) 18446744073709551616) N)
          (ite part_g (mod (- part_h 1) 18446744073709551616) part_h)
          (ite part_g (mod (- part_i 1) 18446744073709551616) part_i))
        (ite part_j
          (ite part_k (mod (- part_l 1) 18446744073709551616) part_l)
          (ite part_k (mod (- part_m 1) 18446744073709551616) part_m)))
      (ite (< iv N)
        (ite part_n
          (ite part_o (mod (- part_p 1) 18446744073709551616) part_p)
          (ite part_o (mod (- part_q 1) 18446744073709551616) part_q))
        (ite part_r
          (ite part_s (mod (- part_t 1) 18446744073709551616) part_t)
          (ite part_s (mod (- part_u 1) 18446744073709551616) part_u))))
    (ite (< iu N)
      (ite (< iv N)
        (ite (< (mod (+ iu iv) 18446744073709551616) N) part_h part_i)
        (ite part_j part_l part_m))
      (ite (< iv N) (ite part_n part_p part_q) (ite part_r part_t part_u)))))

; Denied: they are the same, as said.
(assert
  (not (and (= wide_iu free_iu) (= wide_iv free_iv) (= wide_iw (+ free_iw 18446744073709551616)))))
(check-sat)
