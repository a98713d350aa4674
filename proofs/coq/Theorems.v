(* The theorems, in the words of Definitions.v: each is a statement, and lines that name its proof.

   `Theorem name : forall x, A -> B.` says: for all x, where A then B.  `exists x, A` says that there is such an x,
   `A /\ B` is A and B.  scripts/check-coq asks Coq on which axioms each theorem rests; the answer has to be: none.  The
   names are those of the laws of `mmverify list index` that say the same level by level. *)
From Coq Require Import Lia.
Require Import Definitions Walk Words Induction Points Triangles Bijection Curve Neighbours
  Published.

(* index.all_levels.  At every level, for every rational point of the closed triangle, Algorithm 4 gives the index of
   the reference code. *)
Theorem all_levels : forall (level : nat) (u v : Q),
  in_triangle u v -> uv2index u v level = reference u v level.
Proof. intros level u v. apply step_is_reference. Qed.

(* Up to level 16 the published code's words of 32 bits, shifts and masks give the same, for every rational point of the
   plane; with all_levels, Algorithm 4 is the published code, but for its floats. *)
Theorem words_of_32_bits : forall (level : nat) (u v : Q),
  (level <= 16)%nat -> published u v level = reference u v level.
Proof. intros level u v. apply published_is_reference. Qed.

(* index.in_range.  The index is one of 0 ... 4^level - 1: that of Algorithm 4, and that of the reference code, which
   takes any point. *)
Theorem in_range : forall (level : nat) (u v : Q),
  0 <= uv2index u v level < 4 ^ Z.of_nat level /\ 0 <= reference u v level < 4 ^ Z.of_nat level.
Proof.
  intros level u v. split.
  - pose proof (step_range level u v (1 - u - v) 0 false false). unfold uv2index. lia.
  - apply square_range.
Qed.

(* index.nested.  The index at the next level, divided by 4, is the index: ties included.  So the paper's Algorithm 3
   may take the digits one by one. *)
Theorem nested : forall (level : nat) (u v : Q), uv2index u v (S level) / 4 = uv2index u v level.
Proof. intros level u v. apply step_nested. Qed.

(* index.bijective, from micro-triangles to indices: all points strictly inside a micro-triangle have one index. *)
Theorem one_index_each : forall (level : nat) (T : micro_triangle), of_level level T ->
  exists k, 0 <= k < 4 ^ Z.of_nat level /\ forall u v, inside level T u v -> uv2index u v level = k.
Proof.
  intros level [[i j] upper] HT. destruct (index_of_triangle level i j upper HT) as (k & top & Hk & _ & H). eauto.
Qed.

(* index.bijective, from indices to micro-triangles: each index below 4^level is that of one micro-triangle's inside,
   and of no other's. *)
Theorem bijective : forall (level : nat) (k : Z), 0 <= k < 4 ^ Z.of_nat level ->
  exists T, of_level level T /\ (forall u v, inside level T u v -> uv2index u v level = k) /\
  forall T' u v, of_level level T' -> inside level T' u v -> uv2index u v level = k -> T' = T.
Proof.
  intros level k Hk. destruct (triangle_of_index level k Hk) as (i & j & upper & top & HT & HS).
  assert (forall T' u v, of_level level T' -> inside level T' u v -> uv2index u v level = k -> T' = (i, j, upper)) as H.
  { intros [[i' j'] upper'] u v HT' I e.
    destruct (index_of_triangle level i' j' upper' HT') as (k' & t & _ & HS' & H).
    rewrite (H u v I) in e. subst k'. unfold of_square in HS, HS'. rewrite HS in HS'. apply half_square_once in HS'.
    destruct HS' as (-> & -> & ->). reflexivity. }
  exists (i, j, upper). split; [exact HT |]. split; [| exact H].
  destruct (index_of_triangle level i j upper HT) as (k' & t & Hk' & HS' & H'). intros u v I. rewrite (H' u v I).
  exact (index_of_square_once level k k' i j upper top t Hk Hk' HS HS').
Qed.

(* No micro-triangle is empty, and those of a level lie in the base triangle: the two theorems before this one are about
   points that there are. *)
Theorem inside_is_somewhere : forall (level : nat) (T : micro_triangle), of_level level T ->
  (exists u v, inside level T u v) /\ forall u v, inside level T u v -> in_triangle u v.
Proof.
  intros level [[i j] upper] HT. split.
  - eexists. eexists. apply centre_inside.
  - intros u v I. destruct (inside_numerators level i j upper u v HT I) as (d & U & V & _ & _ & _ & N & _).
    exact (numerators_in_triangle u v level d U V N).
Qed.

(* index.inverse and index.corners.  The corners of an index are those of its micro-triangle. *)
Theorem corners_of_index : forall (level : nat) (T : micro_triangle) (u v : Q),
  of_level level T -> inside level T u v ->
  same_corners (corners level (uv2index u v level)) (corners_of T).
Proof.
  intros level [[i j] upper] u v HT I. destruct (index_of_triangle level i j upper HT) as (k & top & _ & HS & H).
  rewrite (H u v I). unfold of_square in HS. rewrite HS. apply half_square_corners.
Qed.

(* A point on edges, too, gets the index of a micro-triangle that holds it. *)
Theorem holds_point : forall (level : nat) (u v : Q), in_triangle u v ->
  exists T, of_level level T /\ within level T u v /\ same_corners (corners level (uv2index u v level)) (corners_of T).
Proof.
  intros level u v H. destruct (point_within level u v H) as (i & j & upper & top & HT & HS & W).
  exists (i, j, upper). split; [exact HT |]. split; [exact W |]. unfold of_square in HS. rewrite HS.
  apply half_square_corners.
Qed.

(* Where a micro-triangle ends the next along the curve begins: P2 of the one is P0 of the
   other. *)
Theorem contiguous : forall (level : nat) (k : Z), 0 <= k -> k + 1 < 4 ^ Z.of_nat level ->
  P2_of (corners level k) = P0_of (corners level (k + 1)).
Proof. intros level k H0 H1. apply descend_contiguous. rewrite Z.mod_small; lia. Qed.

(* index.contiguous.  From index k to k+1, m digits 3 at the end become 0 and the digit before them grows by one: where
   it was 0 or 1 the two micro-triangles share an edge, where it was 2 they share one corner and no more. *)
Theorem neighbours : forall (level m : nat) (k : Z), 0 <= k -> k + 1 < 4 ^ Z.of_nat level ->
  k mod 4 ^ Z.of_nat m = 4 ^ Z.of_nat m - 1 ->
  let digit := (k / 4 ^ Z.of_nat m) mod 4 in
  (digit = 0 \/ digit = 1 -> share_an_edge (corners level k) (corners level (k + 1))) /\
  (digit = 2 -> share_one_corner (corners level k) (corners level (k + 1))).
Proof.
  intros level m k H0 H1 H digit. pose proof (corners_joined level m k H0 H1 H) as J. fold digit in J.
  split.
  - intros [e | e]; rewrite e in J; exact (J ltac:(lia)).
  - intros e. rewrite e in J. exact (J ltac:(lia)).
Qed.
