(* What two neighbours along the curve have in common: an edge, or one corner where digit 2 becomes 3. *)
From Coq Require Import Lia.
Require Import Definitions Walk Words Induction Triangles Curve.

(* The last and the first micro-triangle of a half square that is cut m times. *)
Lemma last_cell m : forall mid top x y k, k mod 4 ^ Z.of_nat m = 4 ^ Z.of_nat m - 1 ->
  exists top', descend m (half_square mid top (2 ^ Z.of_nat m) x y) k =
    half_square mid top' 1 (if mid then x + 2 ^ Z.of_nat m - 1 else x) (if mid then y else y + 2 ^ Z.of_nat m - 1).
Proof.
  induction m as [| m IH]; intros mid top x y k H.
  - exists top. cbn [descend]. change (2 ^ Z.of_nat 0) with 1. f_equal; destruct mid; lia.
  - rewrite digits_of_k in H. pose proof (power4_pos m).
    pose proof (Z.mod_pos_bound (k / 4 ^ Z.of_nat m) 4 ltac:(lia)).
    pose proof (Z.mod_pos_bound k (4 ^ Z.of_nat m) ltac:(lia)).
    rewrite Nat2Z.inj_succ, Z.pow_succ_r in H by lia. cbn [descend].
    replace ((k / 4 ^ Z.of_nat m) mod 4) with 3 by nia. rewrite power_S.
    pose proof (child_is_square mid top (2 ^ Z.of_nat m) x y 3 ltac:(lia)) as C. cbn [child_square Z.eqb Pos.eqb] in C.
    rewrite C.
    destruct (IH mid (negb top) (if mid then x + 2 ^ Z.of_nat m else x) (if mid then y else y + 2 ^ Z.of_nat m) k)
      as [top' e]; [nia |].
    rewrite e. exists top'. f_equal; destruct mid; lia.
Qed.

Lemma first_cell m : forall mid top x y k, k mod 4 ^ Z.of_nat m = 0 ->
  descend m (half_square mid top (2 ^ Z.of_nat m) x y) k =
    half_square mid top 1 (if top then x + 2 ^ Z.of_nat m - 1 else x) (if mid then y + 2 ^ Z.of_nat m - 1 else y).
Proof.
  induction m as [| m IH]; intros mid top x y k H.
  - cbn [descend]. change (2 ^ Z.of_nat 0) with 1. f_equal; [destruct top | destruct mid]; lia.
  - rewrite digits_of_k in H. pose proof (power4_pos m).
    pose proof (Z.mod_pos_bound (k / 4 ^ Z.of_nat m) 4 ltac:(lia)).
    pose proof (Z.mod_pos_bound k (4 ^ Z.of_nat m) ltac:(lia)). cbn [descend].
    replace ((k / 4 ^ Z.of_nat m) mod 4) with 0 by nia. rewrite power_S.
    pose proof (child_is_square mid top (2 ^ Z.of_nat m) x y 0 ltac:(lia)) as C. cbn [child_square Z.eqb] in C.
    destruct top; cbn [negb andb orb] in C; rewrite C, IH by nia; f_equal; destruct mid; lia.
Qed.

(* The digit that changes is `digit`. *)
Definition joined (digit : Z) (P P' : triangle) : Prop :=
  if digit =? 2 then share_one_corner P P' else share_an_edge P P'.

Ltac equal_vertices := repeat (f_equal; try lia).
Ltac some_corner := cbn -[Z.add Z.sub Z.mul]; first
  [left; solve [equal_vertices] | right; left; solve [equal_vertices] | right; right; solve [equal_vertices]].
Ltac shared p q :=
  exists p, q; split; [intros e; injection e; intros; lia | repeat (split; [some_corner |]); some_corner].
Ltac an_edge :=
  match goal with
  | |- exists p q, _ /\ is_corner p (?a, ?b, ?c) /\ _ => first [shared a c | shared b c | shared a b]
  end.
Ltac one_corner :=
  match goal with
  | |- exists p, forall q, is_corner q (?a, ?b, ?c) /\ _ <-> _ =>
      exists c; intros q; split;
      [ cbn [is_corner]; intros [e e']; destruct e as [-> | [-> | ->]]; destruct e' as [e' | [e' | e']];
        first [reflexivity | exfalso; injection e'; intros; lia | injection e'; intros; equal_vertices]
      | intros ->; split; some_corner ]
  end.

Lemma joined_at m : forall mid top x y k, k mod 4 ^ Z.of_nat m = 4 ^ Z.of_nat m - 1 ->
  let digit := (k / 4 ^ Z.of_nat m) mod 4 in
  digit <> 3 ->
  joined digit (descend (S m) (half_square mid top (2 ^ Z.of_nat (S m)) x y) k)
    (descend (S m) (half_square mid top (2 ^ Z.of_nat (S m)) x y) (k + 1)).
Proof.
  intros mid top x y k H digit Hdigit. cbn [descend]. rewrite power_S.
  destruct (succ_carry m k H) as [ed em]. rewrite ed, <- Zplus_mod_idemp_l. fold digit.
  assert (0 <= digit < 4) as Hd by (apply Z.mod_pos_bound; lia). clearbody digit.
  pose proof (power_pos m) as Hh.
  pose proof (fun m1 t1 x1 y1 => last_cell m m1 t1 x1 y1 k H) as last.
  pose proof (fun m1 t1 x1 y1 => first_cell m m1 t1 x1 y1 (k + 1) em) as first.
  set (h := 2 ^ Z.of_nat m) in *. clearbody h. clear H ed em.
  assert (digit = 0 \/ digit = 1 \/ digit = 2) as [-> | [-> | ->]] by lia.
  all: match goal with
    | |- joined ?a (descend _ (child _ ?a) _) (descend _ (child _ (?b mod 4)) _) =>
        change (b mod 4) with (a + 1);
        pose proof (child_is_square mid top h x y a ltac:(lia)) as Ca;
        pose proof (child_is_square mid top h x y (a + 1) ltac:(lia)) as Cb
    end.
  all: destruct mid, top; cbn [child_square Z.eqb Pos.eqb negb andb orb Z.add Pos.add Pos.succ] in Ca, Cb |- *.
  all: rewrite Ca, Cb, first.
  all: match goal with
    | |- joined _ (descend _ (half_square ?a ?b _ ?c ?d) _) _ => destruct (last a b c d) as [t e]; rewrite e; clear e
    end.
  all: clear last first Ca Cb; destruct t; unfold joined, share_an_edge, share_one_corner;
    cbn [Z.eqb Pos.eqb half_square]; solve [an_edge | one_corner].
Qed.

(* The digits above that one are alike. *)
Lemma all_threes n m k : (m < n)%nat -> k mod 4 ^ Z.of_nat n = 4 ^ Z.of_nat n - 1 -> (k / 4 ^ Z.of_nat m) mod 4 = 3.
Proof.
  intros Hm H. pose proof (power4_pos m) as Pm. pose proof (power4_pos (n - m - 1)) as Pr.
  assert (4 ^ Z.of_nat n = 4 ^ Z.of_nat (n - m - 1) * 4 * 4 ^ Z.of_nat m) as e.
  { rewrite <- (Z.pow_1_r 4) at 3. rewrite <- !Z.pow_add_r by lia. f_equal. lia. }
  pose proof (Z.div_mod k (4 ^ Z.of_nat n) ltac:(rewrite e; nia)) as d. rewrite H, e in d. clear H e.
  set (q := k / (4 ^ Z.of_nat (n - m - 1) * 4 * 4 ^ Z.of_nat m)) in *. clearbody q.
  set (r := 4 ^ Z.of_nat (n - m - 1)) in *. set (p := 4 ^ Z.of_nat m) in *.
  rewrite <- (Z.div_unique k p (4 * (r * q + r - 1) + 3) (p - 1)) by (try left; lia).
  symmetry. apply Z.mod_unique with (r * q + r - 1); lia.
Qed.

Lemma descend_joined m n : (m < n)%nat -> forall mid top x y k, k mod 4 ^ Z.of_nat m = 4 ^ Z.of_nat m - 1 ->
  let digit := (k / 4 ^ Z.of_nat m) mod 4 in
  digit <> 3 ->
  joined digit (descend n (half_square mid top (2 ^ Z.of_nat n) x y) k)
    (descend n (half_square mid top (2 ^ Z.of_nat n) x y) (k + 1)).
Proof.
  induction n as [| n IH]; intros Hm mid top x y k H digit Hdigit; [lia |].
  destruct (Nat.eq_dec m n) as [<- | ne]; [apply joined_at; assumption |].
  cbn [descend].
  rewrite (proj1 (succ_digits n k (fun e => Hdigit (all_threes n m k ltac:(lia) e)))).
  pose proof (child_is_square mid top (2 ^ Z.of_nat n) x y _ (Z.mod_pos_bound (k / 4 ^ Z.of_nat n) 4 ltac:(lia))) as C.
  rewrite power_S. destruct (child_square _ _ _ _ _ _) as [[[m' t'] x'] y']. rewrite C.
  apply IH; [lia | exact H | exact Hdigit].
Qed.

Lemma corners_joined level m k : 0 <= k -> k + 1 < 4 ^ Z.of_nat level ->
  k mod 4 ^ Z.of_nat m = 4 ^ Z.of_nat m - 1 -> (k / 4 ^ Z.of_nat m) mod 4 <> 3 ->
  joined ((k / 4 ^ Z.of_nat m) mod 4) (corners level k) (corners level (k + 1)).
Proof.
  intros H0 H1 H Hdigit. pose proof (power4_pos m) as P. pose proof (Z.mod_le k (4 ^ Z.of_nat m) H0 P).
  assert (m < level)%nat as Hm.
  { apply Nat2Z.inj_lt. apply (Z.pow_lt_mono_r_iff 4); lia. }
  exact (descend_joined m level Hm false false 0 0 k H Hdigit).
Qed.
