(* The index of opacity micromaps: what the theorems of Theorems.v speak of.  Nothing is proved here.

   Read this file beside its sources: Succinct Opacity Micromaps (section 4.3, Algorithm 4), and the reference code in
   the appendix of VK_EXT_opacity_micromap.  spec/index/index.hpp has the same definitions in C++; scripts/check-coq
   compares what the two compute on every cell of levels 0 to 6.

   How to read it without knowing Coq:
     Z, Q, nat, bool   whole numbers of any size, rational numbers, 0 1 2 ..., true and false: no floats, no overflow
     Definition f (x : Z) : Z := e.     f is a function from Z to Z; f x is e
     Fixpoint f (n : nat) ... := e.     the same by recursion on n: `match n with O => a | S m => b end` is a where n is
                                        0, and b where n is m+1; b may ask for f m
     let x := a in b                    a has the name x in b; a later `let x` shadows an earlier one
     f a b                              f applied to a and b; (a, b) is a pair
     (e)%Q, (e)%Z                       the signs + - * <= ... in e are those of rationals, of whole numbers
     1 # 2                              the fraction 1/2
     2 ^ n, a / b, a mod b              on Z: power, floor(a/b), the remainder, 0 <= a mod b < b where b > 0
     && || negb xorb                    and, or, not, exclusive or *)
From Coq Require Export Bool ZArith QArith Qround.
Open Scope Z_scope.

(* Comparisons of rationals that a program can branch on: their value is true or false. *)
Notation "x >? y" := (negb (Qle_bool x y)) : Q_scope.
Notation "x >=? y" := (Qle_bool y x) : Q_scope.
Notation "x =? y" := (Qeq_bool x y) : Q_scope.

(* A point of the closed base triangle.  Barycentrics are (u, v, w), w = 1-u-v: u and v belong to the second and third
   vertex, w to the first. *)
Definition in_triangle (u v : Q) : Prop := (0 <= u /\ 0 <= v /\ u + v <= 1)%Q.

(* N: the micro-triangles along a side at a level; the level has 4^level of them. *)
Definition side (level : nat) : Z := 2 ^ Z.of_nat level.

(* ---------------------------------------------------------------------------------------------------------------------
   Algorithm 4 of Succinct Opacity Micromaps
   ------------------------------------------------------------------------------------------------------------------ *)

Definition half : Q := 1 # 2.

(* The paper's recursive function `step`.  `levels` is what it writes level - depth: the steps still to come.  Qred q is
   the number q, its fraction in lowest terms, so that the computer has less to multiply.
   The paper:
     if top-flip then L, M, R, T = 2, 1, 0, 3 else L, M, R, T = 0, 1, 2, 3
     if w > 0.5                                        step(2u, 2v, w-u-v, 4 index + L, mid-flip, top-flip)
     else if v >= 0.5 and not (v = 0.5 and mid-flip)   step(2u, v-u-w, 2w, 4 index + T, mid-flip, not top-flip)
     else if u >= 0.5 and not (v = 0.5 and mid-flip)   step(u-v-w, 2v, 2w, 4 index + R, mid-flip, top-flip)
     else                                              step(u+v-w, w+u-v, v+w-u, 4 index + M, not mid-flip, top-flip) *)
Fixpoint step (levels : nat) (u v w : Q) (index : Z) (mid_flip top_flip : bool) : Z :=
  match levels with
  | O => index
  | S levels =>
      let u := Qred u in let v := Qred v in let w := Qred w in
      let '(L, M, R, T) := if top_flip then (2, 1, 0, 3) else (0, 1, 2, 3) in
      if (w >? half)%Q
      then step levels (2 * u)%Q (2 * v)%Q (w - u - v)%Q (4 * index + L) mid_flip top_flip
      else if (v >=? half)%Q && negb ((v =? half)%Q && mid_flip)
      then step levels (2 * u)%Q (v - u - w)%Q (2 * w)%Q (4 * index + T) mid_flip (negb top_flip)
      else if (u >=? half)%Q && negb ((v =? half)%Q && mid_flip)
      then step levels (u - v - w)%Q (2 * v)%Q (2 * w)%Q (4 * index + R) mid_flip top_flip
      else step levels (u + v - w)%Q (w + u - v)%Q (v + w - u)%Q (4 * index + M) (negb mid_flip) top_flip
  end.

(* uv2index(u, v, level): w = 1-u-v; step(u, v, w, 0, false, false). *)
Definition uv2index (u v : Q) (level : nat) : Z := step level u v (1 - u - v)%Q 0 false false.

(* ---------------------------------------------------------------------------------------------------------------------
   The reference code of VK_EXT_opacity_micromap, in rationals and in words without bounds
   ------------------------------------------------------------------------------------------------------------------ *)

(* A word is a whole number, in two's complement without end: Z.lnot x = -x-1 is NOT, Z.land AND, Z.lor OR, Z.lxor XOR,
   Z.shiftr x k = x >> k; Z.testbit x i says whether bit i is 1. *)

(* clamp(q, 0, 1). *)
Definition clamp (q : Q) : Q := (if 0 >? q then 0 else if q >? 1 then 1 else q)%Q.

