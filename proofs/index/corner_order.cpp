#include "proofs/index/corner_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "proofs/index/law_parts.hpp"

namespace mmverify::proofs::index {
namespace {

struct Named {
  CornerOrder order;
  std::array<const char*, 3> corners;
  const char* words;
};
constexpr Named known[] = {{CornerOrder::base_u_v, {"base", "+u", "+v"}, ""},
                           {CornerOrder::of_children, {"0", "2", "3"}, "children "}};

/// The corners in the order of the places.
Corners arranged(const Corners& c, const std::array<std::size_t, 3>& places) {
  return {c[places[0]], c[places[1]], c[places[2]]};
}

}  // namespace

Corners corners_in(CornerOrder order, std::uint32_t index, Level n) {
  const Corners c = spec::index::corners(index, n);
  if (order != CornerOrder::base_u_v) return c;
  // The base is the corner that shares j with one of the others and i with the other one.
  const auto base = std::find_if(c.begin(), c.end(), [&](const auto& p) {
    return std::count_if(c.begin(), c.end(), [&](const auto& q) { return p.i == q.i || p.j == q.j; }) == 3;
  });
  Corners ordered{*base, *base, *base};
  for (const auto& q : c) {
    if (q.j == base->j && q.i != base->i) ordered[1] = q;
    if (q.i == base->i && q.j != base->j) ordered[2] = q;
  }
  return ordered;
}

Corners sorted(Corners c) {
  std::sort(c.begin(), c.end(),
            [](const auto& a, const auto& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
  return c;
}

std::optional<MicroTriangle> triangle_of(const Corners& c, Level n) {
  std::uint32_t i = c[0].i, j = c[0].j, far_i = i, far_j = j;
  std::uint64_t sum = 0;
  for (const auto& vertex : c) {
    i = std::min(i, vertex.i), j = std::min(j, vertex.j);
    far_i = std::max(far_i, vertex.i), far_j = std::max(far_j, vertex.j);
  }
  if (far_i != i + 1 || far_j != j + 1 || c[0] == c[1] || c[0] == c[2] || c[1] == c[2]) return std::nullopt;
  // Of the square's four corners three are there: the missing one is (1,1) for an upright one, (0,0) for an
  // inverted.
  for (const auto& vertex : c) sum += (vertex.i - i) + (vertex.j - j);
  const bool upside_down = sum == 4;
  if (sum != 2 && !upside_down) return std::nullopt;
  for (const auto& vertex : c)
    if ((vertex.i - i) + (vertex.j - j) == (upside_down ? 0u : 2u)) return std::nullopt;
  if (std::uint64_t{i} + j + (upside_down ? 2 : 1) > side(n)) return std::nullopt;
  return MicroTriangle{i, j, upside_down};
}

std::string name_corner_order(const IndexSubject& subject, Level n) {
  std::vector<std::uint32_t> indices(std::min<std::uint64_t>(triangle_count(n), 1024));
  std::iota(indices.begin(), indices.end(), 0u);
  std::vector<Corners> got(indices.size());
  subject.functions.corners(n, indices, got);
  for (const Named& one : known) {
    std::array<std::size_t, 3> places{0, 1, 2};
    do {
      if (std::all_of(indices.begin(), indices.end(), [&](std::uint32_t k) {
            return got[k] == arranged(corners_in(one.order, k, n), places);
          }))
        return fmt::format("{}{}, {}, {}", one.words, one.corners[places[0]], one.corners[places[1]],
                           one.corners[places[2]]);
    } while (std::next_permutation(places.begin(), places.end()));
  }
  return "no order that is the same for all";
}

std::optional<std::string> declares_no_order(const Subject& subject, Level n) {
  if (const auto why = needing({entry::corners})(subject, n)) return why;
  const IndexSubject& s = of_index(subject);
  if (s.functions.corner_order != CornerOrder::undeclared) return std::nullopt;
  const Level at = std::min<Level>(3, s.functions.max_level);
  try {
    return fmt::format("{} declares no order of corners; at level {} it is {}", s.name(), at,
                       name_corner_order(s, at));
  } catch (const SubjectBroken&) {  // the laws that ask it on say so
    return s.name() + " declares no order of corners";
  }
}

std::vector<std::string> diagnose_corner_order(const Subject& subject, const Levels& levels) {
  return {fmt::format("its order of corners at level {}: {}", levels.last,
                      name_corner_order(of_index(subject), levels.last))};
}

}  // namespace mmverify::proofs::index
