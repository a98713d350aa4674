#include "proofs/dag/induction/lemmas.hpp"

namespace mmverify::proofs::dag::induction {

using namespace proofs::induction;

void add(std::vector<Statement>& all, const std::string& name, const std::string& says, const Writer& write) {
  Script script(name, Answer::unsat, says);
  define_parts(script);
  Lemma lemma = write(script);
  script.comment("Denied:");
  all.push_back(script.denying(std::move(lemma.claims)));

  Script witness("witness_" + name, Answer::sat,
                 "Not vacuous: some case fulfils what " + name + " supposes.");
  define_parts(witness);
  witness.require(write(witness).occasion);
  all.push_back(witness.finish());
}

std::vector<Term> declare_parts(Script& script, unsigned count, char letter) {
  std::vector<Term> parts;
  for (unsigned k = 0; k < count; ++k)
    parts.push_back(script.declare(std::string(1, letter) + std::to_string(k), part_sort));
  return parts;
}

Term has_digit(const Term& path, unsigned count) {
  return both({said("<=", {whole_number(0), first(path)}), said("<", {first(path), whole_number(count)})});
}

Term not_of_one_state(const std::vector<Term>& children) {
  std::vector<Term> same;
  for (const Term& c : children) same.push_back(both({no(is_stored(c)), equal(c, children[0])}));
  return no(both(same));
}

namespace {

/// The parts below each digit: children, or of one state that itself.
constexpr char parts_below[] = R"(
(define-fun part ((A Part) (k Int)) Part (ite ((_ is one) A) A (child A k)))
; A and B mean the same map: means is the same on every path.
(declare-fun same (Part Part) Bool)
; The induction's statement.
(define-fun alike ((A Part) (B Part)) Bool (=> (same A B) (= A B)))
)";

Term part(const Term& of, const Term& digit) { return apply("part", {of, digit}, part_sort); }
Term same(const Term& a, const Term& b) { return said("same", {a, b}); }

}  // namespace

void add_same_in_children(std::vector<Statement>& all, unsigned count) {
  add(all, "same_in_children_" + std::to_string(count),
      "Parts that give a path the same state do so in what is below its first digit: so those that mean the "
      "same map do in each of " +
          std::to_string(count) + " children.",
      [count](Script& script) -> Lemma {
        script.raw(parts_below);
        const Term A = script.declare("A", part_sort), B = script.declare("B", part_sort),
                   p = script.declare("p", path_sort);
        for (const Term& path : {p, rest(p)})
          for (const Term& of : {A, B}) script.require(meant(of, path));
        const Term alike = both({has_digit(p, count), equal(means(A, p), means(B, p))});
        std::vector<Term> claims;
        for (unsigned k = 0; k < count; ++k) {
          const Term digit = whole_number(k);
          claims.push_back(implies(both({equal(first(p), digit), alike}),
                                   equal(means(part(A, digit), rest(p)), means(part(B, digit), rest(p)))));
        }
        return {both({alike, is_stored(A)}), claims};
      });
}

void add_canonical(std::vector<Statement>& all, unsigned count) {
  add(all, "canonical_" + std::to_string(count),
      "Parts of " + std::to_string(count) +
          " children, or of one state, that mean the same map are the same part: equal subtrees are stored "
          "once.",
      [count](Script& script) -> Lemma {
        script.raw(parts_below);
        const Term A = script.declare("A", part_sort), B = script.declare("B", part_sort),
                   p = script.declare("p", path_sort);
        script.comment("Of one state both: that of any path.");
        for (const Term& of : {A, B}) script.require(meant(of, p));
        script.require(implies(same(A, B), equal(means(A, p), means(B, p))));
        std::vector<Term> below, equals;
        for (const Term& of : {A, B}) {
          std::vector<Term> children;
          for (unsigned k = 0; k < count; ++k) children.push_back(child(of, whole_number(k)));
          script.comment("What is stored has not one state in all children: parent_settles.");
          script.require(implies(is_stored(of), not_of_one_state(children)));
        }
        for (unsigned k = 0; k < count; ++k) {
          const Term a = part(A, whole_number(k)), b = part(B, whole_number(k));
          below.push_back(same(a, b));
          equals.push_back(equal(a, b));
          script.comment("Supposed of each pair of children.");
          script.require(said("alike", {a, b}));
        }
        script.comment("By same_in_children, where one of them has children.");
        script.require(
            implies(both({same(A, B), no(both({no(is_stored(A)), no(is_stored(B))}))}), both(below)));
        script.comment("No two that are stored have the same children: they are found by them.");
        script.require(implies(both({is_stored(A), is_stored(B), both(equals)}), equal(A, B)));
        return {both({same(A, B), is_stored(A)}), {said("alike", {A, B})}};
      });
}

void add_appended(std::vector<Statement>& all) {
  add(all, "appended", "What was stored before something was appended means what it meant.",
      [](Script& script) -> Lemma {
        script.raw(R"(
; The graph before: what was stored under numbers below `size`, which is there still.
(declare-const size Int)
(declare-fun child_before (Int Int) Part)
(declare-fun means_before (Part Path) State)
(define-fun meant_before ((A Part) (p Path)) Bool
  (= (means_before A p)
     (ite ((_ is one) A) (state A) (means_before (child_before (number A) (first p)) (rest p)))))
(define-fun there ((A Part)) Bool (or ((_ is one) A) (< (number A) size)))
; The induction's statement.
(define-fun stays ((A Part) (p Path)) Bool (=> (there A) (= (means A p) (means_before A p))))
)");
        const Term A = script.declare("A", part_sort), p = script.declare("p", path_sort);
        script.require(meant(A, p));
        script.require(said("meant_before", {A, p}));
        const Term number = apply("number", {A}, integer),
                   before = apply("child_before", {number, first(p)}, part_sort);
        const Term was_stored = both({is_stored(A), said("there", {A})});
        script.comment("Nothing that is there changes, and children were stored before what has them.");
        script.require(implies(was_stored, equal(child(A, first(p)), before)));
        script.require(implies(both({was_stored, is_stored(before)}),
                               said("<", {apply("number", {before}, integer), number})));
        script.comment("Supposed of the child.");
        script.require(said("stays", {before, rest(p)}));
        return {was_stored, {said("stays", {A, p})}};
      });
}

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
