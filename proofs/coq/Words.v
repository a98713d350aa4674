(* The bit formula in whole numbers: the words of the reference are A/d, B/d and C/d, and their bits, from the highest
   down, are comparisons of A, B and C with d 2^i. *)
From Coq Require Import Lia.
Require Import Definitions Walk.

(* One place of `curve`: the bits of iu, iv, iw, and the XOR of t over the places above. *)
Definition b0_of (bu bw : bool) : bool := negb (xorb bu bw).
Definition t_of (bu bv bw : bool) : bool := xorb bu bv && b0_of bu bw.
Definition b1_of (bu bv bw above : bool) : bool :=
  (xorb (xorb (t_of bu bv bw) above) bu && negb (b0_of bu bw)) || t_of bu bv bw.
Definition truth (b : bool) : Z := if b then 1 else 0.

(* The digits from the highest down.  A, B and C lose their highest bit on the way. *)
Fixpoint digits (n : nat) (d A B C : Z) (above : bool) : Z :=
  match n with
  | O => 0
  | S n =>
      let D := d * 2 ^ Z.of_nat n in
      let bu := D <=? A in
      let bv := D <=? B in
      let bw := D <=? C in
      4 ^ Z.of_nat n * (truth (b0_of bu bw) + 2 * truth (b1_of bu bv bw above)) +
      digits n d (if bu then A - D else A) (if bv then B - D else B) (if bw then C - D else C)
        (xorb (t_of bu bv bw) above)
  end.

(* A word whose low n+1 bits are A/d: bit n, and what is left. *)
Lemma highest_bit n d A x : 0 < d -> 0 <= A < d * 2 ^ Z.of_nat (S n) -> x mod 2 ^ Z.of_nat (S n) = A / d ->
  let D := d * 2 ^ Z.of_nat n in
  Z.testbit x (Z.of_nat n) = (D <=? A) /\ x mod 2 ^ Z.of_nat n = (if D <=? A then A - D else A) / d /\
  0 <= (if D <=? A then A - D else A) < D.
Proof.
  intros Hd [H0 H1] Hx D. rewrite scale_S in H1. fold D in H1. pose proof (power_pos n) as HP.
  assert (x mod 2 ^ Z.of_nat n = (A / d) mod 2 ^ Z.of_nat n) as Hlow.
  { rewrite <- Hx, power_S, Z.mul_comm, Z.rem_mul_r by lia.
    rewrite Z.mul_comm, Z_mod_plus_full, Z.mod_mod by lia. reflexivity. }
  assert (Z.testbit x (Z.of_nat n) = Z.testbit (A / d) (Z.of_nat n)) as Hbit.
  { rewrite <- Hx, Z.mod_pow2_bits_low by lia. reflexivity. }
  rewrite Hlow, Hbit. destruct (Z.leb_spec D A) as [l | l].
  - assert (A / d = (A - D) / d + 2 ^ Z.of_nat n) as e.
    { rewrite <- Z.div_add by lia. f_equal. unfold D. ring. }
    assert (0 <= (A - D) / d < 2 ^ Z.of_nat n) as Hs.
    { split; [apply Z.div_pos; lia | apply Z.div_lt_upper_bound; fold D; lia]. }
    split; [| split; [| lia]].
    + rewrite Z.testbit_true, e by lia. rewrite <- (Z.mul_1_l (2 ^ Z.of_nat n)) at 1.
      rewrite Z.div_add, Z.div_small by lia. reflexivity.
    + rewrite e. rewrite <- (Z.mul_1_l (2 ^ Z.of_nat n)) at 1. rewrite Z_mod_plus_full, Z.mod_small; lia.
  - assert (0 <= A / d < 2 ^ Z.of_nat n) as Hs.
    { split; [apply Z.div_pos; lia | apply Z.div_lt_upper_bound; fold D; lia]. }
    split; [| split; [| lia]].
    + apply Z.testbit_false; [lia |]. rewrite Z.div_small by lia. reflexivity.
    + apply Z.mod_small; lia.
Qed.


Lemma prefix_xor_step k t i : 0 <= i ->
  xorb (Z.testbit (prefix_xor k t) i) (Z.testbit (prefix_xor k t) (i + 1)) =
  xorb (Z.testbit t i) (Z.testbit t (i + Z.of_nat k)).
Proof.
  intros Hi. induction k as [| k IH].
  - cbn. rewrite !Z.bits_0, Z.add_0_r, !xorb_nilpotent. reflexivity.
  - cbn [prefix_xor]. rewrite !Z.lxor_spec, !Z.shiftr_spec by lia.
    replace (i + 1 + Z.of_nat k) with (i + Z.of_nat (S k)) by lia.
    revert IH. destruct (Z.testbit (prefix_xor k t) i), (Z.testbit (prefix_xor k t) (i + 1)), (Z.testbit t i),
      (Z.testbit t (i + Z.of_nat k)), (Z.testbit t (i + Z.of_nat (S k))); cbn; congruence.
Qed.

Lemma prefix_xor_high k t i : (forall j, i <= j -> Z.testbit t j = false) -> 0 <= i ->
  Z.testbit (prefix_xor k t) i = false.
Proof.
  intros Ht Hi. induction k as [| k IH]; [apply Z.bits_0 |].
  cbn [prefix_xor]. rewrite Z.lxor_spec, Z.shiftr_spec, IH, Ht by lia. reflexivity.
Qed.

