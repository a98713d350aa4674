#include "impl/attribute/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "impl/attribute/bake/frame.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::attribute {
namespace {

using detail::Frame;
using detail::Point;
using Source = detail::Source<std::uint8_t>;

/// A corner of a part of a micro-triangle: its place in texels, and its (s, t).
struct Corner {
  double x, y, s, t;
};

/// A convex part of a micro-triangle, with nine corners at most: a triangle cut by four lines.
struct Part {
  std::array<Corner, 12> at;
  std::size_t size = 0;

  void add(const Corner& c) { at[size++] = c; }
};

Corner between(const Corner& a, const Corner& b, double f) {
  return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y), a.s + f * (b.s - a.s), a.t + f * (b.t - a.t)};
}

/// The part of `from` with sign (coordinate - limit) >= 0.
template <class Coordinate>
Part cut(const Part& from, Coordinate coordinate, double limit, double sign) {
  Part part;
  for (std::size_t k = 0; k < from.size; ++k) {
    const Corner &a = from.at[k], &b = from.at[(k + 1) % from.size];
    const double h = sign * (coordinate(a) - limit), next = sign * (coordinate(b) - limit);
    if (h >= 0) part.add(a);
    if ((h > 0 && next < 0) || (h < 0 && next > 0)) part.add(between(a, b, h / (h - next)));
  }
  return part;
}

/// Calls visit(k, strip) for the part's strips between k + 1/2 and k + 3/2.
template <class Coordinate, class Visit>
void each_strip(const Part& part, Coordinate coordinate, Visit visit) {
  double least = coordinate(part.at[0]), greatest = least;
  for (std::size_t k = 1; k < part.size; ++k) {
    least = std::min(least, coordinate(part.at[k]));
    greatest = std::max(greatest, coordinate(part.at[k]));
  }
  const auto last = static_cast<std::int64_t>(std::floor(greatest - 0.5));
  for (auto k = static_cast<std::int64_t>(std::floor(least - 0.5)); k <= last; ++k) {
    const double low = static_cast<double>(k) + 0.5;
    const Part strip = cut(cut(part, coordinate, low, 1), coordinate, low + 1, -1);
    if (strip.size > 0) visit(k, strip);
  }
}

/// The error of one channel on a part of a cell.
class Difference {
 public:
  /// Texture a + b x + c y + d x y from the cell's least corner, minus the map: shown[0..2] linear in (s, t).
  Difference(double column, double row, const std::array<double, 4>& texels,
             const std::array<double, 3>& shown)
      : column_(column),
        row_(row),
        a_(texels[0]),
        b_(texels[1] - texels[0]),
        c_(texels[2] - texels[0]),
        d_(texels[0] - texels[1] - texels[2] + texels[3]),
        shown_(shown) {}

  double operator()(const Corner& p) const {
    const double x = p.x - column_, y = p.y - row_;
    return a_ + b_ * x + c_ * y + d_ * x * y -
           (shown_[0] + p.s * (shown_[1] - shown_[0]) + p.t * (shown_[2] - shown_[0]));
  }

 private:
  double column_, row_, a_, b_, c_, d_;
  std::array<double, 3> shown_;
};

void judge(const Part& part, const Difference& e, double& largest, double& square) {
  for (std::size_t k = 0; k < part.size; ++k) {
    const Corner &p = part.at[k], &q = part.at[(k + 1) % part.size];
    const double e0 = e(p), em = e(between(p, q, 0.5)), e1 = e(q);
    largest = std::max(largest, std::fabs(e0));
    const double bend = 2 * (e0 - 2 * em + e1), f = -(e1 - e0 - bend) / (2 * bend);
    if (f > 0 && f < 1) largest = std::max(largest, std::fabs(e(between(p, q, f))));
  }
  for (std::size_t k = 2; k < part.size; ++k) {
    const std::array<Corner, 3> c{part.at[0], part.at[k - 1], part.at[k]};
    const double area =
        std::fabs((c[1].s - c[0].s) * (c[2].t - c[0].t) - (c[1].t - c[0].t) * (c[2].s - c[0].s));
    double form = 0;
    std::array<double, 3> at, middle;
    for (std::size_t m = 0; m < 3; ++m) {
      at[m] = e(c[m]);
      middle[m] = e(between(c[(m + 1) % 3], c[(m + 2) % 3], 0.5));
    }
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t l = (m + 1) % 3;
      form += 6 * at[m] * at[m] - 2 * at[m] * at[l] - 8 * at[m] * middle[m] + 32 * middle[m] * middle[m] +
              32 * middle[m] * middle[l];
    }
    square += area * form / 180;
  }
}

