#include "bench/vq/rivals/wavelet.hpp"

#include "bench/vq/rivals/nodes.hpp"

namespace mmverify::bench::rivals {
namespace {

constexpr std::uint32_t inner_bits = Wavelet::cost.inner, last_bits = Wavelet::cost.last;

std::uint32_t difference(State s, State from) {
  return (static_cast<std::uint32_t>(s) + 3 - static_cast<std::uint32_t>(from)) % 3;
}

State sum(State s, std::uint32_t d) { return static_cast<State>((static_cast<std::uint32_t>(s) + d) % 3); }

/// The difference of the child k = x + 2 y of a split node.
std::uint32_t difference_of(std::uint32_t code, std::uint32_t square, std::uint32_t k) {
  if (k == 0) return 0;
  if (square == 2) return (code >> (k - 1) & 1) != 0 ? 1 + (code >> 3) : 0;
  return (k == 1 ? code : k == 2 ? code / 3 : code / 9) % 3;
}

std::uint32_t differences(States map, std::uint32_t side, const Corner& n, std::uint32_t square) {
  const State first = map[n.x + side * n.y];
  std::uint32_t code = 0, power = 1;
  for (std::uint32_t k = 1; k < 4; ++k, power *= 3) {
    const std::uint32_t d =
        difference(map[n.x + k % 2 * (square / 2) + side * (n.y + k / 2 * (square / 2))], first);
    if (square > 2)
      code += d * power;
    else
      code |= (d != 0 ? 1u << (k - 1) : 0u) | (d == 2 ? 8u : 0u);
  }
  return code;
}

}  // namespace

Bits Wavelet::encode(States map, std::uint32_t budget) const {
  const std::uint32_t side = checked_side(map, root);
  const std::vector<State> kept = pruned(without_o_beside_t(map, weights), root, cost, budget, weights);
  Bits bits;
  Corners level = roots_of(side, root);
  for (const Corner& n : level) bits.put(static_cast<std::uint32_t>(kept[n.x + side * n.y]), 2);
  for (std::uint32_t square = root; square > 1; square /= 2) {
    Corners splits;
    for (const Corner& n : level) {
      const bool differs = !uniform(kept, side, n.x, n.y, square);
      bits.put(differs ? 1 : 0, 1);
      if (differs) splits.push_back(n);
    }
    for (const Corner& n : splits)
      bits.put(differences(kept, side, n, square), square > 2 ? inner_bits : last_bits);
    level = children_of(splits, square);
  }
  return bits;
}

std::vector<State> Wavelet::decode(Words words, std::uint32_t side) const {
  std::vector<State> map(std::size_t{side} * side);
  std::uint32_t at = 0;
  Corners level = roots_of(side, root);
  for (const Corner& n : level) {
    fill(map, side, n, root, static_cast<State>(field(words, at, 2)));
    at += 2;
  }
  for (std::uint32_t square = root; square > 1; square /= 2) {
    Corners splits;
    for (const Corner& n : level)
      if (field(words, at++, 1) != 0) splits.push_back(n);
    const std::uint32_t code_bits = square > 2 ? inner_bits : last_bits, half = square / 2;
    for (const Corner& n : splits) {
      const std::uint32_t code = field(words, at, code_bits);
      at += code_bits;
      const State first = map[n.x + side * n.y];
      for (std::uint32_t k = 1; k < 4; ++k)
        fill(map, side, {n.x + k % 2 * half, n.y + k / 2 * half}, half,
             sum(first, difference_of(code, square, k)));
    }
    level = children_of(splits, square);
  }
  return map;
}

State Wavelet::region(Words words, std::uint32_t side, std::uint32_t x, std::uint32_t y) const {
  const std::uint32_t across = side / root;
  std::uint32_t nodes = across * across, node = x / root + across * (y / root), flags = 2 * nodes;
  State s = static_cast<State>(field(words, 2 * node, 2));
  for (std::uint32_t square = root; square > 1; square /= 2) {
    if (field(words, flags + node, 1) == 0) return s;
    const std::uint32_t before = ones(words, flags, node), half = square / 2,
                        code_bits = square > 2 ? inner_bits : last_bits, codes = flags + nodes,
                        child = x / half % 2 + 2 * (y / half % 2);
    s = sum(s, difference_of(field(words, codes + code_bits * before, code_bits), square, child));
    if (square == 2) break;
    const std::uint32_t splits = before + ones(words, flags + node, nodes - node);
    flags = codes + code_bits * splits;
    nodes = 4 * splits;
    node = 4 * before + child;
  }
  return s;
}

}  // namespace mmverify::bench::rivals
