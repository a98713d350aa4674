#include "proofs/tree/induction/lemmas.hpp"
#include "proofs/tree/induction/provable.hpp"

namespace mmverify::proofs::tree::induction {
namespace {

/// Altered rules, run on maps and in the statements where they take the right ones' place.
template <class Rules>
class Wrong : public TreeSubject, public Provable {
 public:
  explicit Wrong(const std::string& name)
      : TreeSubject(name, "broken on purpose", functions_by_rules<Rules>()) {}
  std::vector<Statement> statements() const override { return all_levels_statements<Rules>(); }
};

template <class Rules>
Mutant wrong(const char* name) {
  return {name, std::make_shared<Wrong<Rules>>(name), {0, 2}};
}

struct OwesThree : Specified {
  template <class Tree, class Count>
  static bool bitscan_turn(const Tree& tree, Count& child, Cursor<Count>& at) {
    if (!(at.t < tree.size() && child > 0)) return false;
    if (tree[at.t])
      child = child + 3;
    else
      at.d = at.d + 1;
    child = child - 1;
    at.t = at.t + 1;
    return true;
  }
};

struct CountsInternalNodes : Specified {
  template <class Tree, class Count>
  static bool bitscan_turn(const Tree& tree, Count& child, Cursor<Count>& at) {
    const Count d = at.d;
    if (!Specified::bitscan_turn(tree, child, at)) return false;
    at.d = d + 1;
    return true;
  }
};

struct SkipsTheChildToo : Specified {
  template <class Sequences, class Count, class NextChild>
  static bool lookup_turn(const Sequences& s, Cursor<Count>& at, NextChild& next_child) {
    const auto one_more = [&] { return next_child() + 1; };
    return Specified::lookup_turn(s, at, one_more);
  }
};

struct FirstChildOnTop : Specified {
  template <class Stack, class Output>
  static bool succinct_turn(Stack& stack, Output& s) {
    if (stack.empty()) return false;
    const auto node = stack.back();
    stack.pop_back();
    if (node.internal()) {
      s.tree.push_back(true);
      for (std::size_t child = 0; child < 4; ++child) stack.push_back(node.child(child));
    } else {
      s.tree.push_back(false);
      s.data.push_back(node.value());
    }
    return true;
  }
};

struct FourthChildNotLookedAt : Specified {
  template <class Child>
  static Child merged(const Child* child) {
    const bool all_same = child[0] && child[0] == child[1] && child[0] == child[2];
    return all_same ? child[0] : Child();
  }
};

struct NothingMerges : Specified {
  template <class Child>
  static Child merged(const Child*) {
    return Child();
  }
};

}  // namespace

std::vector<Mutant> mutants_of_all_levels() {
  return {wrong<OwesThree>("an internal node owes three children"),
          wrong<CountsInternalNodes>("d also counts internal nodes"),
          wrong<SkipsTheChildToo>("the child itself is passed over"),
          wrong<FirstChildOnTop>("children are pushed first to last"),
          wrong<FourthChildNotLookedAt>("the fourth child is not looked at when merging"),
          wrong<NothingMerges>("nothing merges")};
}

TreeSubjectPtr specified_by_turns() {
  return std::make_shared<TreeSubject>("tree-spec-by-turns", "the specification's turns",
                                       functions_by_rules<Specified>());
}

}  // namespace mmverify::proofs::tree::induction
