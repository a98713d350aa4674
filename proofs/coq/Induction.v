(* The induction over the levels still to come: the recursion and the bit formula give the same digits, highest first.
   docs/SOUNDNESS.md, "Every level: the induction", says in words what `related` says here. *)
From Coq Require Import Lia Lqa.
Require Import Definitions Walk Words.

(* A point X, Y, W of a triangle with X+Y+W = E, mid-flip, and the numerators A, B, C of the reference's words.
   The reference takes the micro-triangle that contains the point nudged towards +u and +v.  Upright: floor of X, Y, and
   the greatest whole number below W.  A middle triangle is turned: complements, u and w change places.  On the
   hypotenuse, where such a nudge would leave the triangle: the square below it. *)
Definition related (E X Y W A B C : Z) (mid : bool) : Prop :=
  0 <= X /\ 0 <= Y /\ 0 <= W /\ X + Y + W = E /\
  ((mid = false /\ W = 0 /\ B = Z.min Y (E - 1) /\ A = E - 1 - B /\ C = 0) \/
   (mid = false /\ 0 < W /\ A = X /\ B = Y /\ C = W - 1) \/
   (mid = true /\ 0 < Y /\ 0 < W /\ A = E - W /\ B = E - Y /\ C = E - 1 - X)).

Ltac decide_all :=
  repeat match goal with
    | |- context [?a <? ?b] => destruct (Z.ltb_spec a b)
    | |- context [?a <=? ?b] => destruct (Z.leb_spec a b)
    | |- context [?a =? ?b] => destruct (Z.eqb_spec a b)
  end.

Lemma walk_is_digits n d : 0 < d -> forall X Y W A B C index mid top,
  related (d * 2 ^ Z.of_nat n) X Y W A B C mid ->
  walk n d X Y W index mid top = index * 4 ^ Z.of_nat n + digits n d A B C top.
