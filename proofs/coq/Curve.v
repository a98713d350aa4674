(* The order along the curve: digits of deeper levels follow, and neighbours in the order touch. *)
From Coq Require Import Lia.
Require Import Definitions.

(* One step takes one digit, whatever the number of steps to come. *)
Lemma step_S u v w index mid top : exists u' v' w' digit mid' top', 0 <= digit < 4 /\
  forall n, step (S n) u v w index mid top = step n u' v' w' (4 * index + digit) mid' top'.
Proof.
  cbn [step].
  destruct top;
    (destruct (Qred w >? half)%Q; [do 6 eexists; (split; [| reflexivity]); lia |]);
    (destruct ((Qred v >=? half)%Q && negb ((Qred v =? half)%Q && mid));
      [do 6 eexists; (split; [| reflexivity]); lia |]);
    (destruct ((Qred u >=? half)%Q && negb ((Qred v =? half)%Q && mid));
      [do 6 eexists; (split; [| reflexivity]); lia |]);
    do 6 eexists; (split; [| reflexivity]); lia.
Qed.

Lemma step_nested n : forall u v w index mid top,
  step (S n) u v w index mid top / 4 = step n u v w index mid top.
Proof.
  induction n as [| n IH]; intros u v w index mid top;
    destruct (step_S u v w index mid top) as (u' & v' & w' & digit & mid' & top' & H & e); rewrite e.
  - cbn [step]. symmetry. apply Z.div_unique with digit; lia.
  - rewrite IH, e. reflexivity.
Qed.

Lemma step_range n : forall u v w index mid top,
  index * 4 ^ Z.of_nat n <= step n u v w index mid top < (index + 1) * 4 ^ Z.of_nat n.
Proof.
  induction n as [| n IH]; intros; [cbn; lia |].
  destruct (step_S u v w index mid top) as (u' & v' & w' & digit & mid' & top' & H & e). rewrite e.
  specialize (IH u' v' w' (4 * index + digit) mid' top'). rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. nia.
Qed.

(* Entry and exit of a triangle that is cut n times: its first micro-triangle begins at P0, its last ends at P2. *)

Lemma power4_pos n : 0 < 4 ^ Z.of_nat n.
Proof. apply Z.pow_pos_nonneg; lia. Qed.

Lemma digits_of_k n k :
  k mod 4 ^ Z.of_nat (S n) = ((k / 4 ^ Z.of_nat n) mod 4) * 4 ^ Z.of_nat n + k mod 4 ^ Z.of_nat n.
Proof.
  pose proof (power4_pos n). rewrite Nat2Z.inj_succ, Z.pow_succ_r, (Z.mul_comm 4), Z.rem_mul_r by lia. ring.
Qed.

Lemma descend_first n : forall P k, k mod 4 ^ Z.of_nat n = 0 -> P0_of (descend n P k) = P0_of P.
Proof.
  induction n as [| n IH]; intros P k H; [reflexivity |]. rewrite digits_of_k in H. pose proof (power4_pos n).
  pose proof (Z.mod_pos_bound (k / 4 ^ Z.of_nat n) 4 ltac:(lia)).
  pose proof (Z.mod_pos_bound k (4 ^ Z.of_nat n) ltac:(lia)).
  cbn [descend]. rewrite IH by nia. replace ((k / 4 ^ Z.of_nat n) mod 4) with 0 by nia.
  destruct P as [[P0 P1] P2]. reflexivity.
Qed.

Lemma descend_last n : forall P k, k mod 4 ^ Z.of_nat n = 4 ^ Z.of_nat n - 1 -> P2_of (descend n P k) = P2_of P.
Proof.
  induction n as [| n IH]; intros P k H; [reflexivity |]. rewrite digits_of_k in H. pose proof (power4_pos n).
  pose proof (Z.mod_pos_bound (k / 4 ^ Z.of_nat n) 4 ltac:(lia)).
  pose proof (Z.mod_pos_bound k (4 ^ Z.of_nat n) ltac:(lia)).
  rewrite Nat2Z.inj_succ, Z.pow_succ_r in H by lia.
  cbn [descend]. rewrite IH by nia. replace ((k / 4 ^ Z.of_nat n) mod 4) with 3 by nia.
  destruct P as [[P0 P1] P2]. reflexivity.
Qed.

Lemma succ_digits n k : k mod 4 ^ Z.of_nat n <> 4 ^ Z.of_nat n - 1 ->
  (k + 1) / 4 ^ Z.of_nat n = k / 4 ^ Z.of_nat n /\ (k + 1) mod 4 ^ Z.of_nat n = k mod 4 ^ Z.of_nat n + 1.
Proof.
  intros H. pose proof (power4_pos n). pose proof (Z.mod_pos_bound k (4 ^ Z.of_nat n) ltac:(lia)).
  pose proof (Z.div_mod k (4 ^ Z.of_nat n) ltac:(lia)).
  split; symmetry; [apply Z.div_unique with (k mod 4 ^ Z.of_nat n + 1) | apply Z.mod_unique with (k / 4 ^ Z.of_nat n)];
    lia.
Qed.

Lemma succ_carry n k : k mod 4 ^ Z.of_nat n = 4 ^ Z.of_nat n - 1 ->
  (k + 1) / 4 ^ Z.of_nat n = k / 4 ^ Z.of_nat n + 1 /\ (k + 1) mod 4 ^ Z.of_nat n = 0.
Proof.
  intros H. pose proof (power4_pos n). pose proof (Z.div_mod k (4 ^ Z.of_nat n) ltac:(lia)).
  split; symmetry; [apply Z.div_unique with 0 | apply Z.mod_unique with (k / 4 ^ Z.of_nat n + 1)]; lia.
Qed.

(* Where one micro-triangle ends the next begins. *)
Lemma descend_contiguous n : forall P k, k mod 4 ^ Z.of_nat n <> 4 ^ Z.of_nat n - 1 ->
  P2_of (descend n P k) = P0_of (descend n P (k + 1)).
Proof.
  induction n as [| n IH]; intros P k H; [rewrite Z.mod_1_r in H; cbn in H; lia |].
  rewrite digits_of_k, Nat2Z.inj_succ, Z.pow_succ_r in H by lia. cbn [descend].
  destruct (Z.eq_dec (k mod 4 ^ Z.of_nat n) (4 ^ Z.of_nat n - 1)) as [e | e].
  - destruct (succ_carry n k e) as [ed em]. rewrite descend_last, descend_first by assumption. rewrite ed.
    rewrite <- Zplus_mod_idemp_l.
    pose proof (Z.mod_pos_bound (k / 4 ^ Z.of_nat n) 4 ltac:(lia)). pose proof (power4_pos n).
    set (c := (k / 4 ^ Z.of_nat n) mod 4) in *. assert (c <> 3) as Hc by nia.
    destruct P as [[P0 P1] P2].
    assert (c = 0 \/ c = 1 \/ c = 2) as [-> | [-> | ->]] by lia; reflexivity.
  - rewrite (proj1 (succ_digits n k e)). apply IH; exact e.
Qed.
