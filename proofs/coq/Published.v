(* The published code's words of 32 bits, its doublings and its masks give, up to level 16, what words without bounds
   give. *)
From Coq Require Import Lia Lqa.
Require Import Definitions Walk Words.

Lemma word_bit x i : i < 32 -> Z.testbit (word x) i = Z.testbit x i.
Proof. intros H. apply Z.mod_pow2_bits_low. exact H. Qed.

Lemma shifted_bit x k i : 0 <= k -> Z.testbit (Z.shiftl x k) i = Z.testbit x (i - k).
Proof.
  intros H. destruct (Z.lt_ge_cases i 0).
  - rewrite !Z.testbit_neg_r by lia. reflexivity.
  - apply Z.shiftl_spec. assumption.
Qed.

Lemma word_small x : 0 <= x < 2 ^ 32 -> word x = x.
Proof. apply Z.mod_small. Qed.

Lemma bits_below x n i : 0 <= x < 2 ^ n -> 0 <= n <= i -> Z.testbit x i = false.
Proof.
  intros [H0 H1] Hi. rewrite Z.testbit_false by lia.
  rewrite Z.div_small; [reflexivity |]. split; [lia |].
  apply Z.lt_le_trans with (2 ^ n); [lia | apply Z.pow_le_mono_r; lia].
Qed.

(* Four doublings are fifteen shifts, and shifts beyond the word add nothing. *)
Lemma doublings t : prefix_xor32 t = prefix_xor 16 t.
Proof.
  unfold prefix_xor32. cbn [prefix_xor]. rewrite !Z.shiftr_lxor, !Z.shiftr_shiftr by lia.
  cbn [Z.of_nat Pos.of_succ_nat Pos.succ Z.add Pos.add Pos.add_carry]. rewrite Z.lxor_0_l, Z.shiftr_0_r.
  rewrite !Z.lxor_assoc. reflexivity.
Qed.

Lemma no_more_shifts n t k : 0 <= t < 2 ^ Z.of_nat n -> prefix_xor (k + n) t = prefix_xor n t.
Proof.
  intros H. induction k as [| k IH]; [reflexivity |].
  cbn [Nat.add prefix_xor]. rewrite IH, (Z.shiftr_div_pow2 t), Z.div_small, Z.lxor_0_r; [reflexivity | | lia].
  split; [lia |]. apply Z.lt_le_trans with (2 ^ Z.of_nat n); [lia | apply Z.pow_le_mono_r; lia].
Qed.

(* Bits of the two ways to interleave. *)
Lemma interleave_bit n b0 b1 i : 0 <= i ->
  Z.testbit (interleave n b0 b1) i =
  (i <? 2 * Z.of_nat n) && (if Z.even i then Z.testbit b0 (i / 2) else Z.testbit b1 (i / 2)).
Proof.
  intros Hi. induction n as [| n IH].
  - cbn [interleave]. rewrite Z.bits_0. replace (i <? 2 * Z.of_nat 0) with false by (symmetry; apply Z.ltb_ge; lia).
    reflexivity.
  - cbn [interleave]. pose proof (interleave_range n b0 b1) as R. set (low := interleave n b0 b1) in *.
    assert (4 ^ Z.of_nat n = 2 ^ (2 * Z.of_nat n)) as e by (rewrite Z.pow_mul_r by lia; reflexivity).
    rewrite e in *. rewrite (Z.mul_comm (2 ^ _)), Z.add_comm.
    destruct (Z.ltb_spec i (2 * Z.of_nat n)) as [l | l]; cbn [andb] in IH.
    + replace (i <? 2 * Z.of_nat (S n)) with true by (symmetry; apply Z.ltb_lt; lia). rewrite andb_true_l, <- IH.
      rewrite <- (Z.mod_pow2_bits_low _ (2 * Z.of_nat n) i), Z_mod_plus_full, Z.mod_pow2_bits_low by lia. reflexivity.
    + replace i with (i - 2 * Z.of_nat n + 2 * Z.of_nat n) at 1 by lia.
      rewrite <- Z.div_pow2_bits, Z.div_add, Z.div_small, Z.add_0_l by lia. clear IH.
      destruct (Z.ltb_spec i (2 * Z.of_nat (S n))) as [l' | l']; cbn [andb].
      * assert (i = 2 * Z.of_nat n \/ i = 2 * Z.of_nat n + 1) as [-> | ->] by lia.
        -- rewrite Z.sub_diag, Z.even_mul, (Z.mul_comm 2 (Z.of_nat n)), Z.div_mul by lia. cbn [Z.even orb]. unfold bit.
           destruct (Z.testbit b0 _), (Z.testbit b1 _); reflexivity.
        -- replace (2 * Z.of_nat n + 1 - 2 * Z.of_nat n) with 1 by lia.
           rewrite Z.even_add, Z.even_mul, (Z.mul_comm 2 (Z.of_nat n)), Z.div_add_l by lia. cbn [Z.even orb eqb].
           change (1 / 2) with 0. rewrite Z.add_0_r. unfold bit.
           destruct (Z.testbit b0 _), (Z.testbit b1 _); reflexivity.
      * apply (bits_below _ 2); [| lia]. unfold bit. destruct (Z.testbit b0 _), (Z.testbit b1 _); lia.
