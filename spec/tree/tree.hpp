// The succinct tree of a micromap: Algorithms 1, 2 and 3 as printed, over plain sequences of bits.
//
// The print leaves these points open; this file reads them as follows:
//   child order   Algorithm 2's stack is given the children last to first, so that child 0 comes off first.
//                 Algorithm 3 fits no other order: bitscan passes over `child` subtrees to reach that child.
//   child digits  the children of a node are the digits 0..3 of the index, most significant digit at
//                 the root: the curve nests.
//   level n       its nodes are leaves; each has its 0 in the tree, as all other leaves have.
//   bitscan       returns t and d, as its caller takes them; its count of subtrees to pass ends at 0.
//   turns         the loops of Algorithms 2 and 3 are iterated templates, one turn each, so that a prover can
//                 be given the same turns.
//   bits as bytes bit t of the tree is bit t mod 8 of byte t / 8; value d of b bits is bits b d .. b d + b-1,
//                 likewise: the packing of micromaps.  The bits after the last are zero.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "spec/index/index.hpp"
#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::tree {

using micromap::Bytes;
using micromap::Format;
using micromap::State;
using micromap::States;

// ---- Algorithm 1: the perfect tree

/// Every node of every level: the state of a leaf, none for an internal node.  node[m] has 4^m entries; entries below a
/// leaf are not part of the tree.
struct PerfectTree {
  Level level = 0;
  std::vector<std::vector<std::optional<State>>> node;
};

/// "all child nodes contain the same micromap value": that leaf if so, else Child(), an internal node.
template <class Child>
Child merged(const Child* child) {
  const bool all_same = child[0] && child[0] == child[1] && child[0] == child[2] && child[0] == child[3];
  return all_same ? child[0] : Child();
}

/// The perfect tree of a map.  From the bottom up, a node whose four children are leaves of one state becomes a leaf.
/// Domain: 4^n states.  Source: Succinct Opacity Micromaps, 4.1, Algorithm 1.
inline PerfectTree perfect_tree(std::span<const State> map, Level n) {
  PerfectTree tree{n, std::vector<std::vector<std::optional<State>>>(n + 1)};
  tree.node[n].assign(map.begin(), map.end());
  for (Level level = n; level-- > 0;)
    for (std::size_t k = 0; k < micromap::micro_triangles(level); ++k)
      tree.node[level].push_back(merged(&tree.node[level + 1][4 * k]));
  return tree;
}

// ---- Algorithm 2: two sequences

/// Two sequences: the nodes in pre-order, 1 internal and 0 leaf; the states of the leaves in the same order.
struct Succinct {
  std::vector<bool> tree;
  States data;
  friend bool operator==(const Succinct&, const Succinct&) = default;
};

/// A node of a perfect tree, number k of its level.
struct Node {
  const PerfectTree* perfect;
  Level level;
  std::size_t k;
  bool internal() const { return !perfect->node[level][k]; }
  State value() const { return *perfect->node[level][k]; }
  Node child(std::size_t c) const { return {perfect, level + 1, 4 * k + c}; }
};

/// One turn of Algorithm 2's loop; false at its end.
template <class Stack, class Output>
bool succinct_turn(Stack& stack, Output& s) {
  if (stack.empty()) return false;
  const auto node = stack.back();
  stack.pop_back();
  if (node.internal()) {
    s.tree.push_back(true);
    for (std::size_t child = 4; child-- > 0;) stack.push_back(node.child(child));
  } else {
    s.tree.push_back(false);
    s.data.push_back(node.value());
  }
  return true;
}

/// Source: Succinct Opacity Micromaps, 4.1, Algorithm 2.
inline Succinct succinct(const PerfectTree& perfect) {
  Succinct s;
  std::vector<Node> stack{{&perfect, 0, 0}};
  while (succinct_turn(stack, s)) continue;
  return s;
}

/// The sequences of a map: Algorithms 1 and 2.  Domain: 4^n states.
inline Succinct encode(std::span<const State> map, Level n) { return succinct(perfect_tree(map, n)); }

// ---- Algorithm 3: one state

/// A place in the two sequences.
template <class Count>
struct Cursor {
  Count t, d;
};

/// One turn of bitscan's loop; false at its end.
template <class Tree, class Count>
bool bitscan_turn(const Tree& tree, Count& child, Cursor<Count>& at) {
  if (!(at.t < tree.size() && child > 0)) return false;
  if (tree[at.t])
    child = child + 4;
  else
    at.d = at.d + 1;
  child = child - 1;
  at.t = at.t + 1;
  return true;
}

/// Passes over `child` subtrees from t on.  Source: Succinct Opacity Micromaps, 4.2, Algorithm 3.
template <class Tree, class Count>
Cursor<Count> bitscan(const Tree& tree, Count child, Cursor<Count> at) {
  while (bitscan_turn(tree, child, at)) continue;
  return at;
}

/// One turn of tree-lookup's loop; false if t is no internal node.
template <class Sequences, class Count, class NextChild>
bool lookup_turn(const Sequences& s, Cursor<Count>& at, NextChild& next_child) {
  if (!s.tree[at.t]) return false;
  at.t = at.t + 1;
  at = bitscan(s.tree, next_child(), at);
  return true;
}

