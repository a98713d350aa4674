// The iteration of the turns that a set of rules has: an encoder and Algorithm 3 to run on maps.
#pragma once

#include <stdexcept>

#include "proofs/tree/induction/rules.hpp"
#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree::induction {

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

template <class Rules>
class CodeByRules : public Code {
 public:
  CodeByRules(spec::tree::Succinct s, Level n, Format f) : s_(std::move(s)), n_(n), format_(f) {}
  Bytes decode() const override {
    States states;
    for (std::uint32_t k = 0; k < spec::micromap::micro_triangles(n_); ++k)
      states.push_back(static_cast<State>(at(k)));
    return spec::micromap::pack(states, format_);
  }
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const override {
    for (std::size_t k = 0; k < index.size(); ++k) state[k] = at(index[k]);
  }
  Bytes bytes() const override { return spec::tree::bytes(s_, format_); }

 private:
  static constexpr std::uint8_t nothing = 0xFF;
  std::uint8_t at(std::uint32_t index) const {
    Level depth = 0;
    const auto next_child = [&] {
      if (depth == n_) throw std::out_of_range("no digit left");
      return std::uint64_t{index >> 2 * (n_ - ++depth) & 3};
    };
    try {
      const Read<Rules> read{{s_.tree}};
      Cursor<std::uint64_t> at{0, 0};
      while (Rules::lookup_turn(read, at, next_child)) continue;
      return spec::micromap::code(s_.data.at(at.d));
    } catch (const std::out_of_range&) {
      return nothing;
    }
  }
  spec::tree::Succinct s_;
  Level n_;
  Format format_;
};

template <class Rules>
class SubjectByRules : public TreeSubject {
 public:
  using TreeSubject::TreeSubject;
  bool has(Entry e) const override { return e == Entry::lookup || e == Entry::bytes || e == Entry::stream; }
  CodePtr encode(const Map& map) const override {
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
    return std::make_unique<CodeByRules<Rules>>(std::move(s), n, map.format);
  }
};

}  // namespace mmverify::proofs::tree::induction
