#include "proofs/index/known_orders.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "spec/index/index.hpp"

namespace mmverify::proofs::index {
namespace {

/// The curve with its children permuted in every digit.
std::uint32_t with_children(const Permutation& p, std::uint32_t index, Level n) {
  std::uint32_t permuted = 0;
  for (Level digit = 0; digit < n; ++digit) permuted |= p[index >> 2 * digit & 3] << 2 * digit;
  return permuted;
}

void add_turned(std::vector<KnownOrder>& all, const char* name,
                std::uint32_t (*order)(const GridPoint&, Level)) {
  all.push_back({name, order});
  std::array<int, 3> turn{0, 1, 2};
  while (std::next_permutation(turn.begin(), turn.end()))
    all.push_back({fmt::format("{}, with (w, u, v) taken as {}", name, letters_of(turn)),
                   [order, turn](const GridPoint& p, Level n) { return order(rearranged(p, turn), n); }});
}

}  // namespace

std::uint32_t in_u_major(const GridPoint& p, Level n) {
  const Fixed64 u = times(side(n), p.u), v = times(side(n), p.v);
  const std::uint32_t iu = whole(u), iv = whole(v);
  const bool upper = !(u - Fixed64(iu) + (v - Fixed64(iv)) < Fixed64(1));
  return 2 * side(n) * iu - iu * iu + 2 * iv + (upper ? 1 : 0);
}

std::uint32_t simplified(GridPoint p, Level n, bool flips, bool turns) {
  using spec::index::Reading;
  auto s = spec::index::first_step(p);
  for (Level depth = 0; depth < n; ++depth) {
    const bool top_flip = s.top_flip;
    auto next = spec::index::next_step<Reading::printed>(s);
    // Unturned, the middle triangle keeps u, v and w on the corners opposite to them.
    if (!turns && next.index % 4 == 1) {
      const Fixed64 one(1);
      next.u = one - times(2, s.u);
      next.v = one - times(2, s.v);
      next.w = one - times(2, s.w);
    }
    if (!flips) next.top_flip = top_flip;
    s = next;
  }
  return s.index;
}

std::string text_of_children(const Permutation& p) {
  std::vector<std::uint32_t> moved;
  for (std::uint32_t child = 0; child < 4; ++child)
    if (p[child] != child) moved.push_back(child);
  if (moved.size() == 2) return fmt::format("children {} and {} change places", moved[0], moved[1]);
  return fmt::format("children 0, 1, 2, 3 are numbered {}, {}, {}, {}", p[0], p[1], p[2], p[3]);
}

GridPoint rearranged(const GridPoint& p, const std::array<int, 3>& order) {
  const std::array<Fixed64, 3> wuv{Fixed64(1) - p.u - p.v, p.u, p.v};
  return {wuv[static_cast<std::size_t>(order[1])], wuv[static_cast<std::size_t>(order[2])]};
}

std::string letters_of(const std::array<int, 3>& order) {
  constexpr char letters[] = {'w', 'u', 'v'};
  return fmt::format("({}, {}, {})", letters[order[0]], letters[order[1]], letters[order[2]]);
}

const std::vector<KnownOrder>& known_orders() {
  static const std::vector<KnownOrder> all = [] {
    std::vector<KnownOrder> orders;
    add_turned(orders, "row order (w-minor)",
               [](const GridPoint& p, Level n) { return spec::index::w_minor(p, n); });
    add_turned(orders, "U-major, rows from the edge u = 0 on", in_u_major);
    orders.push_back({"the curve, but the flips of the top triangle are missing",
                      [](const GridPoint& p, Level n) { return simplified(p, n, false, true); }});
    orders.push_back({"the curve, but the middle triangle is not turned",
                      [](const GridPoint& p, Level n) { return simplified(p, n, true, false); }});
    orders.push_back(
        {"the curve, but the flips of the top triangle are missing and the middle triangle is not turned",
         [](const GridPoint& p, Level n) { return simplified(p, n, false, false); }});
    Permutation children = identity;
    while (std::next_permutation(children.begin(), children.end()))
      orders.push_back({"the curve, but " + text_of_children(children) + " in every digit",
                        [children](const GridPoint& p, Level n) {
                          return with_children(children, spec::index::reference(p, n), n);
                        }});
    return orders;
  }();
  return all;
}

}  // namespace mmverify::proofs::index
