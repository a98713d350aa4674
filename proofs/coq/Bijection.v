(* Micro-triangles and indices are one to one, and the corners of an index are those of its micro-triangle. *)
From Coq Require Import Lia Lqa.
Require Import Definitions Walk Words Induction Points Triangles.

Lemma digit_below k P : 0 < P -> (k mod (P * 4)) = ((k / P) mod 4) * P + k mod P.
Proof. intros H. rewrite Z.rem_mul_r by lia. ring. Qed.

Lemma walk_descend n : forall mid top x y k index, exists mid' top' x' y',
  descend n (half_square mid top (2 ^ Z.of_nat n) x y) k = half_square mid' top' 1 x' y' /\
  forall d U V X' Y' W', 0 < d -> 0 < X' -> 0 < Y' -> 0 < W' -> located mid' d 1 x' y' U V X' Y' W' ->
  exists X Y W, 0 < X /\ 0 < Y /\ 0 < W /\ located mid d (2 ^ Z.of_nat n) x y U V X Y W /\
  walk n d X Y W index mid top = index * 4 ^ Z.of_nat n + k mod 4 ^ Z.of_nat n.
Proof.
  induction n as [| n IH]; intros mid top x y k index.
  - exists mid, top, x, y. split; [reflexivity |]. intros d U V X' Y' W' Hd HX HY HW L.
    exists X', Y', W'. repeat (split; [assumption |]). cbn. rewrite Z.mod_1_r. lia.
  - cbn [descend]. set (digit := (k / 4 ^ Z.of_nat n) mod 4).
    assert (0 <= digit < 4) as Hdigit by (apply Z.mod_pos_bound; lia).
    rewrite power_S. pose proof (child_is_square mid top (2 ^ Z.of_nat n) x y digit Hdigit) as C.
    pose proof (fun d U V X1 Y1 W1 => unstep n d mid top x y digit U V X1 Y1 W1) as up.
    destruct (child_square mid top (2 ^ Z.of_nat n) x y digit) as [[[m t] x1] y1]. rewrite C.
    destruct (IH m t x1 y1 k (4 * index + digit)) as (mid' & top' & x' & y' & -> & H).
    exists mid', top', x', y'. split; [reflexivity |]. intros d U V X' Y' W' Hd HX HY HW L.
    destruct (H d U V X' Y' W' Hd HX HY HW L) as (X1 & Y1 & W1 & HX1 & HY1 & HW1 & L1 & e).
    destruct (up d U V X1 Y1 W1 Hd Hdigit HX1 HY1 HW1 L1) as (X & Y & W & HX2 & HY2 & HW2 & L2 & e2).
    exists X, Y, W. repeat (split; [assumption |]). rewrite e2, e.
    rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia.
    rewrite (Z.mul_comm 4 (4 ^ Z.of_nat n)), digit_below by (apply Z.pow_pos_nonneg; lia).
    fold digit. ring.
Qed.

(* The two lemmas on the base triangle. *)
Definition of_square (level : nat) (k : Z) (mid top : bool) (x y : Z) : Prop :=
  corners level k = half_square mid top 1 x y.

Lemma index_located level d X Y : 0 < d -> 0 <= X -> 0 <= Y -> X + Y <= d * side level ->
  exists mid top x y X' Y' W', 0 <= X' /\ 0 <= Y' /\ 0 <= W' /\
  of_square level (walk level d X Y (d * side level - X - Y) 0 false false) mid top x y /\
  located mid d 1 x y X Y X' Y' W'.
Proof.
  intros Hd HX HY HXY.
  destruct (descend_walk level d Hd X Y (d * side level - X - Y) 0 false false 0 0 X Y) as
    (mid & top & x & y & X' & Y' & W' & HX' & HY' & HW' & e & L); try lia.
  - unfold located, side. repeat split; lia.
  - exists mid, top, x, y, X', Y', W'. repeat (split; [assumption |]). exact L.
Qed.

Lemma located_index level k : 0 <= k < 4 ^ Z.of_nat level -> exists mid top x y, of_square level k mid top x y /\
  forall d U V X' Y' W', 0 < d -> 0 < X' -> 0 < Y' -> 0 < W' -> located mid d 1 x y U V X' Y' W' ->
  0 < U /\ 0 < V /\ U + V < d * side level /\ walk level d U V (d * side level - U - V) 0 false false = k.
Proof.
  intros Hk. destruct (walk_descend level false false 0 0 k 0) as (mid & top & x & y & e & H).
  exists mid, top, x, y. split; [exact e |]. intros d U V X' Y' W' Hd HX HY HW L.
  destruct (H d U V X' Y' W' Hd HX HY HW L) as (X & Y & W & HX' & HY' & HW' & (s & -> & ->) & ew).
  rewrite Z.mod_small in ew by exact Hk. fold (side level) in *.
  repeat split; try lia.
  replace (d * side level - (d * 0 + X) - (d * 0 + Y)) with W by lia.
  rewrite !Z.mul_0_r, !Z.add_0_l. rewrite Z.mul_0_l, Z.add_0_l in ew. exact ew.
Qed.

Lemma same_whole a b r s d : 0 < r < d -> 0 <= s <= d -> d * a + r = d * b + s -> a = b /\ r = s.
Proof. intros Hr Hs e. assert (a = b) as -> by nia. lia. Qed.

(* A point strictly inside one micro-triangle lies in no other. *)
Lemma located_once d U V mid x y X Y W mid' x' y' X' Y' W' : 0 < d ->
  0 < X -> 0 < Y -> 0 < W -> located mid d 1 x y U V X Y W ->
  0 <= X' -> 0 <= Y' -> 0 <= W' -> located mid' d 1 x' y' U V X' Y' W' -> mid = mid' /\ x = x' /\ y = y'.
Proof.
  unfold located. rewrite Z.mul_1_r.
  intros Hd HX HY HW (s & eU & eV) HX' HY' HW' (s' & eU' & eV').
  destruct mid, mid'; rewrite eU in eU'; rewrite eV in eV'; apply same_whole in eU', eV'; try lia;
    destruct eU' as [-> eU'], eV' as [-> eV']; try (exfalso; lia); auto.
