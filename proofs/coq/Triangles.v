(* The micro-triangle of an index: where `descend` goes, and that Algorithm 4 goes there as well. *)
From Coq Require Import Lia.
Require Import Definitions Walk Words Induction.

(* The half of a square with lower left corner (x, y) and side s that mid and top describe: mid is the upper half, top
   says that P0 and P1 have changed places. *)
Definition half_square (mid top : bool) (s x y : Z) : triangle :=
  match mid, top with
  | false, false => ((x, y), (x + s, y), (x, y + s))
  | false, true => ((x + s, y), (x, y), (x, y + s))
  | true, false => ((x, y + s), (x + s, y + s), (x + s, y))
  | true, true => ((x + s, y + s), (x, y + s), (x + s, y))
  end.

(* Its child: mid, top, x and y, for side 2h. *)
Definition child_square (mid top : bool) (h x y digit : Z) : bool * bool * Z * Z :=
  if digit =? 1 then (negb mid, top, if mid then x + h else x, if mid then y + h else y)
  else if digit =? 3 then (mid, negb top, if mid then x + h else x, if mid then y else y + h)
  else if (digit =? 0) && negb top || negb (digit =? 0) && top
  then (mid, top, x, if mid then y + h else y)
  else (mid, top, x + h, if mid then y + h else y).

Lemma middle_of a b c e x y : a + b = 2 * x -> c + e = 2 * y -> middle (a, c) (b, e) = (x, y).
Proof.
  intros H1 H2. unfold middle. cbn [fst snd]. rewrite H1, H2, !(Z.mul_comm 2), !Z.div_mul by lia. reflexivity.
Qed.

Ltac vertices :=
  repeat match goal with
    | |- middle _ _ = (_, _) => apply middle_of; lia
    | |- (_, _) = (_, _) => f_equal
    | |- @eq Z _ _ => lia
    | |- @eq bool _ _ => reflexivity
  end.

Lemma child_is_square mid top h x y digit : 0 <= digit < 4 ->
  let '(mid', top', x', y') := child_square mid top h x y digit in
  child (half_square mid top (2 * h) x y) digit = half_square mid' top' h x' y'.
Proof.
  intros H. assert (digit = 0 \/ digit = 1 \/ digit = 2 \/ digit = 3) as [-> | [-> | [-> | ->]]] by lia;
    destruct mid, top; cbn -[Z.add Z.mul Z.div middle]; vertices.
Qed.

(* The point (U/d, V/d) of the half square (x, y) of side s has numerators X, Y, W. *)
Definition located (mid : bool) (d s x y U V X Y W : Z) : Prop :=
  X + Y + W = d * s /\ U = d * x + (if mid then d * s - W else X) /\ V = d * y + (if mid then d * s - Y else Y).

(* One step: its digit, and where the next ones go on. *)
Lemma walk_S n d X Y W index mid top : exists X' Y' W' digit mid' top',
  walk (S n) d X Y W index mid top = walk n d X' Y' W' (4 * index + digit) mid' top' /\ (0 <= digit < 4) /\
  (0 <= X -> 0 <= Y -> 0 <= W -> X + Y + W = 2 * (d * 2 ^ Z.of_nat n) ->
   0 <= X' /\ 0 <= Y' /\ 0 <= W' /\ X' + Y' + W' = d * 2 ^ Z.of_nat n) /\
  forall x y h U V, d * h = d * 2 ^ Z.of_nat n -> located mid d (2 * h) x y U V X Y W ->
  let '(m, t, x', y') := child_square mid top h x y digit in
  m = mid' /\ t = top' /\ located mid' d h x' y' U V X' Y' W'.
Proof.
  cbn [walk]. set (D := d * 2 ^ Z.of_nat n).
  destruct (Z.ltb_spec D W).
  { do 6 eexists. split; [reflexivity |]. split; [destruct top; lia |]. split; [intros; lia |].
    unfold located. intros x y h U V <-. destruct mid, top; cbn -[Z.add Z.sub Z.mul]; intros; repeat split; lia. }
  destruct ((D <=? Y) && negb ((Y =? D) && mid)) eqn:eY.
  { do 6 eexists. split; [reflexivity |]. split; [lia |]. apply andb_true_iff in eY. destruct eY as [eY _].
    apply Z.leb_le in eY. split; [intros; lia |].
    unfold located. intros x y h U V <-. destruct mid, top; cbn -[Z.add Z.sub Z.mul]; intros; repeat split; lia. }
  destruct ((D <=? X) && negb ((Y =? D) && mid)) eqn:eX.
  { do 6 eexists. split; [reflexivity |]. split; [destruct top; lia |]. apply andb_true_iff in eX.
    destruct eX as [eX _]. apply Z.leb_le in eX. split; [intros; lia |].
    unfold located. intros x y h U V <-. destruct mid, top; cbn -[Z.add Z.sub Z.mul]; intros; repeat split; lia. }
  do 6 eexists. split; [reflexivity |]. split; [lia |]. split.
  - intros. destruct (Z.leb_spec D Y), (Z.eqb_spec Y D), (Z.leb_spec D X), mid; cbn in eX, eY; try discriminate; lia.
  - unfold located. intros x y h U V <-. destruct mid, top; cbn -[Z.add Z.sub Z.mul]; intros; repeat split; lia.
