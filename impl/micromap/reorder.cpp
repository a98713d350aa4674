#include "impl/micromap/reorder.hpp"

#include <algorithm>
#include <stdexcept>

namespace mmverify::impl::micromap {
namespace {

/// An order of corners: corner k of the new node is corner at[k] of the old.
struct Order {
  std::array<std::uint8_t, 3> at{};
  constexpr bool operator==(const Order&) const = default;
};

constexpr std::array<Order, 6> orders{
    {{{0, 1, 2}}, {{0, 2, 1}}, {{1, 0, 2}}, {{1, 2, 0}}, {{2, 0, 1}}, {{2, 1, 0}}}};

constexpr std::uint8_t number_of(const Order& order) {
  for (std::uint8_t k = 0; k < 6; ++k)
    if (orders[k] == order) return k;
  return 6;
}

/// The corners of a node's children: 0, 1, 2 are the node's own, 3 + k is the middle of the edge across from corner k.
///   {p0, p01, p02}, {p02, p12, p01}, {p01, p1, p12}, {p12, p02, p2}
constexpr std::uint8_t children[4][3] = {{0, 5, 4}, {4, 3, 5}, {5, 1, 3}, {3, 4, 2}};

/// The old child in the place of a new child, for an order of corners, and the order of its corners.
struct Step {
  std::uint8_t child, order;
};

constexpr Step step(std::uint8_t order, int child) {
  std::array<std::uint8_t, 3> point{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint8_t p = children[child][k];
    point[k] = static_cast<std::uint8_t>(orders[order].at[p % 3] + (p < 3 ? 0 : 3));
  }
  for (std::uint8_t old = 0; old < 4; ++old) {
    Order found;
    unsigned shared = 0;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::uint8_t m = 0; m < 3; ++m)
        if (children[old][m] == point[k]) {
          found.at[k] = m;
          ++shared;
        }
    if (shared == 3) return {old, number_of(found)};
  }
  return {4, 6};
}

constexpr std::array<std::array<Step, 4>, 6> steps = [] {
  std::array<std::array<Step, 4>, 6> all{};
  for (std::uint8_t order = 0; order < 6; ++order)
    for (int child = 0; child < 4; ++child) all[order][static_cast<std::size_t>(child)] = step(order, child);
  return all;
}();

class Reorder {
 public:
  Reorder(const std::uint8_t* from, Format f, std::uint8_t* to) : from_(from), to_(to), b_(bits(f)) {}

  /// Writes the 4^height states at `is` from those at `was`.
  void node(std::uint64_t was, std::uint64_t is, Level height, std::uint8_t order) {
    if (height == 0) {
      to_[is * b_ / 8] = static_cast<std::uint8_t>(to_[is * b_ / 8] | state(was) << (is * b_ % 8));
      return;
    }
    const std::uint64_t quarter = std::uint64_t{1} << (2 * (height - 1));
    for (std::uint64_t child = 0; child < 4; ++child) {
      const Step s = steps[order][child];
      node(was + s.child * quarter, is + child * quarter, height - 1, s.order);
    }
  }

 private:
  unsigned state(std::uint64_t at) const { return from_[at * b_ / 8] >> (at * b_ % 8) & ((1u << b_) - 1); }

  const std::uint8_t* from_;
  std::uint8_t* to_;
  unsigned b_;
};

}  // namespace

void reorder(std::span<const std::uint8_t> map, Level level, Format f, const VertexOrder& order,
             std::span<std::uint8_t> out) {
  const std::uint8_t number = number_of({order});
  if (number == 6) throw std::invalid_argument("reorder: no order of three vertices");
  if (level > 16) throw std::invalid_argument("reorder: a level above 16");
  if (const auto size = packed_bytes(micro_triangles(level), f); map.size() != size || out.size() != size)
    throw std::invalid_argument("reorder: a map of another size");
  std::fill(out.begin(), out.end(), std::uint8_t{0});
  Reorder(map.data(), f, out.data()).node(0, 0, level, number);
}

}  // namespace mmverify::impl::micromap