Qed.

(* Each place of the result by itself. *)
Ltac each_place i n :=
  match n with
  | O => idtac
  | S ?m => destruct (Z.eq_dec i (Z.of_nat m)) as [-> | ?]; [| each_place i m]
  end.

Lemma spread_bit x i : 0 <= x < 2 ^ 16 -> 0 <= i -> Z.testbit (spread32 x) i = Z.even i && Z.testbit x (i / 2).
Proof.
  intros Hx Hi. assert (forall k, 16 <= k -> Z.testbit x k = false) as high by (intros; apply (bits_below x 16); lia).
  destruct (Z.lt_ge_cases i 32) as [l | l].
  - assert (forall k, k < 0 -> Z.testbit x k = false) as low by (intros; apply Z.testbit_neg_r; assumption).
    unfold spread32. rewrite !Z.land_spec, !Z.lor_spec, !word_bit, !shifted_bit by lia.
    rewrite !Z.land_spec, !Z.lor_spec, !word_bit, !shifted_bit by lia.
    rewrite !Z.land_spec, !Z.lor_spec, !word_bit, !shifted_bit by lia.
    rewrite !Z.land_spec, !Z.lor_spec, !word_bit, !shifted_bit by lia.
    generalize dependent (Z.testbit x). intros f high low.
    each_place i 32%nat; [.. | lia];
      (cbv -[orb andb]; rewrite ?andb_false_r, ?andb_true_r, ?orb_false_l, ?orb_false_r;
       repeat match goal with |- context [f ?k] => first [rewrite (high k) by lia | rewrite (low k) by lia] end;
       rewrite ?orb_false_l, ?orb_false_r; reflexivity).
  - assert (16 <= i / 2) as h by (apply Z.div_le_lower_bound; lia).
    unfold spread32. rewrite Z.land_spec, (bits_below 0x55555555 32 i), (high _ h) by lia.
    rewrite !andb_false_r. reflexivity.
Qed.

Lemma bounded x n : 0 <= n -> (forall i, n <= i -> Z.testbit x i = false) -> 0 <= x < 2 ^ n.
Proof.
  intros Hn H. assert (x = x mod 2 ^ n) as ->.
  { apply Z.bits_inj'. intros i Hi. destruct (Z.lt_ge_cases i n).
    - rewrite Z.mod_pow2_bits_low by assumption. reflexivity.
    - rewrite Z.mod_pow2_bits_high, H by lia. reflexivity. }
  apply Z.mod_pos_bound. apply Z.pow_pos_nonneg; lia.
Qed.

Lemma below x n : 0 <= n -> 0 <= x < 2 ^ n -> forall i, n <= i -> Z.testbit x i = false.
Proof. intros. apply (bits_below x n); lia. Qed.

Lemma spread_both n b0 b1 : (n <= 16)%nat -> 0 <= b0 < 2 ^ Z.of_nat n -> 0 <= b1 < 2 ^ Z.of_nat n ->
  Z.lor (spread32 b0) (word (Z.shiftl (spread32 b1) 1)) = interleave n b0 b1.
