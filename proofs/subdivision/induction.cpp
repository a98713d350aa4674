// The induction over the orientations of a scheme's cells: finitely many steps settle every level.
#include <deque>
#include <set>
#include <tuple>

#include "proofs/subdivision/checks.hpp"

namespace mmverify::proofs::subdivision {
namespace {

using spec::subdivision::across;
using spec::subdivision::breaks_after;
using spec::subdivision::facet;
using spec::subdivision::shared;

At<Whole> sum(const At<Whole>& a, const At<Whole>& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
At<Whole> product(Whole k, const At<Whole>& a) { return {k * a[0], k * a[1], k * a[2]}; }

/// Corners moved; those that a scheme does not have stay.
Corners<Whole> moved(const Cut& c, Corners<Whole> corners, const At<Whole>& by) {
  for (std::size_t k = 0; k < c.corners; ++k) corners[k] = sum(corners[k], by);
  return corners;
}

Corners<Whole> times(Whole k, Corners<Whole> corners) {
  for (At<Whole>& corner : corners) corner = product(k, corner);
  return corners;
}

/// A simplex's volume times a number that its dimension gives; a parallelogram's area.
Whole volume(const Cut& c, const Corners<Whole>& at) {
  const auto edge = [&](std::size_t k) { return difference(at[k], at[0]); };
  const bool quad = c.corners > c.dimension + 1;
  return std::abs(determinant(c.dimension, edge(1), edge(quad ? 3 : 2), edge(3)));
}

/// Whether all of `other` lies on one side of a facet of `one`: beyond it, or not beyond it.
bool on_side(const Cut& c, const Corners<Whole>& one, std::size_t f, const Corners<Whole>& other,
             bool beyond) {
  for (std::size_t k = 0; k < c.corners; ++k) {
    const Whole place = across(c, one, f, difference(other[k], one[facet(c, f).on[0]]));
    if (beyond ? place > 0 : place < 0) return false;
  }
  return true;
}

bool inside(const Cut& c, const Corners<Whole>& outer, const Corners<Whole>& inner) {
  for (std::size_t f = 0; f < c.corners; ++f)
    if (!on_side(c, outer, f, inner, false)) return false;
  return true;
}

/// Whether a facet of one of them has the other beyond it: then their interiors have no point in common.
bool apart(const Cut& c, const Corners<Whole>& a, const Corners<Whole>& b) {
  for (std::size_t f = 0; f < c.corners; ++f)
    if (on_side(c, a, f, b, true) || on_side(c, b, f, a, true)) return true;
  return false;
}

/// A scheme's machine, and the induction's parts.  Each returns what is wrong, or nothing.
class Induction {
 public:
  Induction(Scheme scheme, Machine machine)
      : scheme_(scheme), c_(cut(scheme)), machine_(std::move(machine)) {}

  std::string wrong_at_all() const {
    if (std::string e = wrong_start(); !e.empty()) return e;
    if (std::string e = wrong_children(); !e.empty()) return e;
    for (std::size_t k = 0; k < machine_.size(); ++k)
      if (std::string e = wrong_tiling(k); !e.empty()) return fmt::format("orientation {}: {}", k, e);
    return scheme_ == Scheme::morton ? std::string() : wrong_neighbours();
  }

  std::uint64_t steps() const { return machine_.size() * c_.children; }

 private:
  Corners<Whole> child(std::size_t k, std::size_t digit) const {
    return moved(c_, machine_[machine_[k].next[digit]].corners, machine_[k].shift[digit]);
  }

  /// The unit shape, and a direction of the tie rule into it from each of its corners.
  std::string wrong_start() const {
    for (const Orientation& o : machine_)
      for (const auto next : o.next)
        if (next >= machine_.size() || o.next.size() != c_.children || o.shift.size() != c_.children)
          return "no orientation for each child";
    const auto unit = spec::subdivision::base<Whole>(scheme_, 1).corners;
    if (machine_.empty() || moved(c_, machine_[0].corners, unit[0]) != unit) return "another unit shape";
    for (std::size_t k = 0; k < c_.corners; ++k)
      if (direction_from(c_, unit, unit[k]) == At<Whole>{}) return "no direction from a corner";
    return {};
  }

  /// The children of each orientation are the specification's, in each of its states that the cell may be in.
  std::string wrong_children() const {
    std::set<std::pair<std::size_t, unsigned>> known{{0, c_.state}};
    std::deque<std::pair<std::size_t, unsigned>> open(known.begin(), known.end());
    for (; !open.empty(); open.pop_front()) {
      const auto [k, state] = open.front();
      // The specification's means are whole on a grid that is finer by the parts.
      const spec::subdivision::Cell<Whole> cell{times(c_.parts, machine_[k].corners), state};
      for (unsigned digit = 0; digit < c_.children; ++digit) {
        const auto right = turn(scheme_, cell, digit);
        if (times(machine_[k].scale, right.corners) != times(c_.parts, child(k, digit)))
          return fmt::format("orientation {}: child {} lies elsewhere", k, digit);
        const std::pair next{machine_[k].next[digit], right.state};
        if (known.insert(next).second) open.push_back(next);
      }
    }
    return {};
  }

  /// The children lie in their parent, apart from each other, and have its volume together: they tile it.  No facet is
  /// parallel to a direction of the tie rule: so each point belongs to one of them.
  std::string wrong_tiling(std::size_t k) const {
    const Orientation& o = machine_[k];
    const auto parent = times(o.scale, o.corners);
    Whole together = 0;
    for (std::size_t i = 0; i < c_.children; ++i) {
      if (!inside(c_, parent, child(k, i))) return fmt::format("child {} lies beyond the parent", i);
      for (std::size_t j = 0; j < i; ++j)
        if (!apart(c_, child(k, i), child(k, j))) return fmt::format("children {} and {} overlap", j, i);
      together += volume(c_, child(k, i));
    }
    if (together != volume(c_, parent) || together == 0) return "the children leave a gap";
    for (std::size_t f = 0; f < c_.corners; ++f)
      for (std::size_t d = 0; d < c_.corners; ++d) {
        const At<int>& inward = c_.inward[d];
        if (across(c_, o.corners, f, At<Whole>{inward[0], inward[1], inward[2]}) == 0)
          return fmt::format("facet {} is parallel to direction {}", f, d);
      }
    return {};
  }

  /// Two cells that follow each other: their orientations, and the way from one's first corner to the other's.
  struct Pair {
    std::size_t one, other;
    At<Whole> way;
    bool breaks;
    bool operator<(const Pair& to) const {
      return std::tie(one, other, way, breaks) < std::tie(to.one, to.other, to.way, to.breaks);
    }
  };

  /// Siblings, and from each pair the last child of one and the first child of the other.
  std::string wrong_neighbours() const {
    std::set<Pair> known;
    std::deque<Pair> open;
    const auto add = [&](const Pair& pair) {
      if (known.insert(pair).second) open.push_back(pair);
    };
    for (const Orientation& o : machine_)
      for (unsigned d = 0; d + 1 < c_.children; ++d)
        add({o.next[d], o.next[d + 1], difference(o.shift[d + 1], o.shift[d]), breaks_after(scheme_, d)});
    for (; !open.empty(); open.pop_front()) {
      const Pair at = open.front();
      const Orientation &one = machine_[at.one], &other = machine_[at.other];
      const unsigned corners = shared(c_, one.corners, moved(c_, other.corners, at.way));
      if (corners != (at.breaks ? 1 : c_.dimension))
        return fmt::format("cells of orientations {} and {} that follow each other share {} corners", at.one,
                           at.other, corners);
      if (one.scale != other.scale) return "neighbours on two grids";
      add({one.next.back(), other.next.front(),
           sum(product(one.scale, at.way), difference(other.shift.front(), one.shift.back())), at.breaks});
    }
    return {};
  }

  Scheme scheme_;
  Cut c_;
  Machine machine_;
};

}  // namespace

Finding all_levels(const SubdivisionSubject& s, Scheme scheme) {
  const Induction induction(scheme, s.functions.machine(scheme));
  const std::string found = induction.wrong_at_all();
  return found.empty() ? Finding{induction.steps()} : wrong("each step of the induction holds", found);
}

Finding three_shapes(const SubdivisionSubject& s) {
  const Machine machine = s.functions.machine(Scheme::tetrahedron);
  const auto edges = [](const Orientation& o) {
    std::array<At<Whole>, 3> all{};
    for (std::size_t k = 0; k < 3; ++k) all[k] = difference(o.corners[k + 1], o.corners[k]);
    return all;
  };
  auto of_unit = edges(machine.front());
  std::sort(of_unit.begin(), of_unit.end());
  std::set<std::array<At<Whole>, 3>> orders;
  for (std::size_t k = 0; k < machine.size(); ++k) {
    auto sorted = edges(machine[k]);
    orders.insert(sorted);
    std::sort(sorted.begin(), sorted.end());
    if (sorted != of_unit)
      return wrong("the unit tetrahedron's edges 01, 12, 23 in some order",
                   fmt::format("others in orientation {}", k));
  }
  return orders.size() <= 6 ? Finding{orders.size()} : wrong("6 orders", std::to_string(orders.size()));
}

}  // namespace mmverify::proofs::subdivision
