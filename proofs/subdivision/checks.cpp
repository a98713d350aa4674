#include "proofs/subdivision/checks.hpp"

#include "spec/index/index.hpp"
#include "spec/rational.hpp"

namespace mmverify::proofs::subdivision {
namespace {

using spec::subdivision::breaks_after;
using spec::subdivision::cells;
using spec::subdivision::shared;

Finding same(std::uint64_t expected, std::uint64_t got) {
  return expected == got ? Finding{got + 1} : wrong(std::to_string(expected), std::to_string(got));
}

std::string text_of(const Cut& c, const Corners<Whole>& corners) {
  std::string text;
  for (std::size_t k = 0; k < c.corners; ++k) {
    text += k == 0 ? "(" : " (";
    for (std::size_t axis = 0; axis < c.dimension; ++axis)
      text += fmt::format("{}{}", axis == 0 ? "" : ",", corners[k][axis]);
    text += ")";
  }
  return text;
}

std::uint64_t digest_of(const Corners<Whole>& corners) {
  std::uint64_t digest = 1;
  for (const At<Whole>& corner : corners)
    for (const Whole x : corner) digest = digest * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(x);
  return digest;
}

/// The bits of a set of at most most_children, as a number.
using Set = std::uint32_t;

/// The fewest steps without a common facet, over all orders of cells; by sets of visited cells and their last one.
unsigned fewest_in_any_order(const Cut& c, const std::vector<Corners<Whole>>& cells) {
  const std::size_t count = cells.size();
  constexpr unsigned never = ~0u;
  std::vector<std::vector<unsigned>> least(std::size_t{1} << count, std::vector<unsigned>(count, never));
  for (std::size_t k = 0; k < count; ++k) least[std::size_t{1} << k][k] = 0;
  for (Set visited = 1; visited < Set{1} << count; ++visited)
    for (std::size_t last = 0; last < count; ++last)
      for (std::size_t next = 0; next < count; ++next) {
        if (least[visited][last] == never || (visited >> next & 1) != 0) continue;
        const unsigned with =
            least[visited][last] + (shared(c, cells[last], cells[next]) < c.dimension ? 1 : 0);
        unsigned& known = least[visited | Set{1} << next][next];
        known = std::min(known, with);
      }
  return *std::min_element(least.back().begin(), least.back().end());
}

}  // namespace

Finding index_is_specified(const SubdivisionSubject& s, const Placed& at) {
  return same(specified_index(at.scheme, at.level, at.point),
              s.functions.index(at.scheme, at.level, at.point));
}

Finding in_one_cell(const SubdivisionSubject& s, const Placed& at) {
  const Cut c = cut(at.scheme);
  const auto [p, unit] = in_wholes(at.scheme, at.level, at.point);
  const auto direction = direction_from(c, base(at.scheme, unit).corners, p);
  std::string with;
  unsigned count = 0;
  for (std::uint64_t k = 0; k < cells(at.scheme, at.level); ++k)
    if (holds(c, spec::subdivision::cell(at.scheme, at.level, k, unit).corners, p, direction)) {
      with += fmt::format("{}{}", count == 0 ? "" : " and ", k);
      ++count;
    }
  const std::string got = std::to_string(s.functions.index(at.scheme, at.level, at.point));
  return count == 1 && with == got ? Finding{std::stoull(got) + 1}
                                   : wrong(count == 0 ? "no cell" : with, got);
}

Finding nested(const SubdivisionSubject& s, const Placed& at) {
  const std::uint64_t index = s.functions.index(at.scheme, at.level, at.point);
  if (at.level == 0) return same(0, index);
  const std::uint64_t parent = s.functions.index(at.scheme, at.level - 1, at.point);
  const unsigned b = cut(at.scheme).children;
  if (index / b == parent) return {index + 1};
  return wrong(fmt::format("{} at level {}, of {}", index / b, at.level - 1, index), std::to_string(parent));
}

Finding is_micromaps(const SubdivisionSubject& s, const Placed& at) {
  const auto coordinate = [&](std::size_t k) {
    return spec::Rational(at.point.numerators[k]) / spec::Rational(at.point.denominator);
  };
  const std::uint64_t index = s.functions.index(at.scheme, at.level, at.point);
  const Finding found = same(
      spec::index::reference(spec::Point<spec::Rational>{coordinate(0), coordinate(1)}, at.level), index);
  if (!found.holds) return found;
  const auto corners = s.functions.corners(at.scheme, at.level, index);
  const spec::index::Corners right = spec::index::corners(static_cast<std::uint32_t>(index), at.level);
  for (std::size_t k = 0; k < 3; ++k)
    if (corners[k] != At<Whole>{right[k].i, right[k].j, 0})
      return wrong(fmt::format("corner {} of cell {} at ({},{})", k, index, right[k].i, right[k].j),
                   fmt::format("({},{})", corners[k][0], corners[k][1]));
  return found;
}

Finding corners_are_specified(const SubdivisionSubject& s, const Indexed& at) {
  const Cut c = cut(at.scheme);
  const auto right =
      spec::subdivision::cell<Whole>(at.scheme, at.level, at.index, side(at.scheme, at.level)).corners;
  const auto got = s.functions.corners(at.scheme, at.level, at.index);
  return right == got ? Finding{digest_of(got)} : wrong(text_of(c, right), text_of(c, got));
}

Finding inverse(const SubdivisionSubject& s, const Indexed& at) {
  const Cut c = cut(at.scheme);
  const auto corners = s.functions.corners(at.scheme, at.level, at.index);
  // Near each corner, and in the middle: corner k counts 25 times, the others once each.
  for (std::size_t k = 0; k <= c.corners; ++k) {
    const Whole weight = k == c.corners ? 1 : 25, all = c.corners - 1 + weight;
    Fractions p{{}, static_cast<std::uint32_t>(all * side(at.scheme, at.level))};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Whole sum = 0;
      for (std::size_t j = 0; j < c.corners; ++j) sum += (j == k ? weight : 1) * corners[j][axis];
      if (sum < 0 || sum > p.denominator) return wrong("corners in the unit shape", text_of(c, corners));
      p.numerators[axis] = static_cast<std::uint32_t>(sum);
    }
    if (const Finding found = same(at.index, s.functions.index(at.scheme, at.level, p)); !found.holds)
      return found;
  }
  return {at.index + 1};
}