Lemma low_bits n i : 0 <= i -> Z.testbit (side n - 1) i = (i <? Z.of_nat n).
Proof.
  intros Hi. unfold side. replace (2 ^ Z.of_nat n - 1) with (Z.ones (Z.of_nat n)) by (rewrite Z.ones_equiv; lia).
  apply Z.testbit_ones_nonneg; lia.
Qed.

Section Curve.

Variables (n : nat) (iu iv iw : Z).
Let b0 := Z.land (Z.lnot (Z.lxor iu iw)) (side n - 1).
Let t := Z.land (Z.lxor iu iv) b0.
Let f := prefix_xor n t.
Let b1 := Z.lor (Z.land (Z.lxor f iu) (Z.lnot b0)) t.

Lemma b0_bit i : 0 <= i -> Z.testbit b0 i = b0_of (Z.testbit iu i) (Z.testbit iw i) && (i <? Z.of_nat n).
Proof.
  intros Hi. unfold b0, b0_of. rewrite Z.land_spec, Z.lnot_spec, Z.lxor_spec, low_bits by lia. reflexivity.
Qed.

Lemma t_bit i : 0 <= i ->
  Z.testbit t i = t_of (Z.testbit iu i) (Z.testbit iv i) (Z.testbit iw i) && (i <? Z.of_nat n).
Proof.
  intros Hi. unfold t, t_of. rewrite Z.land_spec, Z.lxor_spec, b0_bit by lia. rewrite andb_assoc. reflexivity.
Qed.

Lemma f_bit i : 0 <= i -> Z.testbit f i = xorb (Z.testbit t i) (Z.testbit f (i + 1)).
Proof.
  intros Hi. pose proof (prefix_xor_step n t i Hi) as H. fold f in H.
  assert (Z.testbit t (i + Z.of_nat n) = false) as e.
  { rewrite t_bit by lia. replace (i + Z.of_nat n <? Z.of_nat n) with false by (symmetry; apply Z.ltb_ge; lia).
    apply andb_false_r. }
  rewrite e in H. revert H. destruct (Z.testbit f i), (Z.testbit f (i + 1)), (Z.testbit t i); cbn; congruence.
Qed.

Lemma f_top : Z.testbit f (Z.of_nat n) = false.
Proof.
  apply prefix_xor_high; [| lia]. intros j Hj. rewrite t_bit by lia.
  replace (j <? Z.of_nat n) with false by (symmetry; apply Z.ltb_ge; lia). apply andb_false_r.
Qed.

Lemma digits_interleave d : 0 < d -> forall m A B C, (m <= n)%nat ->
  let M := 2 ^ Z.of_nat m in
  0 <= A < d * M -> 0 <= B < d * M -> 0 <= C < d * M ->
  iu mod M = A / d -> iv mod M = B / d -> iw mod M = C / d ->
  digits m d A B C (Z.testbit f (Z.of_nat m)) = interleave m b0 b1.
Proof.
  intros Hd. induction m as [| m IH]; [reflexivity |]. intros A B C Hm M HA HB HC Hu Hv Hw.
  destruct (highest_bit m d A iu Hd HA Hu) as (eu & Hu' & HA').
  destruct (highest_bit m d B iv Hd HB Hv) as (ev & Hv' & HB').
  destruct (highest_bit m d C iw Hd HC Hw) as (ew & Hw' & HC').
  cbn [digits interleave]. rewrite <- eu, <- ev, <- ew in *.
  assert (Z.of_nat m <? Z.of_nat n = true) as lt by (apply Z.ltb_lt; lia).
  assert (Z.of_nat (S m) = Z.of_nat m + 1) as eS by lia.
  assert (xorb (t_of (Z.testbit iu (Z.of_nat m)) (Z.testbit iv (Z.of_nat m)) (Z.testbit iw (Z.of_nat m)))
    (Z.testbit f (Z.of_nat (S m))) = Z.testbit f (Z.of_nat m)) as ef.
  { rewrite (f_bit (Z.of_nat m)), t_bit, lt, andb_true_r, eS by lia. reflexivity. }
  rewrite ef, (IH _ _ _ ltac:(lia) HA' HB' HC' Hu' Hv' Hw'). f_equal. f_equal.
  unfold bit, truth, b1_of. rewrite ef.
  assert (Z.testbit b0 (Z.of_nat m) = b0_of (Z.testbit iu (Z.of_nat m)) (Z.testbit iw (Z.of_nat m))) as e0.
  { rewrite b0_bit, lt, andb_true_r by lia. reflexivity. }
  unfold b1. rewrite Z.lor_spec, Z.land_spec, Z.lxor_spec, Z.lnot_spec, e0, t_bit, lt, andb_true_r by lia.
  reflexivity.
Qed.

Lemma digits_curve d A B C : 0 < d ->
  0 <= A < d * side n -> 0 <= B < d * side n -> 0 <= C < d * side n ->
  iu mod side n = A / d -> iv mod side n = B / d -> iw mod side n = C / d ->
  digits n d A B C false = curve n iu iv iw.
Proof.
  intros. rewrite <- f_top. apply digits_interleave; auto.
Qed.

End Curve.

Lemma interleave_range n b0 b1 : 0 <= interleave n b0 b1 < 4 ^ Z.of_nat n.
Proof.
  induction n as [| n IH]; [cbn; lia |]. cbn [interleave]. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia.
  unfold bit. destruct (Z.testbit b0 _), (Z.testbit b1 _); lia.
Qed.

Lemma square_range n iu iv upper : 0 <= index_of_square n iu iv upper < 4 ^ Z.of_nat n.
Proof. unfold index_of_square. destruct (grid_square _ _ _ _) as [[a b] c]. apply interleave_range. Qed.