Proof.
  intros Hn H0 H1. pose proof (below b0 _ (Nat2Z.is_nonneg n) H0) as high0.
  pose proof (below b1 _ (Nat2Z.is_nonneg n) H1) as high1.
  assert (0 <= b0 < 2 ^ 16) as S0 by (apply bounded; [lia | intros; apply high0; lia]).
  assert (0 <= b1 < 2 ^ 16) as S1 by (apply bounded; [lia | intros; apply high1; lia]).
  apply Z.bits_inj'. intros i Hi. rewrite Z.lor_spec, interleave_bit, spread_bit by assumption.
  assert (Z.testbit (word (Z.shiftl (spread32 b1) 1)) i = negb (Z.even i) && Z.testbit b1 (i / 2)) as ->.
  { destruct (Z.lt_ge_cases i 32) as [l | l].
    - rewrite word_bit, shifted_bit by lia. destruct (Z.eq_dec i 0) as [-> | ne].
      + rewrite Z.testbit_neg_r by lia. reflexivity.
      + rewrite spread_bit, Z.even_sub by lia. cbn [Z.even]. destruct (Z.even i) eqn:e; [reflexivity |].
        cbn [eqb negb andb]. f_equal.
        assert (Z.odd i = true) as o by (rewrite <- Z.negb_even, e; reflexivity).
        pose proof (Zdiv2_odd_eqn i) as q. rewrite o in q.
        rewrite !(Z.div2_div) in q. replace (i - 1) with (i / 2 * 2) by lia. apply Z.div_mul. lia.
    - assert (Z.of_nat n <= i / 2) as h by (apply Z.div_le_lower_bound; lia).
      unfold word. rewrite Z.mod_pow2_bits_high, (high1 _ h) by lia. rewrite andb_false_r. reflexivity. }
  destruct (Z.ltb_spec i (2 * Z.of_nat n)) as [l | l].
  - destruct (Z.even i); cbn [andb negb orb]; rewrite ?orb_false_r; reflexivity.
  - assert (Z.of_nat n <= i / 2) as h by (apply Z.div_le_lower_bound; lia).
    rewrite (high0 _ h), (high1 _ h). rewrite !andb_false_r. reflexivity.
Qed.

Lemma curve_published n iu iv iw : (n <= 16)%nat -> 0 <= iu < side n -> 0 <= iv < side n ->
  let b0 := Z.land (not32 (Z.lxor iu (word iw))) (side n - 1) in
  let t := Z.land (Z.lxor iu iv) b0 in
  let f := prefix_xor32 t in
  let b1 := Z.lor (Z.land (Z.lxor f iu) (not32 b0)) t in
  Z.lor (spread32 b0) (word (Z.shiftl (spread32 b1) 1)) = curve n iu iv iw.
Proof.
  intros Hn Hu Hv b0 t f b1. unfold curve.
  assert (b0 = Z.land (Z.lnot (Z.lxor iu iw)) (side n - 1)) as <-.
  { apply Z.bits_inj'. intros i Hi. unfold b0. rewrite !Z.land_spec, low_bits by assumption.
    destruct (Z.ltb_spec i (Z.of_nat n)) as [l | l]; [| rewrite !andb_false_r; reflexivity].
    unfold not32. rewrite word_bit, !Z.lnot_spec, !Z.lxor_spec, word_bit by lia. reflexivity. }
  assert (forall i, Z.of_nat n <= i -> Z.testbit b0 i = false) as high0.
  { intros i Hi. unfold b0. rewrite Z.land_spec, low_bits by lia.
    replace (i <? Z.of_nat n) with false by (symmetry; apply Z.ltb_ge; lia). apply andb_false_r. }
  fold t.
  assert (forall i, Z.of_nat n <= i -> Z.testbit t i = false) as hight.
  { intros i Hi. unfold t. rewrite Z.land_spec, high0 by lia. apply andb_false_r. }
  assert (f = prefix_xor n t) as <-.
  { unfold f. rewrite doublings. replace 16%nat with ((16 - n) + n)%nat by lia.
    apply no_more_shifts, bounded; [lia | exact hight]. }
  assert (forall i, Z.of_nat n <= i -> Z.testbit (Z.lxor f iu) i = false) as highf.
  { intros i Hi. rewrite Z.lxor_spec, (below iu (Z.of_nat n)) by (try apply Hu; try exact Hu; lia).
    unfold f. rewrite doublings, prefix_xor_high; [reflexivity | intros; apply hight; lia | lia]. }
  assert (b1 = Z.lor (Z.land (Z.lxor f iu) (Z.lnot b0)) t) as <-.
  { apply Z.bits_inj'. intros i Hi. unfold b1. rewrite !Z.lor_spec, !Z.land_spec.
    destruct (Z.lt_ge_cases i (Z.of_nat n)) as [l | l].
    - unfold not32. rewrite word_bit by lia. reflexivity.
    - rewrite highf by lia. reflexivity. }
  apply spread_both; [exact Hn | |]; apply bounded; try lia; [exact high0 |].
  intros i Hi. unfold b1. rewrite Z.lor_spec, Z.land_spec, highf, hight by lia. reflexivity.