(* The grid square (iu, iv) of a point, and iw: from iu = floor(uN), iv = floor(vN), and whether the point lies in the
   upper half of its square, uf+vf >= 1.
     iu, iv at most N-1;  iuv = iu+iv;  if iuv >= N then iu = iu - (iuv-N+1)
     iw = NOT(iu+iv);  if uf+vf >= 1 and iuv < N-1 then iw = iw-1 *)
Definition grid_square (iu iv : Z) (upper_half : bool) (N : Z) : Z * Z * Z :=
  let iu := if iu <? N then iu else N - 1 in
  let iv := if iv <? N then iv else N - 1 in
  let iuv := iu + iv in
  let iu := if iuv <? N then iu else iu - (iuv - N + 1) in
  let iw := Z.lnot (iu + iv) in
  let iw := if upper_half && (iuv <? N - 1) then iw - 1 else iw in
  (iu, iv, iw).

(* t XOR t>>1 XOR t>>2 ... XOR t>>(level-1): bit i is the XOR of the bits of t from i up. *)
Fixpoint prefix_xor (level : nat) (t : Z) : Z :=
  match level with
  | O => 0
  | S i => Z.lxor (prefix_xor i t) (Z.shiftr t (Z.of_nat i))
  end.

(* Bit i of b0 to bit 2i, bit i of b1 to bit 2i+1, for i below level: the sum of 4^i (b0_i + 2 b1_i). *)
Definition bit (x : Z) (i : nat) : Z := if Z.testbit x (Z.of_nat i) then 1 else 0.
Fixpoint interleave (level : nat) (b0 b1 : Z) : Z :=
  match level with
  | O => 0
  | S i => 4 ^ Z.of_nat i * (bit b0 i + 2 * bit b1 i) + interleave i b0 b1
  end.

(* b0 = NOT(iu XOR iw), its low `level` bits;  t = (iu XOR iv) AND b0;  f = prefix XOR of t
   b1 = ((f XOR iu) AND NOT b0) OR t;  b0 in the even bits of the index, b1 in the odd ones *)
Definition curve (level : nat) (iu iv iw : Z) : Z :=
  let b0 := Z.land (Z.lnot (Z.lxor iu iw)) (side level - 1) in
  let t := Z.land (Z.lxor iu iv) b0 in
  let f := prefix_xor level t in
  let b1 := Z.lor (Z.land (Z.lxor f iu) (Z.lnot b0)) t in
  interleave level b0 b1.

Definition index_of_square (level : nat) (iu iv : Z) (upper_half : bool) : Z :=
  let '(iu, iv, iw) := grid_square iu iv upper_half (side level) in curve level iu iv iw.

(* Qfloor is floor, from Q to Z; inject_Z takes a whole number as a rational. *)
Definition reference (u v : Q) (level : nat) : Z :=
  let un := (inject_Z (side level) * clamp u)%Q in
  let vn := (inject_Z (side level) * clamp v)%Q in
  let iu := Qfloor un in
  let iv := Qfloor vn in
  let uf := (un - inject_Z iu)%Q in
  let vf := (vn - inject_Z iv)%Q in
  index_of_square level iu iv (uf + vf >=? 1)%Q.

