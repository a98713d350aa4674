// The lemmas of dag.all_levels.  Each is one step of an induction over subtrees, for a part of one state or for a
// stored part whose children fulfil it, and comes from running the specification's own templates on names.  No level
// occurs, only the number of children: 64 below a tile, 16 or 4 below a node.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "proofs/dag/induction/names.hpp"

namespace mmverify::proofs::dag::induction {

/// The claims of a lemma, under the premises that it has written into a script.
struct Lemma {
  Term occasion;  ///< the premise of its claims, for which a witness must exist
  std::vector<Term> claims;
};
using Writer = std::function<Lemma(Script&)>;

/// Adds two statements: no case denies the claims; some case fulfils the premises.
void add(std::vector<Statement>& all, const std::string& name, const std::string& says, const Writer& write);

inline constexpr std::array<unsigned, 3> counts{4, 16, 64};

/// Parts P0 .. P(count-1).
std::vector<Term> declare_parts(Script& script, unsigned count, char letter = 'P');
/// The first digit of the path is below `count`.
Term has_digit(const Term& path, unsigned count);
/// Not all children are parts of one and the same state.
Term not_of_one_state(const std::vector<Term>& children);

/// The lemmas without a template of the specification.
void add_same_in_children(std::vector<Statement>& all, unsigned count);
void add_canonical(std::vector<Statement>& all, unsigned count);
void add_appended(std::vector<Statement>& all);

/// The part that spec::dag::parent makes of these children; `stored` is the part that stores them.
template <class Rules>
Term parent_of(const std::vector<Term>& children, const Term& stored) {
  using namespace proofs::induction;
  const auto runs = every_path([&] {
    std::vector<Name> names;
    for (const Term& c : children) names.push_back({c});
    return Rules::parent(std::span<const Name>(names), [&](std::span<const Name>) { return Name{stored}; });
  });
  return as_formula(runs, [](const Name& n) { return n.term; });
}

template <class Rules>
void add_parent(std::vector<Statement>& all, unsigned count) {
  using namespace proofs::induction;
  const std::string number = std::to_string(count);
  const auto write = [count](Script& script) {
    const std::vector<Term> children = declare_parts(script, count);
    script.comment("What is stored for these children has them: it is found by them, or appended.");
    const Term stored = apply("stored", {script.declare("s", integer)}, part_sort);
    for (unsigned k = 0; k < count; ++k) script.require(equal(child(stored, whole_number(k)), children[k]));
    script.comment("spec::dag::parent.");
    return std::pair(children, script.define("R", parent_of<Rules>(children, stored)));
  };
  add(all, "parent_means_" + number,
      "What is made of " + number + " children that mean the parts of a map means the map.",
      [=](Script& script) -> Lemma {
        const auto [children, R] = write(script);
        script.raw(R"(
; A map of states, and its part below a digit.
(declare-sort Map 0)
(declare-fun state_at (Map Path) State)
(declare-fun below (Map Int) Map)
)");
        const Term M = script.declare("M", map_sort), p = script.declare("p", path_sort);
        const auto state_at = [](const Term& m, const Term& path) {
          return apply("state_at", {m, path}, state_sort);
        };
        const auto below = [](const Term& m, const Term& k) { return apply("below", {m, k}, map_sort); };
        script.require(equal(state_at(M, p), state_at(below(M, first(p)), rest(p))));
        script.require(meant(R, p));
        script.comment("Supposed of each child.");
        for (unsigned k = 0; k < count; ++k) {
          script.require(meant(children[k], rest(p)));
          script.require(equal(means(children[k], rest(p)), state_at(below(M, whole_number(k)), rest(p))));
        }
        return {both({has_digit(p, count), is_stored(R)}),
                {implies(has_digit(p, count), equal(means(R, p), state_at(M, p)))}};
      });
  add(all, "parent_settles_" + number,
      "What is stored for " + number + " children has not one state in all of them.",
      [=](Script& script) -> Lemma {
        const auto [children, R] = write(script);
        return {is_stored(R), {implies(is_stored(R), not_of_one_state(children))}};
      });
}

/// spec::dag::lookup_turn from a part.
template <class Rules>
void add_lookup(std::vector<Statement>& all, bool stored) {
  using namespace proofs::induction;
  add(all, stored ? "lookup_stored" : "lookup_one",
      stored ? "From what is stored a lookup goes to the child of the next digit, and finds the state that "
               "it means."
             : "From a part of one state a lookup ends with the state that it means.",
      [=](Script& script) -> Lemma {
        script.raw(R"(
; What a lookup from a part finds, its digits being those of p.
(declare-fun lookup (Part Path) State)
(define-fun finds ((A Part) (p Path)) Bool (= (lookup A p) (means A p)))
)");
        const Term A = script.declare("A", part_sort), p = script.declare("p", path_sort);
        script.require(stored ? is_stored(A) : no(is_stored(A)));
        script.require(meant(A, p));
        script.comment("One turn from there, its digit being the path's first: spec::dag::lookup_turn.");
        struct Turn {
          bool goes_on;
          Name at;
        };
        const auto turns = every_path([&] {
          Turn turn{false, {A}};
          const auto next_digit = [&] { return Integer(first(p)); };
          turn.goes_on = Rules::lookup_turn(Store(), turn.at, next_digit);
          return turn;
        });
        const Term found = as_formula(turns, [&](const Turn& turn) {
          return turn.goes_on ? apply("lookup", {turn.at.term, rest(p)}, state_sort)
                              : apply("state", {turn.at.term}, state_sort);
        });
        script.require(equal(apply("lookup", {A, p}, state_sort), found));
        if (stored) {
          script.comment("Supposed of the child that the path leads to.");
          script.require(said("finds", {child(A, first(p)), rest(p)}));
        }
        return {equal(p, p), {said("finds", {A, p})}};
      });
}

/// spec::dag::kept.
template <class Rules>
void add_bound(std::vector<Statement>& all) {
  using namespace proofs::induction;
  add(all, "bound",
      "Where graphs take no more than their maps flat and 64 bits for each, so they do with a map more.",
      [](Script& script) -> Lemma {
        const auto number = [&](const char* name) { return script.declare(name, integer); };
        const auto less_or_equal = [](const Term& a, const Term& b) { return said("<=", {a, b}); };
        script.comment(
            "Bits before and after; 32 times so many words that tiles and nodes would grow by; the map's "
            "words flat;");
        script.comment("what flat grows by where it is laid there, none where it is there.");
        const Term before = number("before"), most = number("most"), grown = number("grown"),
                   flat = number("flat"), laid = number("laid");
        script.require(less_or_equal(whole_number(0), grown));
        script.require(less_or_equal(whole_number(0), laid));
        script.require(less_or_equal(laid, flat));
        script.comment("spec::dag::kept.");
        const auto runs = every_path([&] { return Rules::kept(Integer(grown), Integer(flat)); });
        const Term words = as_formula(runs, [&](bool kept) { return kept ? grown : laid; });
        const auto sum = [](std::vector<Term> of) { return apply("+", std::move(of), integer); };
        const auto bits_of = [](const Term& w) { return apply("*", {whole_number(32), w}, integer); };
        const Term after = script.define("after", sum({before, whole_number(64), bits_of(words)}));
        const Term supposed = less_or_equal(before, most);
        return {supposed,
                {implies(supposed, less_or_equal(after, sum({most, whole_number(64), bits_of(flat)})))}};
      });
}

/// All statements, for the rules of building and looking up.
template <class Rules>
std::vector<Statement> all_levels_statements() {
  std::vector<Statement> all;
  for (const unsigned count : counts) add_parent<Rules>(all, count);
  for (const unsigned count : counts) {
    add_same_in_children(all, count);
    add_canonical(all, count);
  }
  for (const bool stored : {false, true}) add_lookup<Rules>(all, stored);
  add_appended(all);
  add_bound<Rules>(all);
  return all;
}

}  // namespace mmverify::proofs::dag::induction