Proof.
  intros Hd. induction n as [| n IH]; intros X Y W A B C index mid top R; [cbn; lia |].
  rewrite scale_S in R. cbn [walk digits]. pose proof (scale_pos d n Hd) as HD.
  rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia.
  set (D := d * 2 ^ Z.of_nat n) in *. set (P := 4 ^ Z.of_nat n) in *. clearbody D P. clear Hd.
  destruct R as (HX & HY & HW & Hsum & [(-> & -> & -> & -> & ->) | [(-> & HW' & -> & -> & ->) | (-> & HY' & HW' & -> & -> & ->)]]);
    rewrite ?andb_true_r, ?andb_false_r; decide_all; cbn [andb negb]; try lia;
    match goal with
    | |- walk n d ?X ?Y ?W ?i ?m ?t = _ + (_ + digits n d ?A ?B ?C ?above) =>
        rewrite (IH X Y W A B C i m t); [destruct top; cbn [b0_of t_of b1_of truth xorb negb andb orb]; lia |]
    end; unfold related; cbn [negb]; repeat (split; [lia |]);
    solve [left; lia | right; left; lia | right; right; lia].
Qed.

(* What the two algorithms begin with is related. *)

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

Lemma grid_square_words N d X Y : 0 < d -> 0 < N -> 0 <= X -> 0 <= Y -> X + Y <= d * N ->
  exists A B C, related (d * N) X Y (d * N - X - Y) A B C false /\
    (0 <= A < d * N /\ 0 <= B < d * N /\ 0 <= C < d * N) /\
    let '(iu, iv, iw) := grid_square (X / d) (Y / d) (d <=? X mod d + Y mod d) N in
    iu mod N = A / d /\ iv mod N = B / d /\ iw mod N = C / d.
Proof.
  intros Hd HN HX HY HXY.
  pose proof (Z.div_mod X d ltac:(lia)) as eX. pose proof (Z.mod_pos_bound X d ltac:(lia)) as rX.
  pose proof (Z.div_mod Y d ltac:(lia)) as eY. pose proof (Z.mod_pos_bound Y d ltac:(lia)) as rY.
  set (iu := X / d) in *. set (iv := Y / d) in *. set (uf := X mod d) in *. set (vf := Y mod d) in *.
  assert (0 <= iu) by (apply Z.div_pos; lia). assert (0 <= iv) by (apply Z.div_pos; lia).
  destruct (Z.eq_dec (X + Y) (d * N)) as [e | e].
  - (* The hypotenuse: iu + iv is N, or N-1 with uf + vf = d. *)
    exists (d * N - 1 - Z.min Y (d * N - 1)), (Z.min Y (d * N - 1)), 0.
    split; [unfold related; repeat (split; [lia |]); left; lia |]. split; [lia |].
    assert (Z.min Y (d * N - 1) / d = Z.min iv (N - 1)) as eB.
    { destruct (Z.min_spec iv (N - 1)) as [[l ->] | [l ->]].
      - rewrite Z.min_l by nia. reflexivity.
      - symmetry. apply Z.div_unique with (Z.min Y (d * N - 1) - d * (N - 1)); [left; nia | lia]. }
    assert ((d * N - 1 - Z.min Y (d * N - 1)) / d = N - 1 - Z.min iv (N - 1)) as eA.
    { rewrite <- eB. set (B := Z.min Y (d * N - 1)).
      pose proof (Z.div_mod B d ltac:(lia)). pose proof (Z.mod_pos_bound B d ltac:(lia)).
      symmetry. apply Z.div_unique with (d - 1 - B mod d); [left; lia | nia]. }
    assert (iu + iv = N \/ iu + iv = N - 1) as s by nia.
    rewrite eA, eB, Z.div_0_l by lia. unfold grid_square, Z.lnot.
    replace (_ && _) with false.
    + destruct s as [s | s]; decide_all; try lia;
        repeat split; try (rewrite Z.mod_small; lia);
        match goal with |- Z.pred (- ?x) mod N = 0 => replace (Z.pred (- x)) with (0 + -1 * N) by lia end;
        rewrite Z_mod_plus_full; apply Z.mod_small; lia.
    + symmetry. apply andb_false_intro2. apply Z.ltb_ge. decide_all; lia.
  - exists X, Y, (d * N - X - Y - 1).
    split; [unfold related; repeat (split; [lia |]); right; left; lia |]. split; [lia |].
    assert (iu + iv < N) as s by nia.
    unfold grid_square, Z.lnot. fold iu iv.
    assert (iu mod N = iu) by (apply Z.mod_small; lia). assert (iv mod N = iv) by (apply Z.mod_small; lia).
    replace (iu <? N) with true by (symmetry; apply Z.ltb_lt; lia).
    replace (iv <? N) with true by (symmetry; apply Z.ltb_lt; lia).
    replace (iu + iv <? N) with true by (symmetry; apply Z.ltb_lt; lia).
    repeat (split; [assumption |]).
    destruct (Z.leb_spec d (uf + vf)) as [l | l]; cbn [andb].
    + assert (iu + iv < N - 1) as s' by nia. rewrite (proj2 (Z.ltb_lt _ _) s').
      replace (Z.pred (- (iu + iv)) - 1) with (N - 2 - (iu + iv) + -1 * N) by lia.
      rewrite Z_mod_plus_full, Z.mod_small by lia. apply Z.div_unique with (2 * d - 1 - uf - vf); [left; lia | lia].
    + replace (Z.pred (- (iu + iv))) with (N - 1 - (iu + iv) + -1 * N) by lia.
      rewrite Z_mod_plus_full, Z.mod_small by lia. apply Z.div_unique with (d - 1 - uf - vf); [left; lia | nia].
Qed.

Lemma clamp_in_unit q : (0 <= q <= 1)%Q -> clamp q = q.
Proof.
  intros [H0 H1]. unfold clamp. apply Qle_bool_iff in H0, H1. rewrite H0, H1. reflexivity.
Qed.

Theorem step_is_reference u v level : in_triangle u v -> uv2index u v level = reference u v level.
Proof.
  intros (Hu & Hv & Huv).
  set (d := Z.pos (Qden u * Qden v)). assert (0 < d) as Hd by reflexivity.
  set (N := side level). assert (0 < N) as HN by apply power_pos.
  set (X := Qnum u * Z.pos (Qden v) * N). set (Y := Qnum v * Z.pos (Qden u) * N).
  assert (u * inject_Z (d * N) == inject_Z X)%Q as eX.
  { unfold Qeq, X, d, inject_Z. cbn [Qnum Qden Qmult]. rewrite !Pos2Z.inj_mul. ring. }
  assert (v * inject_Z (d * N) == inject_Z Y)%Q as eY.
  { unfold Qeq, Y, d, inject_Z. cbn [Qnum Qden Qmult]. rewrite !Pos2Z.inj_mul. ring. }
  assert (0 <= X) as HX by (unfold X; apply Z.mul_nonneg_nonneg; [unfold Qle in Hu; cbn in Hu |]; lia).
  assert (0 <= Y) as HY by (unfold Y; apply Z.mul_nonneg_nonneg; [unfold Qle in Hv; cbn in Hv |]; lia).
  assert (0 < inject_Z (d * N))%Q as Hq by (change 0%Q with (inject_Z 0); rewrite <- Zlt_Qlt; lia).
  assert (X + Y <= d * N) as HXY.
  { rewrite Zle_Qle, inject_Z_plus, <- eX, <- eY.
    apply Qle_trans with ((u + v) * inject_Z (d * N))%Q; [lra |].
    apply Qle_trans with (1 * inject_Z (d * N))%Q; [| lra]. apply Qmult_le_compat_r; lra. }
  destruct (grid_square_words N d X Y Hd HN HX HY HXY) as (A & B & C & R & (HA & HB & HC) & words).
  unfold uv2index. rewrite (step_is_walk level d Hd _ _ _ X Y (d * N - X - Y)).
  - rewrite (walk_is_digits level d Hd _ _ _ A B C) by exact R.
    unfold reference. rewrite !clamp_in_unit by (split; lra). fold N.
    assert ((inject_Z N * u) * inject_Z d == inject_Z X)%Q as fX by (rewrite <- eX, inject_Z_mult; ring).
    assert ((inject_Z N * v) * inject_Z d == inject_Z Y)%Q as fY by (rewrite <- eY, inject_Z_mult; ring).
    rewrite (floor_fraction X d _ Hd fX), (floor_fraction Y d _ Hd fY), (upper_half X Y d _ _ Hd fX fY).
    unfold index_of_square. fold N. destruct (grid_square _ _ _ N) as [[iu iv] iw].
    destruct words as (wu & wv & ww). cbn [Z.mul Z.add]. apply digits_curve with (d := d); assumption.
  - exact eX.
  - exact eY.
  - unfold is. fold (side level). fold N.
    setoid_replace ((1 - u - v) * inject_Z (d * N))%Q
      with (inject_Z (d * N) - u * inject_Z (d * N) - v * inject_Z (d * N))%Q by ring.
    rewrite eX, eY. unfold Z.sub. rewrite !inject_Z_plus, !inject_Z_opp. reflexivity.
  - fold (side level). fold N. lia.
Qed.