(* The same in words of 32 bits, with the published code's shifts and masks: what leaves the 32 bits is cut off. *)
Definition word (x : Z) : Z := x mod 2 ^ 32.
Definition not32 (x : Z) : Z := word (Z.lnot x).

(* f ^= f >> 1; f ^= f >> 2; f ^= f >> 4; f ^= f >> 8 *)
Definition prefix_xor32 (t : Z) : Z :=
  let f := t in
  let f := Z.lxor f (Z.shiftr f 1) in
  let f := Z.lxor f (Z.shiftr f 2) in
  let f := Z.lxor f (Z.shiftr f 4) in
  Z.lxor f (Z.shiftr f 8).

(* Bit i of 16 goes to bit 2i. *)
Definition spread32 (x : Z) : Z :=
  let x := Z.land (Z.lor x (word (Z.shiftl x 8))) 0x00ff00ff in
  let x := Z.land (Z.lor x (word (Z.shiftl x 4))) 0x0f0f0f0f in
  let x := Z.land (Z.lor x (word (Z.shiftl x 2))) 0x33333333 in
  Z.land (Z.lor x (word (Z.shiftl x 1))) 0x55555555.

Definition published_of_square (level : nat) (iu iv : Z) (upper_half : bool) : Z :=
  let N := side level in
  let iu := if iu <? N then iu else N - 1 in
  let iv := if iv <? N then iv else N - 1 in
  let iuv := word (iu + iv) in
  let iu := if iuv <? N then iu else word (iu - (iuv - N + 1)) in
  let iw := not32 (word (iu + iv)) in
  let iw := if upper_half && (iuv <? N - 1) then word (iw - 1) else iw in
  let b0 := Z.land (not32 (Z.lxor iu iw)) (N - 1) in
  let t := Z.land (Z.lxor iu iv) b0 in
  let f := prefix_xor32 t in
  let b1 := Z.lor (Z.land (Z.lxor f iu) (not32 b0)) t in
  Z.lor (spread32 b0) (word (Z.shiftl (spread32 b1) 1)).

(* The published code, but for its floats: uN and vN are exact here. *)
Definition published (u v : Q) (level : nat) : Z :=
  let un := (inject_Z (side level) * clamp u)%Q in
  let vn := (inject_Z (side level) * clamp v)%Q in
  let iu := Qfloor un in
  let iv := Qfloor vn in
  let uf := (un - inject_Z iu)%Q in
  let vf := (vn - inject_Z iv)%Q in
  published_of_square level iu iv (uf + vf >=? 1)%Q.

(* ---------------------------------------------------------------------------------------------------------------------
   From the index back to the micro-triangle
   ------------------------------------------------------------------------------------------------------------------ *)

(* A micro-vertex (i, j) is the point (i/N, j/N); a triangle has three, P0, P1 and P2. *)
Definition vertex : Set := Z * Z.
Definition triangle : Set := vertex * vertex * vertex.
Definition P0_of (P : triangle) : vertex := let '(P0, P1, P2) := P in P0.
Definition P2_of (P : triangle) : vertex := let '(P0, P1, P2) := P in P2.
Definition middle (a b : vertex) : vertex := ((fst a + fst b) / 2, (snd a + snd b) / 2).

(* The child of a triangle that a digit names: child 0 lies at P0, child 2 at P1, child 3 at P2, child 1 in the middle.
   Where Algorithm 4 flips left and right, here P0 and P1 change places. *)
Definition child (P : triangle) (digit : Z) : triangle :=
  let '(P0, P1, P2) := P in
  let P01 := middle P0 P1 in
  let P02 := middle P0 P2 in
  let P12 := middle P1 P2 in
  if digit =? 0 then (P0, P01, P02)
  else if digit =? 1 then (P02, P12, P01)
  else if digit =? 2 then (P01, P1, P12)
  else (P12, P02, P2).

(* Child by child, the highest of the index's `levels` digits in base 4 first. *)
Fixpoint descend (levels : nat) (P : triangle) (index : Z) : triangle :=
  match levels with
  | O => P
  | S i => descend i (child P ((index / 4 ^ Z.of_nat i) mod 4)) index
  end.

Definition corners (level : nat) (index : Z) : triangle :=
  descend level ((0, 0), (side level, 0), (0, side level)) index.

(* ---------------------------------------------------------------------------------------------------------------------
   Micro-triangles, by their place in the grid
   ------------------------------------------------------------------------------------------------------------------ *)

(* Half of the grid square (i, j): upper = false has the corners (i, j), (i+1, j), (i, j+1), upper = true the corners
   (i+1, j+1), (i, j+1), (i+1, j). *)
Definition micro_triangle : Set := Z * Z * bool.

(* Those of a level are the ones in the base triangle. *)
Definition of_level (level : nat) (T : micro_triangle) : Prop :=
  let '(i, j, upper) := T in 0 <= i /\ 0 <= j /\ i + j + (if upper then 1 else 0) < side level.

(* The point (u, v) lies strictly inside; it lies inside or on an edge. *)
Definition inside (level : nat) (T : micro_triangle) (u v : Q) : Prop :=
  let '(i, j, upper) := T in
  let un := (inject_Z (side level) * u)%Q in
  let vn := (inject_Z (side level) * v)%Q in
  if upper : bool
  then (un < inject_Z (i + 1) /\ vn < inject_Z (j + 1) /\ inject_Z (i + j + 1) < un + vn)%Q
  else (inject_Z i < un /\ inject_Z j < vn /\ un + vn < inject_Z (i + j + 1))%Q.

Definition within (level : nat) (T : micro_triangle) (u v : Q) : Prop :=
  let '(i, j, upper) := T in
  let un := (inject_Z (side level) * u)%Q in
  let vn := (inject_Z (side level) * v)%Q in
  if upper : bool
  then (un <= inject_Z (i + 1) /\ vn <= inject_Z (j + 1) /\ inject_Z (i + j + 1) <= un + vn)%Q
  else (inject_Z i <= un /\ inject_Z j <= vn /\ un + vn <= inject_Z (i + j + 1))%Q.

Definition is_corner (p : vertex) (P : triangle) : Prop := let '(P0, P1, P2) := P in p = P0 \/ p = P1 \/ p = P2.

Definition corners_of (T : micro_triangle) : triangle :=
  let '(i, j, upper) := T in
  if upper : bool then ((i + 1, j + 1), (i, j + 1), (i + 1, j)) else ((i, j), (i + 1, j), (i, j + 1)).

(* The same three corners, in whatever order. *)
Definition same_corners (P P' : triangle) : Prop := forall p, is_corner p P <-> is_corner p P'.

(* What two micro-triangles have in common. *)
Definition share_an_edge (P P' : triangle) : Prop :=
  exists p q, p <> q /\ is_corner p P /\ is_corner q P /\ is_corner p P' /\ is_corner q P'.
Definition share_one_corner (P P' : triangle) : Prop :=
  exists p, forall q, is_corner q P /\ is_corner q P' <-> q = p.
