#include "bench/vq/rivals/quad_tree.hpp"

#include "bench/vq/rivals/nodes.hpp"

namespace mmverify::bench::rivals {
namespace {

constexpr std::uint32_t split = 3, mini_bits = 5;

std::uint32_t mini_of(States map, std::uint32_t side, const Corner& n) {
  std::uint32_t code = 0;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const State s = map[n.x + k % 2 + side * (n.y + k / 2)];
    code |= (s == State::C ? 1u : 0u) << k | (s == State::O ? 16u : 0u);
  }
  return code;
}

State of_mini(std::uint32_t code, std::uint32_t k) {
  return (code >> k & 1) != 0 ? State::C : (code & 16) != 0 ? State::O : State::T;
}

}  // namespace

Bits QuadTree::encode(States map, std::uint32_t budget) const {
  const std::uint32_t side = checked_side(map, root);
  const std::vector<State> kept = pruned(without_o_beside_t(map, weights), root, cost, budget, weights);
  Bits bits;
  Corners level = roots_of(side, root);
  for (std::uint32_t square = root; square > 1; square /= 2) {
    Corners splits;
    for (const Corner& n : level) {
      const bool alike = uniform(kept, side, n.x, n.y, square);
      bits.put(alike ? static_cast<std::uint32_t>(kept[n.x + side * n.y]) : split, 2);
      if (!alike) splits.push_back(n);
    }
    if (square > 2) {
      level = children_of(splits, square);
    } else {
      for (const Corner& n : splits) bits.put(mini_of(kept, side, n), mini_bits);
    }
  }
  return bits;
}

std::vector<State> QuadTree::decode(Words words, std::uint32_t side) const {
  std::vector<State> map(std::size_t{side} * side);
  std::uint32_t at = 0;
  Corners level = roots_of(side, root);
  for (std::uint32_t square = root; square > 1; square /= 2) {
    Corners splits;
    for (const Corner& n : level) {
      const std::uint32_t code = field(words, at, 2);
      at += 2;
      if (code == split)
        splits.push_back(n);
      else
        fill(map, side, n, square, static_cast<State>(code));
    }
    if (square > 2) {
      level = children_of(splits, square);
      continue;
    }
    for (const Corner& n : splits) {
      const std::uint32_t code = field(words, at, mini_bits);
      at += mini_bits;
      for (std::uint32_t k = 0; k < 4; ++k) map[n.x + k % 2 + side * (n.y + k / 2)] = of_mini(code, k);
    }
  }
  return map;
}

State QuadTree::region(Words words, std::uint32_t side, std::uint32_t x, std::uint32_t y) const {
  const std::uint32_t across = side / root;
  std::uint32_t level = 0, nodes = across * across, node = x / root + across * (y / root);
  for (std::uint32_t square = root;; square /= 2) {
    const std::uint32_t code = field(words, level + 2 * node, 2);
    if (code != split) return static_cast<State>(code);
    const std::uint32_t before = threes(words, level, node), half = square / 2;
    const std::uint32_t child = x / half % 2 + 2 * (y / half % 2);
    if (square == 2) return of_mini(field(words, level + 2 * nodes + mini_bits * before, mini_bits), child);
    const std::uint32_t splits = before + threes(words, level + 2 * node, nodes - node);
    level += 2 * nodes;
    nodes = 4 * splits;
    node = 4 * before + child;
  }
}

}  // namespace mmverify::bench::rivals
