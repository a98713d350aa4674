(* The induction over the levels still to come: the recursion and the bit formula give the same digits, highest first.
   docs/SOUNDNESS.md, "Every level: the induction", says in words what `related` says here. *)
From Coq Require Import Lia.
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
  destruct R as (HX & HY & HW & Hsum &
    [(-> & -> & -> & -> & ->) | [(-> & HW' & -> & -> & ->) | (-> & HY' & HW' & -> & -> & ->)]]);
    rewrite ?andb_true_r, ?andb_false_r; decide_all; cbn [andb negb]; try lia;
    match goal with
    | |- walk n d ?X ?Y ?W ?i ?m ?t = _ + (_ + digits n d ?A ?B ?C ?above) =>
        rewrite (IH X Y W A B C i m t); [destruct top; cbn [b0_of t_of b1_of truth xorb negb andb orb]; lia |]
    end; unfold related; cbn [negb]; repeat (split; [lia |]);
    solve [left; lia | right; left; lia | right; right; lia].
Qed.

(* What the two algorithms begin with is related: d N = E, and X/d, Y/d are uN, vN. *)

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

(* From the numerators X, Y of a point on: the index by either algorithm. *)
Lemma walk_is_square n d X Y : 0 < d -> 0 <= X -> 0 <= Y -> X + Y <= d * side n ->
  walk n d X Y (d * side n - X - Y) 0 false false =
  index_of_square n (X / d) (Y / d) (d <=? X mod d + Y mod d).
Proof.
  intros Hd HX HY HXY.
  destruct (grid_square_words (side n) d X Y Hd (power_pos n) HX HY HXY) as (A & B & C & R & (HA & HB & HC) & words).
  rewrite (walk_is_digits n d Hd _ _ _ A B C) by exact R. unfold index_of_square.
  destruct (grid_square _ _ _ (side n)) as [[iu iv] iw]. destruct words as (wu & wv & ww).
  cbn [Z.mul Z.add]. apply digits_curve with (d := d); assumption.
Qed.