Qed.

Lemma published_square n iu iv upper : (n <= 16)%nat -> 0 <= iu <= side n -> 0 <= iv <= side n ->
  published_of_square n iu iv upper = index_of_square n iu iv upper.
Proof.
  intros Hn Hu Hv. pose proof (power_pos n) as HN. fold (side n) in HN.
  assert (side n <= 2 ^ 16) as HM by (apply Z.pow_le_mono_r; lia).
  unfold published_of_square, index_of_square, grid_square.
  set (u := if iu <? side n then iu else side n - 1). set (v := if iv <? side n then iv else side n - 1).
  assert (0 <= u < side n) as Hu' by (unfold u; destruct (Z.ltb_spec iu (side n)); lia).
  assert (0 <= v < side n) as Hv' by (unfold v; destruct (Z.ltb_spec iv (side n)); lia).
  rewrite (word_small (u + v)) by lia.
  set (u' := if u + v <? side n then u else u - (u + v - side n + 1)).
  assert (0 <= u' < side n) as Hu'' by (unfold u'; destruct (Z.ltb_spec (u + v) (side n)); lia).
  assert ((if u + v <? side n then u else word (u - (u + v - side n + 1))) = u') as ->.
  { unfold u'. destruct (Z.ltb_spec (u + v) (side n)); [reflexivity |]. apply word_small. lia. }
  rewrite (word_small (u' + v)) by lia.
  assert (forall c : bool, (if c then word (not32 (u' + v) - 1) else not32 (u' + v)) =
    word (if c then Z.lnot (u' + v) - 1 else Z.lnot (u' + v))) as e.
  { intros []; [| reflexivity]. unfold not32, word. apply Zminus_mod_idemp_l. }
  rewrite e. exact (curve_published n u' v _ Hn Hu'' Hv').
Qed.

Lemma published_is_reference u v level : (level <= 16)%nat -> published u v level = reference u v level.
Proof.
  intros Hl. unfold published, reference. pose proof (power_pos level) as HN. fold (side level) in HN.
  assert (0 < inject_Z (side level))%Q as Hq by (change 0%Q with (inject_Z 0); rewrite <- Zlt_Qlt; exact HN).
  assert (forall q, 0 <= Qfloor (inject_Z (side level) * clamp q) <= side level) as H.
  { intros q. assert (0 <= clamp q <= 1)%Q as [l r].
    { unfold clamp. destruct (Qle_bool 0 q) eqn:e0; cbn [negb]; [| lra].
      destruct (Qle_bool q 1) eqn:e1; cbn [negb]; [| lra]. apply Qle_bool_iff in e0, e1. lra. }
    split.
    - change 0 with (Qfloor 0). apply Qfloor_resp_le. apply Qmult_le_0_compat; lra.
    - rewrite <- (Qfloor_Z (side level)) at 2. apply Qfloor_resp_le.
      rewrite <- (Qmult_1_r (inject_Z (side level))) at 2. apply Qmult_le_l; lra. }
  apply published_square; auto.
Qed.
