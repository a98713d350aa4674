#include "bench/vq/rivals/prune.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

namespace mmverify::bench::rivals {
namespace {

/// The least loss with at most this many bits; it never rises, and its last value holds for all more bits.
using Losses = std::vector<std::uint32_t>;

std::uint32_t at(const Losses& losses, std::uint32_t bits) {
  return losses[std::min<std::size_t>(bits, losses.size() - 1)];
}

/// The least losses of two parts together, up to `most` bits.
Losses together(const Losses& a, const Losses& b, std::uint32_t most) {
  const std::size_t size = std::min<std::size_t>(a.size() + b.size() - 1, std::size_t{most} + 1);
  Losses sum(size, ~std::uint32_t{0});
  for (std::size_t i = 0; i < std::min(a.size(), size); ++i)
    for (std::size_t j = 0; j < std::min(b.size(), size - i); ++j)
      sum[i + j] = std::min(sum[i + j], a[i] + b[j]);
  return sum;
}

struct Node {
  std::uint32_t x = 0, y = 0, side = 0;
  std::uint32_t loss = 0;  ///< if the whole node becomes C
  bool split = false;      ///< its regions differ
  Losses losses = {0};     ///< by bits beyond the node's own
  std::vector<Node> children = {};
  std::vector<Losses> sums = {};  ///< of the first child, the first two, ...
};

class Pruner {
 public:
  Pruner(States map, std::uint32_t side, const TreeCost& cost, std::uint32_t budget, Weights weights)
      : side_(side), cost_(cost), budget_(budget), weights_(weights), map_(map.begin(), map.end()) {}

  std::vector<State> run(std::uint32_t root) {
    Node all;
    for (std::uint32_t y = 0; y < side_; y += root)
      for (std::uint32_t x = 0; x < side_; x += root) all.children.push_back(node(x, y, root));
    add_up(all);
    spend(all, budget_);
    return std::move(map_);
  }

 private:
  Node node(std::uint32_t x, std::uint32_t y, std::uint32_t side) const {
    Node n{.x = x, .y = y, .side = side};
    for (std::uint32_t k = 0; k < side * side; ++k)
      n.loss += weights_.of(map_[x + k % side + side_ * (y + k / side)]);
    n.split = !uniform(map_, side_, x, y, side);
    if (!n.split) return n;
    if (side == 2) {
      n.losses.assign(cost_.last, n.loss);
      n.losses.push_back(0);
      return n;
    }
    for (std::uint32_t k = 0; k < 4; ++k)
      n.children.push_back(node(x + k % 2 * (side / 2), y + k / 2 * (side / 2), side / 2));
    add_up(n);
    n.losses.assign(split_bits(), n.loss);
    for (const std::uint32_t loss : n.sums.back()) n.losses.push_back(std::min(loss, n.loss));
    return n;
  }

  std::uint32_t split_bits() const { return cost_.inner + 4 * cost_.node; }

  void add_up(Node& n) const {
    n.sums = {n.children.front().losses};
    for (std::size_t k = 1; k < n.children.size(); ++k)
      n.sums.push_back(together(n.sums.back(), n.children[k].losses, budget_));
  }

  void clear(const Node& n) {
    for (std::uint32_t k = 0; k < n.side * n.side; ++k)
      map_[n.x + k % n.side + side_ * (n.y + k / n.side)] = State::C;
  }

  void decide(const Node& n, std::uint32_t bits) {
    if (!n.split) return;
    if (at(n.losses, bits) == n.loss)
      clear(n);
    else if (n.side > 2)
      spend(n, bits - split_bits());
  }

  /// Gives the bits to the children, the last one first, as the sums were made.
  void spend(const Node& n, std::uint32_t bits) {
    for (std::size_t k = n.children.size() - 1; k > 0; --k) {
      const std::uint32_t all = at(n.sums[k], bits);
      std::uint32_t own = 0;
      while (at(n.sums[k - 1], bits - own) + at(n.children[k].losses, own) != all) ++own;
      decide(n.children[k], own);
      bits -= own;
    }
    decide(n.children.front(), bits);
  }

  std::uint32_t side_;
  TreeCost cost_;
  std::uint32_t budget_;
  Weights weights_;
  std::vector<State> map_;
};

std::uint32_t bits_of_node(States map, std::uint32_t side, std::uint32_t x, std::uint32_t y,
                           std::uint32_t square, const TreeCost& cost) {
  if (uniform(map, side, x, y, square)) return cost.node;
  if (square == 2) return cost.node + cost.last;
  std::uint32_t bits = cost.node + cost.inner;
  for (std::uint32_t k = 0; k < 4; ++k)
    bits += bits_of_node(map, side, x + k % 2 * (square / 2), y + k / 2 * (square / 2), square / 2, cost);
  return bits;
}

}  // namespace

std::uint32_t checked_side(States map, std::uint32_t root) {
  for (std::uint32_t side = 2; side <= 64; side *= 2)
    if (map.size() == std::size_t{side} * side && std::has_single_bit(root) && root >= 2 && root <= side)
      return side;
  throw std::invalid_argument(
      "vq rivals: a map of 2x2 to 64x64 regions, and roots of 2x2 at least within it");
}

bool uniform(States map, std::uint32_t side, std::uint32_t x, std::uint32_t y, std::uint32_t square) {
  for (std::uint32_t k = 0; k < square * square; ++k)
    if (map[x + k % square + side * (y + k / square)] != map[x + side * y]) return false;
  return true;
}

std::vector<State> without_o_beside_t(States map, Weights weights) {
  const std::uint32_t side = checked_side(map, 2);
  std::vector<State> out(map.begin(), map.end());
  for (std::uint32_t vector = 0; vector < side * side / 4; ++vector) {
    const std::uint32_t corner = vector % (side / 2) * 2 + side * (vector / (side / 2) * 2);
    const std::uint32_t four[] = {corner, corner + 1, corner + side, corner + side + 1};
    const auto count = [&](State s) {
      return static_cast<std::uint32_t>(
          std::count_if(four, four + 4, [&](std::uint32_t k) { return map[k] == s; }));
    };
    const std::uint32_t t = count(State::T), o = count(State::O);
    if (t == 0 || o == 0) continue;
    const State lighter = t * weights.t <= o * weights.o ? State::T : State::O;
    for (const std::uint32_t k : four)
      if (out[k] == lighter) out[k] = State::C;
  }
  return out;
}

std::uint32_t tree_bits(States map, std::uint32_t root, const TreeCost& cost) {
  const std::uint32_t side = checked_side(map, root);
  std::uint32_t bits = 0;
  for (std::uint32_t y = 0; y < side; y += root)
    for (std::uint32_t x = 0; x < side; x += root)
      bits += cost.root + bits_of_node(map, side, x, y, root, cost);
  return bits;
}

std::vector<State> pruned(States map, std::uint32_t root, const TreeCost& cost, std::uint32_t budget,
                          Weights weights) {
  const std::uint32_t side = checked_side(map, root), roots = side / root * (side / root),
                      of_roots = roots * (cost.root + cost.node);
  if (budget < of_roots) throw std::invalid_argument("vq rivals: the budget has no room for the roots");
  return Pruner(map, side, cost, budget - of_roots, weights).run(root);
}

}  // namespace mmverify::bench::rivals