/// The state found, and the number of tree bits read for it, 0..t; one value is read, too.
struct StateAndBits {
  State state;
  std::uint64_t tree_bits;
};

/// tree-lookup.  next_child() is the paper's step(u, v), the digit of the next child.
/// Domain: an encoded map, and as many digits as the tree is deep.
template <class NextChild>
StateAndBits lookup(const Succinct& s, NextChild next_child) {
  Cursor<std::uint64_t> at{0, 0};
  while (lookup_turn(s, at, next_child)) continue;
  return {s.data[at.d], at.t + 1};
}

/// The state at an index < 4^n.
inline StateAndBits at_index(const Succinct& s, Level n, std::uint64_t index) {
  Level depth = 0;
  return lookup(s, [&] { return index >> 2 * (n - ++depth) & 3; });
}

/// The state at a point of the triangle, by the digits of Algorithm 4.
template <Number Q>
StateAndBits at_point(const Succinct& s, const Point<Q>& p) {
  auto step = index::first_step<Q, std::uint64_t>(p);
  return lookup(s, [&] {
    step = index::next_step<index::Reading::printed>(step);
    return step.index & 3;
  });
}

// ---- Back to the map, and to bytes

/// The map of level n that encodes to s.  None if no map does: a tree that ends early or late, or goes below level n,
/// more or fewer values than leaves, four sibling leaves of one state, a state that the format lacks.
/// Source: Succinct Opacity Micromaps, 4.2, first paragraph.
inline std::optional<States> decode(const Succinct& s, Level n, Format f) {
  States map;
  Cursor<std::uint64_t> at{0, 0};
  const auto subtree = [&](const auto& self, Level level) -> bool {
    if (at.t == s.tree.size()) return false;
    if (s.tree[at.t++]) {
      if (level == 0) return false;
      for (unsigned child = 0; child < 4; ++child)
        if (!self(self, level - 1)) return false;
      return true;
    }
    if (at.d == s.data.size() || !micromap::holds(f, s.data[at.d])) return false;
    map.insert(map.end(), micromap::micro_triangles(level), s.data[at.d++]);
    return true;
  };
  if (!subtree(subtree, n) || at.t != s.tree.size() || at.d != s.data.size()) return std::nullopt;
  if (encode(map, n) != s) return std::nullopt;
  return map;
}

/// The bytes of two sequences: the tree's, then the values'.
inline Bytes bytes(const Succinct& s, Format f) {
  States bits;
  for (const bool internal : s.tree) bits.push_back(internal ? State::O : State::T);
  Bytes all = micromap::pack(bits, Format::two_state);
  const Bytes values = micromap::pack(s.data, f);
  all.insert(all.end(), values.begin(), values.end());
  return all;
}

/// The sequences of these bytes; none if no encoded tree has them.  The tree ends where no more nodes are owed.
inline std::optional<Succinct> from_bytes(std::span<const std::uint8_t> all, Format f) {
  Succinct s;
  std::uint64_t owed = 1, leaves = 0;
  for (std::size_t t = 0; owed > 0; ++t) {
    if (t / 8 >= all.size()) return std::nullopt;
    s.tree.push_back((all[t / 8] >> t % 8 & 1) != 0);
    owed = s.tree.back() ? owed + 3 : owed - 1;
    leaves += s.tree.back() ? 0 : 1;
  }
  const std::uint64_t tree_bytes = micromap::packed_bytes(s.tree.size(), Format::two_state);
  if (all.size() != tree_bytes + micromap::packed_bytes(leaves, f)) return std::nullopt;
  s.data = micromap::unpack(all.subspan(tree_bytes), f, leaves);
  const Bytes again = bytes(s, f);
  if (!std::equal(all.begin(), all.end(), again.begin(), again.end())) return std::nullopt;
  return s;
}

// ---- Closed forms

/// The number of nodes of the tree of a map in which no four siblings are alike, which is the greatest: (4^(n+1) - 1) /
/// 3, of which 4^n are leaves.  Domain: n in 0..30.  Source: Succinct Opacity Micromaps, 6.2.1 and figure 10.
constexpr std::uint64_t most_nodes(Level n) { return (micromap::micro_triangles(n + 1) - 1) / 3; }

/// The greatest number of bits of both sequences: most_nodes(n) + b 4^n.
constexpr std::uint64_t most_bits(Level n, Format f) {
  return most_nodes(n) + micromap::bits(f) * micromap::micro_triangles(n);
}

/// The number of tree bits that Algorithm 3 reads for index k of that largest tree: one for the root, and for each
/// digit c of level m counted from the top, c subtrees of level n-m and the child's own bit.
///   1 + sum over m of (c_m most_nodes(n-m) + 1);  at most most_nodes(n), for the last index.
/// Source: Succinct Opacity Micromaps, 6.2 and figure 9.
constexpr std::uint64_t bits_read_of_largest(Level n, std::uint64_t index) {
  std::uint64_t bits = 1;
  for (Level m = 1; m <= n; ++m) bits += (index >> 2 * (n - m) & 3) * most_nodes(n - m) + 1;
  return bits;
}

}  // namespace mmverify::spec::tree