std::size_t vertex_number(const index::Vertex& at) {
  const std::size_t r = std::size_t{at.i} + at.j;
  return r * (r + 1) / 2 + at.j;
}

}  // namespace

MapError map_error(const RgbaView& texture, const AttributeSampling& sampling, const BaseTriangle& uv,
                   std::uint32_t level, MapForm form, std::span<const Rgba> map) {
  const Source source(texture, sampling);
  const std::size_t side = std::size_t{1} << std::min(level, max_attribute_level), faces = side * side;
  detail::check(uv, level, map.size(), form == MapForm::faces ? faces : (side + 1) * (side + 2) / 2);
  const Frame frame(source, uv, level);
  if (frame.width > 1 << 15 || frame.height > 1 << 15)
    throw std::invalid_argument("attribute: a triangle over more than 2^15 texels along an axis");
  const auto number = [&](const std::uint8_t* bytes, std::size_t k) {
    return source.coding().value(bytes[k], k) / source.coding().full(k);
  };
  MapError error;
  for (std::uint32_t k = 0; k < faces; ++k) {
    const index::Corners corners = index::corners(k, level);
    std::array<const std::uint8_t*, 3> shown;
    for (std::size_t c = 0; c < 3; ++c)
      shown[c] = (form == MapForm::faces ? map[k] : map[vertex_number(corners[c])]).data();
    Part triangle;
    for (std::size_t c = 0; c < 3; ++c) {
      const Point p = frame.at(corners[c].i, corners[c].j);
      triangle.add({p.x, p.y, c == 1 ? 1.0 : 0.0, c == 2 ? 1.0 : 0.0});
    }
    each_strip(
        triangle, [](const Corner& c) { return c.y; },
        [&](std::int64_t j, const Part& row) {
          each_strip(
              row, [](const Corner& c) { return c.x; },
              [&](std::int64_t i, const Part& part) {
                const std::int64_t x = source.column(frame.left + i),
                                   right = source.column(frame.left + i + 1), y = source.row(frame.top + j),
                                   below = source.row(frame.top + j + 1);
                const std::array<const std::uint8_t*, 4> texels{source.texel(x, y), source.texel(right, y),
                                                                source.texel(x, below),
                                                                source.texel(right, below)};
                for (std::size_t c = 0; c < 4; ++c) {
                  const Difference e(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5,
                                     {number(texels[0], c), number(texels[1], c), number(texels[2], c),
                                      number(texels[3], c)},
                                     {number(shown[0], c), number(shown[1], c), number(shown[2], c)});
                  judge(part, e, error.largest[c], error.square[c]);
                }
              });
        });
  }
  // Positions are within 8 u E of the true ones, and the texture changes by at most 1 a texel along each axis; the cuts
  // move corners by as little.  (s, t) and sums round by less than 2^-40 of numbers up to 1.
  const double off = 64 * frame.position + 0x1p-30;
  for (std::size_t c = 0; c < 4; ++c) {
    error.largest[c] += off;
    error.square[c] = error.square[c] / static_cast<double>(faces) + 2 * off;
  }
  return error;
}

void decimate_edges(std::uint32_t level, std::uint8_t edges, Meaning meaning, std::span<Rgba> vertices) {
  const std::uint32_t side = level > max_attribute_level ? 0 : 1u << level;
  if (level == 0 || level > max_attribute_level || vertices.size() != std::size_t{side + 1} * (side + 2) / 2)
    throw std::invalid_argument("attribute: vertices of a level in 1..12 can be decimated");
  const detail::Curves curves = detail::curves_of(meaning);
  for (std::uint32_t edge = 0; edge < 3; ++edge) {
    if ((edges >> edge & 1) == 0) continue;
    const auto at = [&](std::uint32_t k) -> Rgba& {  // from vertex `edge` to the next
      const index::Vertex v = edge == 0   ? index::Vertex{k, 0}
                              : edge == 1 ? index::Vertex{side - k, k}
                                          : index::Vertex{0, side - k};
      return vertices[vertex_number(v)];
    };
    for (std::uint32_t k = 1; k < side; k += 2) {
      const Rgba &a = at(k - 1), &b = at(k + 1);
      Rgba& middle = at(k);
      for (std::size_t c = 0; c < 4; ++c)
        middle[c] = curves[c]->exact_code(std::int64_t{curves[c]->number[a[c]]} + curves[c]->number[b[c]],
                                          std::int64_t{2});
    }
  }
}

}  // namespace mmverify::impl::attribute