Qed.

(* From rationals: inside and within, as Definitions.v has them. *)
Lemma has_fractions u v N : 0 < N -> exists d U V, 0 < d /\ is u U (d * N) /\ is v V (d * N).
Proof.
  intros HN. exists (Z.pos (Qden u * Qden v)), (Qnum u * Z.pos (Qden v) * N), (Qnum v * Z.pos (Qden u) * N).
  split; [lia |]. unfold is, Qeq, inject_Z. cbn [Qnum Qden Qmult]. rewrite !Pos2Z.inj_mul. split; ring.
Qed.

Lemma side_pos level : 0 < side level.
Proof. apply power_pos. Qed.

(* Order of rationals, in numerators. *)
Lemma compare_numerators (x y : Q) (X Y E : Z) : 0 < E -> is x X E -> is y Y E ->
  ((x < y)%Q <-> X < Y) /\ ((x <= y)%Q <-> X <= Y).
Proof.
  unfold is. intros HE HX HY.
  assert (0 < inject_Z E)%Q as Hq by (change 0%Q with (inject_Z 0); rewrite <- Zlt_Qlt; exact HE).
  split; split; intros l.
  - rewrite Zlt_Qlt, <- HX, <- HY. apply Qmult_lt_r; assumption.
  - rewrite Zlt_Qlt, <- HX, <- HY in l. apply Qmult_lt_r in l; assumption.
  - rewrite Zle_Qle, <- HX, <- HY. apply Qmult_le_r; assumption.
  - rewrite Zle_Qle, <- HX, <- HY in l. apply Qmult_le_r in l; assumption.
Qed.

Lemma scaled_fraction (u : Q) U d N : is u U (d * N) -> is (inject_Z N * u) U d.
Proof. unfold is. intros <-. rewrite inject_Z_mult. ring. Qed.

Lemma whole_fraction i d : is (inject_Z i) (d * i) d.
Proof. unfold is. rewrite inject_Z_mult. ring. Qed.

Lemma sum_fraction x y X Y d : is x X d -> is y Y d -> is (x + y) (X + Y) d.
Proof. unfold is. intros HX HY. rewrite inject_Z_plus, <- HX, <- HY. ring. Qed.

Lemma less x y X Y d : 0 < d -> is x X d -> is y Y d -> (x < y)%Q -> X < Y.
Proof. intros Hd HX HY. apply (compare_numerators x y X Y d Hd HX HY). Qed.

Lemma at_most x y X Y d : 0 < d -> is x X d -> is y Y d -> X <= Y -> (x <= y)%Q.
Proof. intros Hd HX HY. apply (compare_numerators x y X Y d Hd HX HY). Qed.

Ltac fraction := first [eassumption | apply whole_fraction | apply sum_fraction; eassumption].

(* Inside and within, in numerators: as `located`. *)
Lemma inside_located level i j upper u v d U V : 0 < d -> is u U (d * side level) -> is v V (d * side level) ->
  inside level (i, j, upper) u v ->
  exists X Y W, 0 < X /\ 0 < Y /\ 0 < W /\ located upper d 1 i j U V X Y W.
Proof.
  intros Hd HU HV. apply scaled_fraction in HU, HV.
  unfold inside, located. destruct upper; intros (H1 & H2 & H3);
    (eapply less in H1; [| eassumption | fraction | fraction]);
    (eapply less in H2; [| eassumption | fraction | fraction]);
    (eapply less in H3; [| eassumption | fraction | fraction]).
  - exists (U + V - d * (i + j + 1)), (d * (j + 1) - V), (d * (i + 1) - U). repeat split; lia.
  - exists (U - d * i), (V - d * j), (d * (i + j + 1) - U - V). repeat split; lia.
