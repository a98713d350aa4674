// One mip of a case, as a micro-triangle sees it: which signs alpha - threshold has there.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/bake/addressing.hpp"
#include "tests/foreign/bake/faults.hpp"
#include "tests/foreign/bake/field.hpp"
#include "tests/foreign/bake/fraction.hpp"
#include "tests/foreign/bake/geometry.hpp"
#include "tests/foreign/bake/numbers.hpp"

namespace mmverify::tests::foreign::bake {

/// A micro-triangle, or a node above it, by three micro-vertices in units of the level.
struct Node {
  std::array<std::array<std::uint32_t, 2>, 3> corners;
};

enum class Aim { both_sides, any_negative, any_positive };

inline bool settled(unsigned seen, Aim aim) {
  switch (aim) {
    case Aim::both_sides: return (seen & negative) != 0 && (seen & (zero | positive)) != 0;
    case Aim::any_negative: return (seen & negative) != 0;
    default: return (seen & positive) != 0;
  }
}

/// One mip of one case: all that a micro-triangle is asked.  T: the whole numbers that hold its places.
template <class T>
class Sampled {
 public:
  Sampled(const mmverify_bake_case_t& c, const Mip& mip, unsigned number, bool nearest);

  /// Which signs alpha - threshold has on the closed node, grown by the margin; enough of them for `aim`.
  unsigned signs(const Node& node, const Field& f, Aim aim) const {
    const auto polygon = polygon_of(node);
    if (nearest_) return nearest_signs(polygon, f, aim);
    return bilinear_signs(polygon, f, aim, node);
  }

  /// The sign at the centroid.
  int centroid_sign(const Node& node, const Field& f) const;

  /// Alpha at a corner of the node, and whether it has an area (for faults that look at little).
  int corner_sign(const Node& node, const Field& f, std::size_t k) const {
    const Node point{{node.corners[k], node.corners[k], node.corners[k]}};
    const unsigned s = signs_of_point(point, f);
    return (s & negative) != 0 ? -1 : (s & positive) != 0 ? 1 : 0;
  }

 private:
  // sampled.cpp
  static Big rounded(double x, const T& unit);  // x 2^-40 in units
  Point<T> vertex(const std::array<std::uint32_t, 2>& k) const;
  std::vector<Point<T>> polygon_of(const Node& node) const;

  Range local(Range r, std::size_t axis) const {
    if (r.high == endless) return r;
    return {r.low - origin_[axis], r.high - origin_[axis]};
  }

  /// The position in storage of a texel counted from the origin; the border follows the last texel.
  std::size_t texel(Index i, Index j) const {
    Index x = wrapped(i + origin_[0], mip_.width, wrap_u_, true),
          y = wrapped(j + origin_[1], mip_.height, wrap_v_, false);
    if (x < 0 || y < 0) {
      const bool both = has(border_needs_both) && wrap_u_ == MMVERIFY_CLAMP_TO_BORDER &&
                        wrap_v_ == MMVERIFY_CLAMP_TO_BORDER;
      if (!both || (x < 0 && y < 0)) return mip_.count;
      x = x < 0 ? (i + origin_[0] < 0 ? 0 : mip_.width - 1) : x;
      y = y < 0 ? (j + origin_[1] < 0 ? 0 : mip_.height - 1) : y;
    }
    if (has(column_in_8_bits)) x &= 255;
    if (has(row_in_5_bits)) y &= 31;
    if (has(rows_from_bottom)) y = mip_.height - 1 - y;
    Index offset = y * (has(stride_is_height) ? mip_.height : mip_.width) + x;
    if (has(stride_is_height)) offset %= static_cast<Index>(mip_.count);
    if (has(offset_in_16_bits)) offset &= 65535;
    return static_cast<std::size_t>(offset);
  }

  static int sign_of(const Field& f, std::size_t k) {
    return (f.signs[k] & negative) != 0 ? -1 : (f.signs[k] & positive) != 0 ? 1 : 0;
  }

