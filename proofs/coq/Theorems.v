(* The theorems, in the words of Definitions.v: each is a statement, and a line that names its proof.

   `Theorem name : forall x, A -> B.` says: for all x, where A then B.  `exists x, A` says that there is one, `/\` is and.
   `(e)%nat`: the numbers in e are of type nat.  scripts/check-coq asks Coq which axioms each of these rests on; the
   answer has to be none. *)
Require Import Definitions Induction.

(* index.all_levels.  At every level, for every rational point of the closed triangle, Algorithm 4 gives the index of the
   reference code. *)
Theorem all_levels : forall (level : nat) (u v : Q),
  in_triangle u v -> uv2index u v level = reference u v level.
Proof. intros level u v. apply step_is_reference. Qed.