Finding contiguous(const SubdivisionSubject& s, const Indexed& at) {
  if (at.index + 1 == cells(at.scheme, at.level)) return {1};
  const Cut c = cut(at.scheme);
  const unsigned count = shared(c, s.functions.corners(at.scheme, at.level, at.index),
                                s.functions.corners(at.scheme, at.level, at.index + 1));
  const bool breaks = breaks_after(at.scheme, at.index);
  if (at.scheme == Scheme::morton)
    return breaks == (count < c.dimension)
               ? Finding{count + 2}
               : wrong(breaks ? "no edge" : "an edge", fmt::format("{} corners in common", count));
  return same(breaks ? 1 : c.dimension, count);
}

Finding fewest_breaks(const SubdivisionSubject& s, Scheme scheme) {
  const Cut c = cut(scheme);
  std::vector<Corners<Whole>> children;
  unsigned breaks = 0;
  for (std::uint64_t k = 0; k < c.children; ++k) {
    children.push_back(s.functions.corners(scheme, 1, k));
    breaks += k > 0 && shared(c, children[k - 1], children[k]) < c.dimension ? 1 : 0;
  }
  return same(fewest_in_any_order(c, children), breaks);
}

Finding dead_ends(const SubdivisionSubject& s, Scheme scheme, Level n) {
  const Cut c = cut(scheme);
  std::map<std::vector<At<Whole>>, unsigned> on_facet;
  const auto facets = [&](std::uint64_t k) {
    const auto corners = s.functions.corners(scheme, n, k);
    std::vector<std::vector<At<Whole>>> all;
    for (std::size_t off = 0; off < c.corners; ++off) {
      all.emplace_back();
      for (std::size_t j = 0; j < c.corners; ++j)
        if (j != off) all.back().push_back(corners[j]);
      std::sort(all.back().begin(), all.back().end());
    }
    return all;
  };
  for (std::uint64_t k = 0; k < cells(scheme, n); ++k)
    for (const auto& facet : facets(k)) ++on_facet[facet];
  std::uint64_t ends = 0;
  for (std::uint64_t k = 0; k < cells(scheme, n); ++k) {
    const auto all = facets(k);
    ends +=
        std::count_if(all.begin(), all.end(), [&](const auto& f) { return on_facet[f] == 2; }) == 1 ? 1 : 0;
  }
  return same(c.dimension + 1, ends);
}

}  // namespace mmverify::proofs::subdivision
