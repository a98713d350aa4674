// The lemmas of tree.all_levels.  Each is one step of an induction over trees, for a leaf or for a node whose
// children fulfil it, and comes from running the specification's own turns on names.  No level occurs.
#pragma once

#include "proofs/tree/induction/by_rules.hpp"
#include "proofs/tree/induction/names.hpp"

namespace mmverify::proofs::tree::induction {

using proofs::induction::Answer;
using proofs::induction::Statement;

/// The claims of a lemma, under the premises that it has written into a script.
struct Lemma {
  Term occasion;  ///< the premise of its claims, for which a witness must exist
  std::vector<Term> claims;
};
using Writer = std::function<Lemma(Script&)>;

/// Adds two statements: no case denies the claims; some case fulfils the premises.
void add(std::vector<Statement>& all, const std::string& name, const std::string& says, const Writer& write);

enum class Shape { leaf, node };
inline constexpr Shape shapes[] = {Shape::leaf, Shape::node};
const char* name(Shape shape);

/// A tree of that shape and its children, under names: T with children A0..A3, or with the state a.
struct Grown {
  Term tree;
  std::vector<Term> children;
};
Grown grow(Script& script, Shape shape, char letter = 'A', const char* tree = "T");

/// The places t0, d0 .. t3, d3 of the children; the first is given.
std::vector<std::pair<Term, Term>> places(Script& script, const std::vector<Term>& children, const Term& t,
                                          const Term& d);

Term counted(const Term& tree);
Term placed(const Term& tree, const Term& t, const Term& d);
Term meant(const Term& tree, const Term& path);
Term passes(const Term& tree, const Term& c, const Term& t, const Term& d);
Term finds(const Term& tree, const Term& t, const Term& d, const Term& path);
Term written(const Term& tree, const Term& stack, const Term& t, const Term& d);
Term reached(const Term& stack, const Term& t, const Term& d);
Term settled(const Term& tree);
Term settles(const Term& tree);

/// Write definitions into a script, with all that they need.
void define_passes(Script& script);
void define_finds(Script& script);
void define_written(Script& script);
void define_settled(Script& script);

/// Add statements: an encoding parses in one way; sizes; equal maps are equal in each quarter.
void add_parse(std::vector<Statement>& all);
void add_sizes(std::vector<Statement>& all);
void add_quarters(std::vector<Statement>& all);
/// Adds the statement that trees without siblings left to merge are the same if they mean the same map.
void add_canonical(std::vector<Statement>& all);

// ---- bitscan

/// The turn of the loop at (c, t, d), which continues from (child, bit, datum) or ends: `equation` has both cases.
struct ScanTurn {
  Term equation, child, bit, datum;
};

template <class Rules>
ScanTurn scan_turn(const Term& c, const Term& t, const Term& d) {
  using namespace proofs::induction;
  struct Turn {
    bool goes_on;
    Integer child;
    Place at;
  };
  const auto turns = every_path([&] {
    Turn turn{false, Integer(c), {Integer(t), Integer(d)}};
    turn.goes_on = Rules::bitscan_turn(Bits(), turn.child, turn.at);
    return turn;
  });
  const Term end = as_formula(turns, [](const Turn& turn) {
    return turn.goes_on ? bitscan_ends(turn.child.term, turn.at.t.term, turn.at.d.term)
                        : place(turn.at.t.term, turn.at.d.term);
  });
  return {equal(bitscan_ends(c, t, d), end),
          as_formula(turns, [](const Turn& turn) { return turn.child.term; }),
          as_formula(turns, [](const Turn& turn) { return turn.at.t.term; }),
          as_formula(turns, [](const Turn& turn) { return turn.at.d.term; })};
}

template <class Rules>
void add_skip(std::vector<Statement>& all, Shape shape) {
  using namespace proofs::induction;
  add(all, std::string("skip_") + name(shape),
      std::string("bitscan passes over a ") + name(shape) +
          " as over one subtree: with c >= 1 subtrees to pass it comes to where it would come from the place "
          "behind it with c-1.",
      [shape](Script& script) -> Lemma {
        define_passes(script);
        const auto [T, children] = grow(script, shape);
        const Term c = script.declare("c", integer), t = script.declare("t", integer),
                   d = script.declare("d", integer);
        script.require(counted(T));
        script.require(placed(T, t, d));
        script.comment("One turn from there: spec::tree::bitscan_turn.");
        const ScanTurn turn = scan_turn<Rules>(c, t, d);
        script.require(turn.equation);
        if (shape == Shape::node) {
          script.comment("Subtrees left to pass after that turn, and where the children stand.");
          const Term c0 = script.define("c0", turn.child);
          const auto at = places(script, children, turn.bit, turn.datum);
          script.comment("Supposed of each child, where it stands and for the subtrees that are left then.");
          for (unsigned k = 0; k < 4; ++k)
            script.require(passes(children[k], minus(c0, k), at[k].first, at[k].second));
        }
        return {both({at_least(1, c), stands(T, t, d)}), {passes(T, c, t, d)}};
      });
}

// ---- tree-lookup

template <class Rules>
void add_lookup(std::vector<Statement>& all, Shape shape) {
  using namespace proofs::induction;
  add(all, std::string("lookup_") + name(shape),
      std::string("From the root of a ") + name(shape) +
          (shape == Shape::leaf ? ", tree-lookup reads the state that it means."
                                : ", tree-lookup goes to the child of the next digit, and finds the state "
                                  "that the node means below the path."),
      [shape](Script& script) -> Lemma {
        define_passes(script);
        define_finds(script);
        const auto [T, children] = grow(script, shape);
        const Term t = script.declare("t", integer), d = script.declare("d", integer),
                   p = script.declare("p", path_sort);
        script.require(placed(T, t, d));
        script.require(meant(T, p));
        script.comment("One turn from there, its digit being the path's first: spec::tree::lookup_turn.");
        struct Turn {
          bool goes_on;
          Place at;
        };
        const auto turns = every_path([&] {
          Turn turn{false, {Integer(t), Integer(d)}};
          const auto next_child = [&] { return Integer(first(p)); };
          turn.goes_on = Rules::lookup_turn(Sequences(), turn.at, next_child);
          return turn;
        });
        const Term state = as_formula(turns, [&](const Turn& turn) {
          return turn.goes_on ? apply("lookup", {turn.at.t.term, turn.at.d.term, rest(p)}, state_sort)
                              : apply("data", {turn.at.d.term}, state_sort);
        });
        script.require(equal(apply("lookup", {t, d, p}, state_sort), state));
        if (shape == Shape::node) {
          script.comment("Where the children stand.");
          const auto at = places(script, children, plus(t, whole_number(1)), d);
          script.comment("bitscan passes over the children before (skip_leaf, skip_node) and ends.");
          for (unsigned k = 0; k < 4; ++k) {
            const Term left = minus(first(p), k);
            if (k < 3) script.require(passes(children[k], left, at[k].first, at[k].second));
            script.require(scan_turn<Rules>(left, at[k].first, at[k].second).equation);
          }
          script.comment("Supposed of each child, where it stands.");
          for (unsigned k = 0; k < 4; ++k)
            script.require(finds(children[k], at[k].first, at[k].second, rest(p)));
        }
        return {stands(T, t, d), {finds(T, t, d, p)}};
      });
}

// ---- Algorithm 2

template <class Rules>
void add_emit(std::vector<Statement>& all, Shape shape) {
  using namespace proofs::induction;
  add(all, std::string("emit_") + name(shape),
      std::string("Algorithm 2 with a ") + name(shape) +
          " on top of the stack: its encoding is appended to both sequences, and then what was below it is "
          "on top. Sequences are as they will be: what is appended stays.",
      [shape](Script& script) -> Lemma {
        define_written(script);
        const auto [T, children] = grow(script, shape);
        const Term S = script.declare("S", stack_sort), t = script.declare("t", integer),
                   d = script.declare("d", integer);
        script.require(counted(T));
        script.require(placed(T, t, d));
        script.comment("One turn, with what it appends and the stack it leaves: spec::tree::succinct_turn.");
        struct Turn {
          Term stack;
          Appended appended;
        };
        const auto turns = every_path([&T = T, &S] {
          Stack stack(Node{T}, S);
          Turn turn{S, {}};
          Rules::succinct_turn(stack, turn.appended);
          turn.stack = stack.term();
          return turn;
        });
        const Term done = as_formula(turns, [&](const Turn& turn) {
          Term bit = t, datum = d;
          std::vector<Term> facts;
          for (const bool b : turn.appended.tree) {
            const Term internal = apply("internal", {bit}, boolean);
            facts.push_back(apply("<", {bit, Term("size", integer)}, boolean));
            facts.push_back(b ? internal : no(internal));
            bit = plus(bit, whole_number(1));
          }
          for (const Term& value : turn.appended.data) {
            facts.push_back(equal(apply("data", {datum}, state_sort), value));
            datum = plus(datum, whole_number(1));
          }
          facts.push_back(reached(turn.stack, bit, datum));
          return both(facts);
        });
        script.require(implies(reached(stacked(T, S), t, d), done));
        if (shape == Shape::node) {
          script.comment("Where the children stand.");
          const auto at = places(script, children, plus(t, whole_number(1)), d);
          script.comment("Supposed of each child, on top of those after it.");
          std::vector<Term> below{S};
          for (unsigned k = 3; k > 0; --k) below.push_back(stacked(children[k], below.back()));
          for (unsigned k = 0; k < 4; ++k)
            script.require(written(children[k], below[3 - k], at[k].first, at[k].second));
        }
        return {reached(stacked(T, S), t, d), {written(T, S, t, d)}};
      });
}

// ---- Algorithm 1

/// The result of spec::tree::merged for four children.
template <class Rules>
struct Merged {
  explicit Merged(const std::vector<Term>& of) : children(of) {
    runs = proofs::induction::every_path([&] {
      const Child child[] = {Child(of[0]), Child(of[1]), Child(of[2]), Child(of[3])};
      return Rules::merged(child);
    });
  }
  Term tree() const {
    return as_formula(runs, [&](const Child& c) { return c.tree(children); });
  }
  std::vector<Term> children;
  std::vector<proofs::induction::Path<Child>> runs;
};

template <class Rules>
void add_merge(std::vector<Statement>& all) {
  using namespace proofs::induction;
  add(all, "merge_keeps_map",
      "Algorithm 1: what it makes of four children means the same map as the node that has them.",
      [](Script& script) -> Lemma {
        define_maps(script);
        define_merging(script);
        const auto [T, children] = grow(script, Shape::node);
        const Term p = script.declare("p", path_sort);
        script.comment("spec::tree::merged.");
        const Term M = script.define("M", Merged<Rules>(children).tree());
        script.require(meant(T, p));
        script.require(meant(M, p));
        for (const Term& c : children) script.require(meant(c, rest(p)));
        return {is_leaf(M), {equal(state_at(M, p), state_at(T, p))}};
      });
  add(all, "merge_settles",
      "Algorithm 1: where no four siblings in four children are leaves of one state, none are in what it "
      "makes of them.",
      [](Script& script) -> Lemma {
        define_merging(script);
        define_settled(script);
        const auto [T, children] = grow(script, Shape::node);
        script.comment("spec::tree::merged.");
        const Term M = script.define("M", Merged<Rules>(children).tree());
        std::vector<Term> all_settled;
        for (const Term& c : children) all_settled.push_back(settled(c));
        script.require(settles(M));
        const Term supposed = both(all_settled);
        return {both({supposed, no(is_leaf(M))}), {implies(supposed, settled(M))}};
      });
}

/// All statements, for the rules of the three algorithms.
template <class Rules>
std::vector<Statement> all_levels_statements() {
  std::vector<Statement> all;
  add_merge<Rules>(all);
  add_quarters(all);
  add_canonical(all);
  for (const Shape shape : shapes) add_emit<Rules>(all, shape);
  add_parse(all);
  for (const Shape shape : shapes) add_skip<Rules>(all, shape);
  for (const Shape shape : shapes) add_lookup<Rules>(all, shape);
  add_sizes(all);
  return all;
}

}  // namespace mmverify::proofs::tree::induction