Qed.

Lemma located_within level i j upper u v d U V X Y W : 0 < d -> is u U (d * side level) -> is v V (d * side level) ->
  0 <= X -> 0 <= Y -> 0 <= W -> located upper d 1 i j U V X Y W -> within level (i, j, upper) u v.
Proof.
  intros Hd HU HV HX HY HW (s & eU & eV). apply scaled_fraction in HU, HV.
  unfold within. destruct upper; repeat split;
    (eapply at_most; [eassumption | fraction | fraction | lia]).
Qed.

(* The statement about micro-triangles is about some points: the centre, ((3i+c)/(3N), (3j+c)/(3N)), is one of them. *)
Lemma centre_inside level i j (upper : bool) : let c := if upper then 2 else 1 in
  inside level (i, j, upper) (3 * i + c # Z.to_pos (3 * side level)) (3 * j + c # Z.to_pos (3 * side level)).
Proof.
  intros c. pose proof (side_pos level) as HN.
  assert (forall k, is (inject_Z (side level) * (3 * k + c # Z.to_pos (3 * side level))) (3 * k + c) 3) as H.
  { intros k. unfold is, Qeq, inject_Z. cbn [Qnum Qden Qmult Pos.mul].
    rewrite Pos.mul_1_r, Z2Pos.id by lia. ring. }
  pose proof (sum_fraction _ _ _ _ 3 (H i) (H j)) as Hsum.
  assert (forall x y X Y, is x X 3 -> is y Y 3 -> X < Y -> (x < y)%Q) as less_back.
  { intros x y X Y HX HY. apply (compare_numerators x y X Y 3 ltac:(lia) HX HY). }
  unfold inside, c in *. destruct upper; repeat split;
    (eapply less_back; [first [apply whole_fraction | apply H | exact Hsum] .. | lia]).
Qed.

Lemma half_square_once mid top x y mid' top' x' y' :
  half_square mid top 1 x y = half_square mid' top' 1 x' y' -> mid = mid' /\ x = x' /\ y = y'.
Proof. destruct mid, top, mid', top'; cbn; intros e; injection e; intros; try lia; auto; lia. Qed.

Lemma half_square_corners mid top x y : same_corners (half_square mid top 1 x y) (corners_of (x, y, mid)).
Proof. intros p. destruct mid, top; cbn; tauto. Qed.

Lemma inside_numerators level i j upper u v : of_level level (i, j, upper) -> inside level (i, j, upper) u v ->
  exists d U V X Y W, numerators u v (side level) d U V /\ 0 < X /\ 0 < Y /\ 0 < W /\ located upper d 1 i j U V X Y W.
Proof.
  unfold of_level. intros (Hi & Hj & Hsum) I.
  destruct (has_fractions u v (side level) (side_pos level)) as (d & U & V & Hd & HU & HV).
  destruct (inside_located level i j upper u v d U V Hd HU HV I) as (X & Y & W & HX & HY & HW & L).
  exists d, U, V, X, Y, W. repeat (split; [| tauto]). pose proof L as (s & eU & eV).
  split; try assumption; destruct upper; nia.
Qed.

(* Each micro-triangle has its own index: that of all points inside it. *)
Lemma index_of_triangle level i j upper : of_level level (i, j, upper) ->
  exists k top, 0 <= k < 4 ^ Z.of_nat level /\ of_square level k upper top i j /\
  forall u v, inside level (i, j, upper) u v -> uv2index u v level = k.
Proof.
  intros T. pose proof T as (Hi & Hj & Hsum).
  set (c := if upper then 2 else 1). set (X := 3 * i + c). set (Y := 3 * j + c).
  assert (located upper 3 1 i j X Y 1 1 1) as L by (unfold located, X, Y, c; destruct upper; lia).
  assert (0 <= X /\ 0 <= Y /\ X + Y <= 3 * side level) as (HX & HY & HXY) by (unfold X, Y, c; destruct upper; lia).
  destruct (index_located level 3 X Y ltac:(lia) HX HY HXY) as
    (mid & top & x & y & X' & Y' & W' & HX' & HY' & HW' & S & L').
  destruct (located_once 3 X Y _ _ _ _ _ _ _ _ _ _ _ _ ltac:(lia) Z.lt_0_1 Z.lt_0_1 Z.lt_0_1 L HX' HY' HW' L')
    as (<- & <- & <-).
  set (k := walk level 3 X Y (3 * side level - X - Y) 0 false false) in *.
  assert (0 <= k < 4 ^ Z.of_nat level) as Hk.
  { pose proof (walk_range level 3 X Y (3 * side level - X - Y) 0 false false) as R. fold k in R. lia. }
  exists k, top. split; [exact Hk |]. split; [exact S |]. intros u v I.
  destruct (located_index level k Hk) as (mid' & top' & x' & y' & S' & H).
  unfold of_square in S, S'. rewrite S in S'. apply half_square_once in S'. destruct S' as (<- & <- & <-).
  destruct (inside_numerators level i j upper u v T I) as (d & U & V & X1 & Y1 & W1 & N & HX1 & HY1 & HW1 & L1).
  rewrite (uv2index_is_walk _ _ _ _ _ _ N).
  apply (H d U V X1 Y1 W1); try assumption. apply N.
Qed.

(* And each index below 4^level is one's. *)
Lemma triangle_of_index level k : 0 <= k < 4 ^ Z.of_nat level ->
  exists i j upper top, of_level level (i, j, upper) /\ of_square level k upper top i j.
Proof.
  intros Hk. destruct (located_index level k Hk) as (mid & top & x & y & S & H).
  exists x, y, mid, top. split; [| exact S].
  destruct (H 3 (3 * x + if mid then 2 else 1) (3 * y + if mid then 2 else 1) 1 1 1) as (HU & HV & Hsum & _); try lia.
  - unfold located. destruct mid; lia.
  - unfold of_level. destruct mid; lia.
Qed.

Lemma point_within level u v : in_triangle u v ->
  exists i j upper top, of_level level (i, j, upper) /\ of_square level (uv2index u v level) upper top i j /\
  within level (i, j, upper) u v.
Proof.
  intros T. destruct (has_numerators u v level T) as (d & X & Y & N).
  rewrite (uv2index_is_walk _ _ _ _ _ _ N). destruct N as [Hd HX HY HXY eX eY].
  destruct (index_located level d X Y Hd HX HY HXY) as
    (mid & top & x & y & X' & Y' & W' & HX' & HY' & HW' & S & L).
  set (k := walk level d X Y (d * side level - X - Y) 0 false false) in *.
  assert (0 <= k < 4 ^ Z.of_nat level) as Hk.
  { pose proof (walk_range level d X Y (d * side level - X - Y) 0 false false) as R. fold k in R. lia. }
  destruct (triangle_of_index level k Hk) as (i & j & upper & top' & T' & S').
  pose proof S as S2. unfold of_square in S2, S'. rewrite S' in S2. apply half_square_once in S2.
  destruct S2 as (-> & -> & ->).
  exists x, y, mid, top. split; [exact T' |]. split; [exact S |].
  exact (located_within level x y mid u v d X Y X' Y' W' Hd eX eY HX' HY' HW' L).
Qed.

(* Two indices with the corners of one micro-triangle are one index. *)
Lemma index_of_square_once level k k' i j upper top top' :
  0 <= k < 4 ^ Z.of_nat level -> 0 <= k' < 4 ^ Z.of_nat level ->
  of_square level k upper top i j -> of_square level k' upper top' i j -> k' = k.
Proof.
  intros Hk Hk' S S'.
  destruct (located_index level k Hk) as (m & t & x & y & S1 & H).
  destruct (located_index level k' Hk') as (m' & t' & x' & y' & S1' & H').
  unfold of_square in *. rewrite S in S1. rewrite S' in S1'. apply half_square_once in S1, S1'.
  destruct S1 as (<- & <- & <-), S1' as (<- & <- & <-).
  set (c := if upper then 2 else 1).
  assert (located upper 3 1 i j (3 * i + c) (3 * j + c) 1 1 1) as L by (unfold located, c; destruct upper; lia).
  destruct (H 3 _ _ 1 1 1 ltac:(lia) Z.lt_0_1 Z.lt_0_1 Z.lt_0_1 L) as (_ & _ & _ & <-).
  destruct (H' 3 _ _ 1 1 1 ltac:(lia) Z.lt_0_1 Z.lt_0_1 Z.lt_0_1 L) as (_ & _ & _ & <-). reflexivity.
Qed.

Lemma numerators_in_triangle u v level d U V : numerators u v (side level) d U V -> in_triangle u v.
Proof.
  intros [Hd HU HV Hsum eU eV]. pose proof (side_pos level) as HN. assert (0 < d * side level) as HE by lia.
  unfold in_triangle. repeat split.
  - apply (at_most 0 u 0 U (d * side level) HE); [unfold is; reflexivity | exact eU | exact HU].
  - apply (at_most 0 v 0 V (d * side level) HE); [unfold is; reflexivity | exact eV | exact HV].
  - apply (at_most (u + v) 1 (U + V) (d * side level) (d * side level) HE);
      [apply sum_fraction; assumption | unfold is; apply Qmult_1_l | exact Hsum].
Qed.
