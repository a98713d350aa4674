#include "proofs/dag/induction/names.hpp"

namespace mmverify::proofs::dag::induction {

void define_parts(Script& script) {
  script.raw(R"(
; A part of a graph: one state for all of a subtree, or what is stored under a number.  Numbers of tiles and of nodes of
; each level are taken to be different ones.
(declare-sort State 0)
(declare-datatypes ((Part 0)) (((one (state State)) (stored (number Int)))))
(declare-fun child_of (Int Int) Part)
(define-fun child ((A Part) (k Int)) Part (child_of (number A) k))
; The way from a subtree to a micro-triangle: a digit, and the rest.
(declare-sort Path 0)
(declare-fun first (Path) Int)
(declare-fun rest (Path) Path)
; What a part means: the state at the end of each path.
(declare-fun means (Part Path) State)
(define-fun meant ((A Part) (p Path)) Bool
  (= (means A p) (ite ((_ is one) A) (state A) (means (child A (first p)) (rest p)))))
)");
}

Term implies(const Term& premise, const Term& conclusion) {
  return apply("=>", {premise, conclusion}, boolean);
}
Term said(const char* predicate, std::vector<Term> of) { return apply(predicate, std::move(of), boolean); }
Term first(const Term& path) { return apply("first", {path}, integer); }
Term rest(const Term& path) { return apply("rest", {path}, path_sort); }
Term is_stored(const Term& part) { return apply("(_ is stored)", {part}, boolean); }
Term child(const Term& part, const Term& digit) { return apply("child", {part, digit}, part_sort); }
Term means(const Term& part, const Term& path) { return apply("means", {part, path}, state_sort); }
Term meant(const Term& part, const Term& path) { return said("meant", {part, path}); }

}  // namespace mmverify::proofs::dag::induction