Qed.

Lemma walk_range n d : forall X Y W index mid top,
  index * 4 ^ Z.of_nat n <= walk n d X Y W index mid top < (index + 1) * 4 ^ Z.of_nat n.
Proof.
  induction n as [| n IH]; intros; [cbn; lia |].
  destruct (walk_S n d X Y W index mid top) as (X' & Y' & W' & digit & mid' & top' & -> & Hd & _).
  specialize (IH X' Y' W' (4 * index + digit) mid' top').
  rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. nia.
Qed.

(* Down: the micro-triangle of Algorithm 4's index holds the point. *)
Lemma descend_walk n d : 0 < d -> forall X Y W index mid top x y U V,
  0 <= X -> 0 <= Y -> 0 <= W -> located mid d (2 ^ Z.of_nat n) x y U V X Y W ->
  exists mid' top' x' y' X' Y' W', 0 <= X' /\ 0 <= Y' /\ 0 <= W' /\
  descend n (half_square mid top (2 ^ Z.of_nat n) x y) (walk n d X Y W index mid top) =
    half_square mid' top' 1 x' y' /\
  located mid' d 1 x' y' U V X' Y' W'.
Proof.
  intros Hd. induction n as [| n IH]; intros X Y W index mid top x y U V HX HY HW L.
  - exists mid, top, x, y, X, Y, W. repeat split; try assumption; apply L.
  - destruct (walk_S n d X Y W index mid top) as (X' & Y' & W' & digit & mid' & top' & -> & Hdigit & Hsum & Hloc).
    rewrite power_S in *.
    assert (X + Y + W = 2 * (d * 2 ^ Z.of_nat n)) as s by (destruct L as (-> & _); ring).
    destruct (Hsum HX HY HW s) as (HX' & HY' & HW' & _).
    specialize (Hloc x y (2 ^ Z.of_nat n) U V eq_refl L).
    cbn [descend].
    pose proof (walk_range n d X' Y' W' (4 * index + digit) mid' top') as R.
    replace ((walk n d X' Y' W' (4 * index + digit) mid' top' / 4 ^ Z.of_nat n) mod 4) with digit.
    + pose proof (child_is_square mid top (2 ^ Z.of_nat n) x y digit Hdigit) as C.
      destruct (child_square mid top (2 ^ Z.of_nat n) x y digit) as [[[m t] x1] y1].
      destruct Hloc as (-> & -> & Hloc). rewrite C. apply IH; assumption.
    + rewrite <- (Z.div_unique _ (4 ^ Z.of_nat n) (4 * index + digit)
        (walk n d X' Y' W' (4 * index + digit) mid' top' - (4 * index + digit) * 4 ^ Z.of_nat n)).
      * rewrite Z.add_comm, Z.mul_comm, Z_mod_plus_full, Z.mod_small; lia.
      * left. lia.
      * ring.
Qed.

Ltac solve_unstep :=
  split; [lia | split; [lia | split; [lia | split; [repeat split; lia |]]]];
  intros; cbn [walk]; decide_all; cbn [andb negb]; solve [exfalso; lia | f_equal; lia].

(* Up: a point strictly inside a child, seen from its parent, is where Algorithm 4 takes that child. *)
Lemma unstep n d mid top x y digit U V X1 Y1 W1 : 0 < d -> 0 <= digit < 4 -> 0 < X1 -> 0 < Y1 -> 0 < W1 ->
  let '(mid', top', x', y') := child_square mid top (2 ^ Z.of_nat n) x y digit in
  located mid' d (2 ^ Z.of_nat n) x' y' U V X1 Y1 W1 ->
  exists X Y W, 0 < X /\ 0 < Y /\ 0 < W /\ located mid d (2 * 2 ^ Z.of_nat n) x y U V X Y W /\
  forall index, walk (S n) d X Y W index mid top = walk n d X1 Y1 W1 (4 * index + digit) mid' top'.
Proof.
  intros Hd Hdigit HX HY HW. pose proof (scale_pos d n Hd) as HD. set (h := 2 ^ Z.of_nat n) in *.
  assert (digit = 0 \/ digit = 1 \/ digit = 2 \/ digit = 3) as [-> | [-> | [-> | ->]]] by lia;
    destruct mid, top; cbn -[Z.add Z.sub Z.mul walk]; unfold located; intros (Hsum & -> & ->);
    first
      [ exists X1, Y1, (W1 + d * h); solve_unstep | exists X1, (Y1 + d * h), W1; solve_unstep
      | exists (X1 + d * h), Y1, W1; solve_unstep | exists (d * h - W1), (d * h - Y1), (d * h - X1); solve_unstep ].
Qed.
