// The iteration of the turns that a set of rules has: an encoder and Algorithm 3 to run on maps.
#pragma once

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree::induction {

using spec::tree::Cursor;

/// The turns of Algorithms 1, 2 and 3 as the specification has them, so that a mutant can have one of them wrong.
struct Specified {
  template <class Child>
  static Child merged(const Child* child) {
    return spec::tree::merged(child);
  }
  template <class Stack, class Output>
  static bool succinct_turn(Stack& stack, Output& s) {
    return spec::tree::succinct_turn(stack, s);
  }
  template <class Tree, class Count>
  static bool bitscan_turn(const Tree& tree, Count& child, Cursor<Count>& at) {
    return spec::tree::bitscan_turn(tree, child, at);
  }
  template <class Sequences, class Count, class NextChild>
  static bool lookup_turn(const Sequences& s, Cursor<Count>& at, NextChild& next_child) {
    return spec::tree::lookup_turn(s, at, next_child);
  }
};

/// Sequences whose reader is told where they end: wrong rules read beyond.
template <class Rules>
struct Read {
  struct Tree {
    const std::vector<bool>& bits;
    std::uint64_t size() const { return bits.size(); }
    bool operator[](std::uint64_t t) const { return bits.at(t); }
    friend Cursor<std::uint64_t> bitscan(const Tree& tree, std::uint64_t child, Cursor<std::uint64_t> at) {
      while (Rules::bitscan_turn(tree, child, at)) continue;
      return at;
    }
  };
  Tree tree;
};

/// The state that Algorithm 3 finds, or no state.
template <class Rules>
std::uint8_t state_by_rules(const spec::tree::Succinct& s, Level n, std::uint32_t index) {
  constexpr std::uint8_t nothing = 0xFF;
  Level depth = 0;
  const auto next_child = [&] {
    if (depth == n) throw std::out_of_range("no digit left");
    return std::uint64_t{index >> 2 * (n - ++depth) & 3};
  };
  try {
    const Read<Rules> read{{s.tree}};
    Cursor<std::uint64_t> at{0, 0};
    while (Rules::lookup_turn(read, at, next_child)) continue;
    return spec::micromap::code(s.data.at(at.d));
  } catch (const std::out_of_range&) {
    return nothing;
  }
}

template <class Rules>
spec::tree::Succinct encoded_by_rules(const Map& map) {
  const Level n = map.level;
  const States states = spec::micromap::unpack(map.packed, map.format, spec::micromap::micro_triangles(n));
  spec::tree::PerfectTree perfect{n, std::vector<std::vector<std::optional<State>>>(n + 1)};
  perfect.node[n].assign(states.begin(), states.end());
  for (Level level = n; level-- > 0;)
    for (std::size_t k = 0; k < spec::micromap::micro_triangles(level); ++k)
      perfect.node[level].push_back(Rules::merged(&perfect.node[level + 1][4 * k]));
  spec::tree::Succinct s;
  std::vector<spec::tree::Node> stack{{&perfect, 0, 0}};
  while (Rules::succinct_turn(stack, s)) continue;
  return s;
}

/// Maps encoded, and states found, by the turns; the codes' bytes are the paper's.
template <class Rules>
Functions functions_by_rules() {
  using spec::tree::Succinct;
  Functions functions;
  functions.encode = [](const Map& map) {
    return coded(map.level, map.format, encoded_by_rules<Rules>(map));
  };
  functions.decode = [](const Code& c) {
    States states;
    for (std::uint32_t k = 0; k < spec::micromap::micro_triangles(c.level); ++k)
      states.push_back(static_cast<State>(state_by_rules<Rules>(form_of<Succinct>(c), c.level, k)));
    return spec::micromap::pack(states, c.format);
  };
  functions.lookup = [](const Code& c, std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
    for (std::size_t k = 0; k < index.size(); ++k)
      state[k] = state_by_rules<Rules>(form_of<Succinct>(c), c.level, index[k]);
  };
  functions.bytes = [](const Code& c) { return spec::tree::bytes(form_of<Succinct>(c), c.format); };
  functions.writes_paper = true;
  return functions;
}

}  // namespace mmverify::proofs::tree::induction
