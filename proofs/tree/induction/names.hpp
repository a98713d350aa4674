// Terms for the statements of tree.all_levels: trees, the two sequences, the map that a tree means.  The turns of
// Algorithms 1, 2 and 3 run on nodes, stacks and sequences that are names.
#pragma once

#include <utility>

#include "proofs/induction/statement.hpp"
#include "proofs/induction/symbolic.hpp"
#include "spec/tree/tree.hpp"

namespace mmverify::proofs::tree::induction {

using proofs::induction::boolean;
using proofs::induction::Integer;
using proofs::induction::integer;
using proofs::induction::Script;
using proofs::induction::Term;

inline const std::string tree_sort = "Tree", state_sort = "State", path_sort = "Path", stack_sort = "Stack",
                         cursor_sort = "Place";
using Place = spec::tree::Cursor<Integer>;

/// Write definitions into a script: of trees, which come first; of their numbers of nodes; of the two sequences and a
/// tree's place in them (by the counts); of the map that a tree means; of the comparisons of Algorithm 1.
void define_trees(Script& script);
void define_counts(Script& script);
void define_sequences(Script& script);
void define_maps(Script& script);
void define_merging(Script& script);

// ---- Formulas

inline Term truth(bool b) { return {b ? "true" : "false", boolean}; }
Term implies(const Term& premise, const Term& conclusion);
Term plus(const Term& a, const Term& b);
Term minus(const Term& a, long long k);
Term at_least(long long bound, const Term& x);

Term leaf(const Term& value);
Term node(const std::vector<Term>& children);
Term is_leaf(const Term& tree);
Term value(const Term& tree);
Term child(const Term& tree, std::size_t k);
Term nodes(const Term& tree);
Term leaves(const Term& tree);
/// The condition that the encoding of the tree begins at bit t and value d.
Term stands(const Term& tree, const Term& t, const Term& d);
/// The state that the tree gives to the micro-triangles below a path of digits.
Term state_at(const Term& tree, const Term& path);
/// A path's first digit, and the rest of the path.
Term first(const Term& path);
Term rest(const Term& path);
/// The place where bitscan ends.
Term bitscan_ends(const Term& child, const Term& t, const Term& d);
Term place(const Term& t, const Term& d);
Term stacked(const Term& tree, const Term& stack);

// ---- Names that the specification's templates take

/// The specification's Succinct-Tree.
struct Bits {
  Integer size() const;
  bool operator[](const Integer& t) const;
};
/// Both sequences.
struct Sequences {
  Bits tree;
};
/// Replaces the specification's bitscan in its tree-lookup, since a loop on names would not end.
Place bitscan(const Bits& tree, const Integer& child, const Place& at);

/// A child in Algorithm 1: the state of a leaf or none, compared like a std::optional of a state.
class Child {
 public:
  Child() = default;
  explicit Child(Term tree) : tree_(std::move(tree)) {}
  explicit operator bool() const;
  friend bool operator==(const Child& a, const Child& b);
  /// The condition that there is a state.
  Term has_state() const { return tree_ ? is_leaf(*tree_) : truth(false); }
  /// The leaf of that state; without one, the node with these children.
  Term tree(const std::vector<Term>& children) const;

 private:
  std::optional<Term> tree_;  ///< nothing: no state
};

/// A node on Algorithm 2's stack.
struct Node {
  Term tree;
  bool internal() const;
  Term value() const { return induction::value(tree); }
  Node child(std::size_t k) const { return {induction::child(tree, k)}; }
};

/// Algorithm 2's stack: its top, and the trees below.
class Stack {
 public:
  Stack(const Node& top, Term below) : above_{top}, below_(std::move(below)) {}
  bool empty() const { return false; }
  Node back() const { return above_.back(); }
  void pop_back() { above_.pop_back(); }
  void push_back(const Node& n) { above_.push_back(n); }
  Term term() const;

 private:
  std::vector<Node> above_;
  Term below_;
};

/// The bits and states that one turn of Algorithm 2 appends.
struct Appended {
  std::vector<bool> tree;
  std::vector<Term> data;
};

}  // namespace mmverify::proofs::tree::induction
