(* From points in rationals to their numerators, and the two algorithms from there on. *)
From Coq Require Import Lia Lqa.
Require Import Definitions Walk Words Induction.

Lemma floor_fraction a d x : 0 < d -> (x * inject_Z d == inject_Z a)%Q -> Qfloor x = a / d.
Proof.
  intros Hd H. destruct d as [| d | d]; try lia.
  rewrite (Qfloor_comp x (a # d)); [reflexivity |].
  apply Qmult_inj_r with (inject_Z (Z.pos d)).
  - intros e. unfold Qeq in e. cbn in e. lia.
  - rewrite H. unfold Qeq. cbn. lia.
Qed.

(* uf+vf >= 1, by the remainders. *)
Lemma upper_half a b d x y : 0 < d -> (x * inject_Z d == inject_Z a)%Q -> (y * inject_Z d == inject_Z b)%Q ->
  (x - inject_Z (a / d) + (y - inject_Z (b / d)) >=? 1)%Q = (d <=? a mod d + b mod d).
Proof.
  intros Hd Ha Hb.
  assert (0 < inject_Z d)%Q as Hq by (change 0%Q with (inject_Z 0); rewrite <- Zlt_Qlt; exact Hd).
  assert ((x - inject_Z (a / d) + (y - inject_Z (b / d))) * inject_Z d == inject_Z (a mod d + b mod d))%Q as e.
  { rewrite !Z.mod_eq by lia. unfold Z.sub. rewrite !inject_Z_plus, !inject_Z_opp, !inject_Z_mult.
    rewrite <- Ha, <- Hb. ring. }
  apply eq_true_iff_eq. rewrite Qle_bool_iff, Z.leb_le. split; intros l.
  - apply Qmult_le_compat_r with (z := inject_Z d) in l; [| lra].
    rewrite e, Qmult_1_l, <- Zle_Qle in l. exact l.
  - apply Qmult_le_r with (inject_Z d); [exact Hq |]. rewrite e, Qmult_1_l, <- Zle_Qle. exact l.
Qed.

Lemma clamp_in_unit q : (0 <= q <= 1)%Q -> clamp q = q.
Proof.
  intros [H0 H1]. unfold clamp. apply Qle_bool_iff in H0, H1. rewrite H0, H1. reflexivity.
Qed.

(* u = X/(d N), v = Y/(d N). *)
Record numerators (u v : Q) (N d X Y : Z) : Prop := {
  d_pos : 0 < d;
  X_nonneg : 0 <= X;
  Y_nonneg : 0 <= Y;
  sum_at_most : X + Y <= d * N;
  u_is : is u X (d * N);
  v_is : is v Y (d * N)
}.

Lemma has_numerators u v level : in_triangle u v -> exists d X Y, numerators u v (side level) d X Y.
Proof.
  intros (Hu & Hv & Huv).
  set (d := Z.pos (Qden u * Qden v)). assert (0 < d) as Hd by reflexivity.
  set (N := side level). assert (0 < N) as HN by apply power_pos.
  set (X := Qnum u * Z.pos (Qden v) * N). set (Y := Qnum v * Z.pos (Qden u) * N).
  assert (u * inject_Z (d * N) == inject_Z X)%Q as eX.
  { unfold Qeq, X, d, inject_Z. cbn [Qnum Qden Qmult]. rewrite !Pos2Z.inj_mul. ring. }
  assert (v * inject_Z (d * N) == inject_Z Y)%Q as eY.
  { unfold Qeq, Y, d, inject_Z. cbn [Qnum Qden Qmult]. rewrite !Pos2Z.inj_mul. ring. }
  assert (0 < inject_Z (d * N))%Q as Hq by (change 0%Q with (inject_Z 0); rewrite <- Zlt_Qlt; lia).
  exists d, X, Y. split; try assumption.
  - unfold X. unfold Qle in Hu. cbn in Hu. apply Z.mul_nonneg_nonneg; lia.
  - unfold Y. unfold Qle in Hv. cbn in Hv. apply Z.mul_nonneg_nonneg; lia.
  - rewrite Zle_Qle, inject_Z_plus, <- eX, <- eY.
    apply Qle_trans with ((u + v) * inject_Z (d * N))%Q; [lra |].
    apply Qle_trans with (1 * inject_Z (d * N))%Q; [| lra]. apply Qmult_le_compat_r; lra.
Qed.

Lemma uv2index_is_walk u v level d X Y : numerators u v (side level) d X Y ->
  uv2index u v level = walk level d X Y (d * side level - X - Y) 0 false false.
Proof.
  intros [Hd HX HY HXY eX eY]. apply (step_is_walk level d Hd); auto.
  - unfold is in *. fold (side level).
    setoid_replace ((1 - u - v) * inject_Z (d * side level))%Q
      with (inject_Z (d * side level) - u * inject_Z (d * side level) - v * inject_Z (d * side level))%Q by ring.
    rewrite eX, eY. unfold Z.sub. rewrite !inject_Z_plus, !inject_Z_opp. reflexivity.
  - fold (side level). lia.
Qed.

Lemma unit_numerator q X E : 0 < E -> 0 <= X <= E -> is q X E -> (0 <= q <= 1)%Q.
Proof.
  unfold is. intros HE HX e.
  assert (0 < inject_Z E)%Q as Hq by (change 0%Q with (inject_Z 0); rewrite <- Zlt_Qlt; exact HE).
  split; apply Qmult_le_r with (inject_Z E); try exact Hq; rewrite e.
  - rewrite Qmult_0_l. change 0%Q with (inject_Z 0). rewrite <- Zle_Qle. lia.
  - rewrite Qmult_1_l, <- Zle_Qle. lia.
Qed.

Lemma reference_is_square u v level d X Y : numerators u v (side level) d X Y ->
  reference u v level = index_of_square level (X / d) (Y / d) (d <=? X mod d + Y mod d).
Proof.
  intros [Hd HX HY HXY eX eY]. assert (0 < side level) as HN by apply power_pos.
  unfold reference.
  rewrite (clamp_in_unit u) by (apply (unit_numerator u X (d * side level)); [| | exact eX]; lia).
  rewrite (clamp_in_unit v) by (apply (unit_numerator v Y (d * side level)); [| | exact eY]; lia).
  unfold is in *.
  assert ((inject_Z (side level) * u) * inject_Z d == inject_Z X)%Q as fX by (rewrite <- eX, inject_Z_mult; ring).
  assert ((inject_Z (side level) * v) * inject_Z d == inject_Z Y)%Q as fY by (rewrite <- eY, inject_Z_mult; ring).
  rewrite (floor_fraction X d _ Hd fX), (floor_fraction Y d _ Hd fY), (upper_half X Y d _ _ Hd fX fY).
  reflexivity.
Qed.

Theorem step_is_reference u v level : in_triangle u v -> uv2index u v level = reference u v level.
Proof.
  intros T. destruct (has_numerators u v level T) as (d & X & Y & H).
  rewrite (uv2index_is_walk _ _ _ _ _ _ H), (reference_is_square _ _ _ _ _ _ H).
  destruct H. apply walk_is_square; assumption.
Qed.