  struct Box {
    Index left, right, top, bottom;
  };
  /// The cells that a polygon meets, those that look alike counted once.
  Box cells_of(const std::vector<Point<T>>& polygon) const {
    T left = polygon[0].x, right = left, top = polygon[0].y, bottom = top;
    for (const auto& p : polygon) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
    const auto cell = [&](const T& x, Range r) {
      return std::clamp(index_of(floor_div(x, unit_)), r.low, r.high);
    };
    return {cell(left, columns_), cell(right, columns_), cell(top, rows_), cell(bottom, rows_)};
  }

  void spend(Index n) const {
    if (n > Index{1} << 22) throw Declined{};
  }

  // nearest.cpp
  unsigned nearest_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim) const;
  /// A fault's: counts the texel whose high corner a vertex of the polygon is.
  void corner_hit(const T& n, const T& d, const T& low, const std::vector<Point<T>>& polygon, Index from,
                  Index& first) const;

  unsigned signs_of_point(const Node& node, const Field& f) const {
    const Point<T> p = vertex(node.corners[0]);
    const std::vector<Point<T>> one{p};
    return nearest_ ? nearest_signs(one, f, Aim::both_sides)
                    : exact_signs(one, f, Aim::both_sides, true, node);
  }

  // bilinear.cpp
  unsigned bilinear_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim,
                          const Node& node) const;
  int clockwise_sign() const { return sign(T(along_u_[0] * along_v_[1] - along_u_[1] * along_v_[0])); }
  bool clockwise() const { return clockwise_sign() < 0; }
  bool is_sliver() const;
  /// The signs of all texels of all cells about a polygon.
  unsigned texel_signs(const std::vector<Point<T>>& polygon, const Field& f) const;

  bool stands_still_counts(std::size_t edge, bool least) const {
    if (has(no_critical_point) || (has(no_critical_second_edge) && edge == 1)) return false;
    if (has(no_critical_point_at_6) && case_.level >= 6) return false;
    return !(least ? has(no_critical_minimum) : has(no_critical_maximum));
  }

  // rough.cpp
  /// Signs from binary64.  All of it is off by a few dozen roundings of numbers that are at most the extent.
  unsigned rough_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside,
                       bool& unsure, const Node& node) const;
  /// Visits the texels inside the polygon within rows first..last, until `visit` returns false.
  template <class Visit>
  void rough_interior(const std::vector<Point<double>>& p, Index first, Index last, const Visit& visit) const;
  template <class Meet>
  void saddles(const Box& box, const Field& f, const Meet& meet) const;
  template <class Meet>
  void rough_segment(const Field& f, Index i, Index j, Point<double> p, Point<double> q, std::size_t edge,
                     const Meet& meet, const Node&) const;

  // exact.cpp
  /// The same in whole numbers, as wide as it takes.
  unsigned exact_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside,
                       const Node& node) const;
  unsigned tolerant_signs(const std::vector<Point<T>>& polygon, const Field& f, bool inside, bool& unsure,
                          const Node& node) const;
  template <class E>
  unsigned whole_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside) const;
  /// The signs of a + bx + cy + dxy along (p.x + t dx, p.y + t dy), t0 <= t <= t1, all in units of the cell.
  template <class E>
  unsigned whole_segment(const Field& f, Index i, Index j, const Point<E>& p, const E& dx, const E& dy,
                         const Fraction<E>& t0, const Fraction<E>& t1, std::size_t edge) const;

  const mmverify_bake_case_t& case_;
  const Mip& mip_;
  [[maybe_unused]] unsigned number_;
  bool nearest_;
  T start_[2], along_u_[2], along_v_[2], margin_[2], unit_;
  Index origin_[2];
  double unit_real_;
  int place_bits_;
  unsigned wrap_u_, wrap_v_;
  Range columns_, rows_;
  Index along_all_, down_all_;
};

}  // namespace mmverify::tests::foreign::bake
