(* Algorithm 4 in whole numbers.  With u = X/(d 2^n), n the levels to come, halving a triangle leaves its numerators X
   alone or takes d 2^(n-1) from them: no fraction is formed, and everything is linear. *)
From Coq Require Import Lia Lqa.
Require Import Definitions.

(* The steps to come are n; E = d 2^n, X + Y + W = E. *)
Fixpoint walk (n : nat) (d X Y W index : Z) (mid top : bool) : Z :=
  match n with
  | O => index
  | S n =>
      let D := d * 2 ^ Z.of_nat n in
      if D <? W then walk n d X Y (W - D) (4 * index + if top then 2 else 0) mid top
      else if (D <=? Y) && negb ((Y =? D) && mid) then walk n d X (Y - D) W (4 * index + 3) mid (negb top)
      else if (D <=? X) && negb ((Y =? D) && mid) then walk n d (X - D) Y W (4 * index + if top then 0 else 2) mid top
      else walk n d (D - W) (D - Y) (D - X) (4 * index + 1) (negb mid) top
  end.

Lemma power_S n : 2 ^ Z.of_nat (S n) = 2 * 2 ^ Z.of_nat n.
Proof. rewrite Nat2Z.inj_succ, Z.pow_succ_r; lia. Qed.

Lemma power_pos n : 0 < 2 ^ Z.of_nat n.
Proof. apply Z.pow_pos_nonneg; lia. Qed.

Lemma scale_S d n : d * 2 ^ Z.of_nat (S n) = 2 * (d * 2 ^ Z.of_nat n).
Proof. rewrite power_S; ring. Qed.

Lemma scale_pos d n : 0 < d -> 0 < d * 2 ^ Z.of_nat n.
Proof. intros; apply Z.mul_pos_pos; auto using power_pos. Qed.

(* q = X/(2D), said without a division. *)
Definition is (q : Q) (X E : Z) : Prop := (q * inject_Z E == inject_Z X)%Q.

Lemma compare_half q X D : 0 < D -> is q X (2 * D) -> (q ?= half)%Q = (X ?= D).
Proof.
  unfold is, half. intros HD H. rewrite inject_Z_mult in H.
  assert (0 < inject_Z D)%Q as HD' by (change 0%Q with (inject_Z 0); rewrite <- Zlt_Qlt; exact HD).
  destruct (Z.compare_spec X D) as [e | l | l].
  - subst. apply Qeq_alt. apply Qmult_inj_r with (inject_Z D); [lra |]. change (inject_Z 2) with 2%Q in H. lra.
  - apply Qlt_alt. apply Qmult_lt_r with (inject_Z D); [exact HD' |].
    rewrite Zlt_Qlt in l. change (inject_Z 2) with 2%Q in H. lra.
  - apply Qgt_alt. apply Qmult_lt_r with (inject_Z D); [exact HD' |].
    rewrite Zlt_Qlt in l. change (inject_Z 2) with 2%Q in H. lra.
Qed.

Lemma le_by_compare (x y : Q) : Qle_bool x y = match (x ?= y)%Q with Gt => false | _ => true end.
Proof. unfold Qle_bool, Qcompare, Z.leb. reflexivity. Qed.

Lemma eq_by_compare (x y : Q) : Qeq_bool x y = match (x ?= y)%Q with Eq => true | _ => false end.
Proof. unfold Qeq_bool, Qcompare, Zeq_bool. reflexivity. Qed.

Lemma greater_half q X D : 0 < D -> is q X (2 * D) -> (q >? half)%Q = (D <? X).
Proof.
  intros HD H. rewrite le_by_compare, (compare_half q X D HD H), Z.ltb_compare, (Z.compare_antisym X D).
  destruct (X ?= D); reflexivity.
Qed.

Lemma at_least_half q X D : 0 < D -> is q X (2 * D) -> (q >=? half)%Q = (D <=? X).
Proof.
  intros HD H.
  rewrite le_by_compare, <- (Qcompare_antisym q half), (compare_half q X D HD H).
  rewrite Z.leb_compare, (Z.compare_antisym X D).
  destruct (X ?= D); reflexivity.
Qed.

Lemma equals_half q X D : 0 < D -> is q X (2 * D) -> (q =? half)%Q = (X =? D).
Proof.
  intros HD H. rewrite eq_by_compare, (compare_half q X D HD H), Z.eqb_compare. destruct (X ?= D); reflexivity.
Qed.

(* The new coordinates: 2q, and the sums of three. *)
Ltac scaled :=
  unfold is in *; rewrite ?inject_Z_mult in *; change (inject_Z 2) with 2%Q in *;
  unfold Z.sub; rewrite ?inject_Z_plus, ?inject_Z_opp; lra.

Lemma step_is_walk n d : 0 < d -> forall u v w X Y W index mid top,
  is u X (d * 2 ^ Z.of_nat n) -> is v Y (d * 2 ^ Z.of_nat n) -> is w W (d * 2 ^ Z.of_nat n) ->
  X + Y + W = d * 2 ^ Z.of_nat n -> step n u v w index mid top = walk n d X Y W index mid top.
Proof.
  intros Hd. induction n as [| n IH]; intros u v w X Y W index mid top Hu Hv Hw Hsum; [reflexivity |].
  rewrite scale_S in *. cbn [step walk]. pose proof (scale_pos d n Hd) as HD.
  set (D := d * 2 ^ Z.of_nat n) in *.
  unfold is in Hu, Hv, Hw. rewrite <- (Qred_correct u) in Hu. rewrite <- (Qred_correct v) in Hv.
  rewrite <- (Qred_correct w) in Hw.
  generalize dependent (Qred u). generalize dependent (Qred v). generalize dependent (Qred w). clear u v w.
  intros w Hw v Hv u Hu.
  rewrite (greater_half w W D HD Hw), (at_least_half v Y D HD Hv), (at_least_half u X D HD Hu),
    (equals_half v Y D HD Hv).
  assert (inject_Z X + inject_Z Y + inject_Z W == 2 * inject_Z D)%Q as Hq.
  { rewrite <- !inject_Z_plus, Hsum, inject_Z_mult. reflexivity. }
  destruct top;
    (destruct (D <? W); [apply IH; try scaled; lia |]);
    (destruct ((D <=? Y) && negb ((Y =? D) && mid)); [apply IH; try scaled; lia |]);
    (destruct ((D <=? X) && negb ((Y =? D) && mid)); [apply IH; try scaled; lia |]);
    apply IH; try scaled; lia.
Qed.
