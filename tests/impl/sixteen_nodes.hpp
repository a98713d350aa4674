// Nodes of sixteen as the vector baker is given them, and the exact triangles that they stand for: drawn at random, and
// so that rounding matters.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "impl/bake/judge/filter.hpp"
#include "impl/bake/sixteen/bounds.hpp"
#include "impl/bake/sixteen/lanes.hpp"
#include "impl/bake/sixteen/sixteen.hpp"

namespace mmverify::tests {

using namespace mmverify::impl::bake;
using namespace mmverify::impl::bake::detail;

/// Exact coordinates are whole numbers of 2^-36 texels.
using Unit = std::int64_t;
constexpr int unit_bits = 36;
constexpr Unit texel = Unit{1} << unit_bits;
using Wide = boost::multiprecision::int128_t;

inline Unit units(double texels) { return static_cast<Unit>(texels * 0x1p36); }

struct Point {
  Unit x, y;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }

/// Sides are ends included; half open: without the right and the lower one.
struct Box {
  Unit left, right, top, bottom;
  bool half_open = false;

  Box grown(Unit by) const { return {left - by, right + by, top - by, bottom + by}; }
};
/// Points on its border are the cell's to the right and below.
inline Box cell_box(int i, int j) { return {i * texel, (i + 1) * texel, j * texel, (j + 1) * texel, true}; }
inline Box square_about(Point p, Unit by) { return Box{p.x, p.x, p.y, p.y}.grown(by); }

/// Whether the box is beyond the line through a, on the side that n points to.
inline bool beyond(Point n, Point a, const Box& box) {
  const Wide x = (n.x > 0 ? box.left : box.right) - a.x, y = (n.y > 0 ? box.top : box.bottom) - a.y,
             least = x * n.x + y * n.y;
  // The nearest corner may be one that the box has not.
  return box.half_open && (n.x < 0 || n.y < 0) ? least >= 0 : least > 0;
}
inline bool overlap(Unit least, Unit most, Unit from, Unit to, bool half_open) {
  return most >= from && (half_open ? least < to : least <= to);
}
/// Whether a closed segment and a box have a common point: no line separates them.
inline bool meets(const std::array<Point, 2>& e, const Box& box) {
  const Point d = e[1] - e[0];
  return overlap(std::min(e[0].x, e[1].x), std::max(e[0].x, e[1].x), box.left, box.right, box.half_open) &&
         overlap(std::min(e[0].y, e[1].y), std::max(e[0].y, e[1].y), box.top, box.bottom, box.half_open) &&
         !beyond({d.y, -d.x}, e[0], box) && !beyond({-d.y, d.x}, e[0], box);
}

/// A closed triangle.
struct ExactTriangle {
  std::array<Point, 3> corner;
  std::array<Point, 3> outward;  ///< of edges k, k + 1
  Box box;

  explicit ExactTriangle(const std::array<Point, 3>& p) : corner(p) {
    const Point b = p[1] - p[0], c = p[2] - p[0];
    const bool is_left = Wide(b.x) * c.y > Wide(b.y) * c.x;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point d = p[(k + 1) % 3] - p[k];
      outward[k] = is_left ? Point{d.y, -d.x} : Point{-d.y, d.x};
    }
    box = {std::min({p[0].x, p[1].x, p[2].x}), std::max({p[0].x, p[1].x, p[2].x}),
           std::min({p[0].y, p[1].y, p[2].y}), std::max({p[0].y, p[1].y, p[2].y})};
  }
  bool meets(const Box& b) const {
    if (!overlap(box.left, box.right, b.left, b.right, b.half_open) ||
        !overlap(box.top, box.bottom, b.top, b.bottom, b.half_open))
      return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (beyond(outward[k], corner[k], b)) return false;
    return true;
  }
  bool holds(const Box& b) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point n = outward[k];
      const Wide x = (n.x > 0 ? b.right : b.left) - corner[k].x,
                 y = (n.y > 0 ? b.bottom : b.top) - corner[k].y;
      if (x * n.x + y * n.y > 0) return false;
    }
    return true;
  }
};

/// Micro-vertex v, in fourths of the sides.
inline int fourths(float of) { return static_cast<int>(4 * of); }

struct Node {
  SixteenShape shape;
  SixteenInput in{};  ///< without texels and planes; its shape is to be set to this one
  double size, delta64;
  SixteenWindow window;
  std::array<Point, 3> corner;  ///< the true ones, from the window's texel (left, top)
  Point aimed;                  ///< what was aimed at, likewise

  /// Micro-vertex v, numbered as in SixteenLanes.
  Point vertex(std::size_t v) const {
    const Point b = corner[1] - corner[0], c = corner[2] - corner[0];
    const int i = fourths(sixteen_lanes.vertex_i[v]), j = fourths(sixteen_lanes.vertex_j[v]);
    return corner[0] + Point{(i * b.x + j * c.x) / 4, (i * b.y + j * c.y) / 4};
  }
  ExactTriangle micro(std::size_t k) const {
    const auto at = [&](std::size_t c) {
      return vertex(static_cast<std::size_t>(sixteen_lanes.corner[c][k]));
    };
    return ExactTriangle({at(0), at(1), at(2)});
  }
  /// Edge e of SixteenLanes, from its first corner on.
  std::array<Point, 2> edge(std::size_t e) const {
    const int first = sixteen_lanes.edges[e] >> 16 & 15, direction = sixteen_lanes.edges[e] >> 24;
    const Point b = corner[1] - corner[0], c = corner[2] - corner[0],
                d = direction == 0   ? b
                    : direction == 1 ? c
                                     : c - b;
    const Point p = vertex(static_cast<std::size_t>(first));
    return {p, p + Point{d.x / 4, d.y / 4}};
  }
  double delta() const { return sixteen_delta(size, delta64); }
};
constexpr std::size_t edges_of_node = 30;

/// More than corners are ever off in binary64, so that what this alone does to a bound is seen; it is no test of lines,
/// which are usable up to 2^-16.
constexpr double coarse = 0x1.ep-17;

/// Draws nodes: oblique ones, slivers, edges that are all but upright, all but flat, or flat, edges along the axes; most
/// with a micro-vertex, or a point of a micro-edge, next to a whole number along one axis or both.
class Nodes {
 public:
  /// off: what corners of some are off, if not 0 (coarse).
  explicit Nodes(std::uint32_t seed, double off = 0) : random(seed), coarse_(off) {}

  /// extent: of a node in texels, about, at most 89.  scale: R.
  Node draw(double extent, double scale) {
    exact_ = false;
    return drawn(extent, scale);
  }
  /// One whose places are off by nothing, delta = 0: what is left of a bound is for roundings of stored numbers.
  /// Domain: extent >= 1/4.
  Node draw_exact(double extent, double scale) {
    exact_ = true;
    return drawn(extent, scale);
  }
  /// From `least` to `most`, each power of 2 as often.
  double extent(double least, double most) { return least * std::exp2(unit() * std::log2(most / least)); }
  /// A float in [0, 1).
  double unit() { return static_cast<double>(random() >> 8) * 0x1p-24; }
  double sign() { return random() % 2 == 0 ? -1 : 1; }
  /// 0, or from a rounding of binary64 to some delta.
  Unit tiny() {
    const auto bits = random() % 4 == 0 ? random() % 31 : random() % 24;
    return random() % 8 == 0 ? 0 : (random() % 2 == 0 ? -1 : 1) * static_cast<Unit>(random() % (2u << bits));
  }

  std::mt19937 random;

 private:
  double coarse_;
  bool exact_ = false;

  Node drawn(double extent, double scale) {
    while (true) {
      const auto [b, c] = sides(extent);
      const double across = spread(b.x, c.x), down = spread(b.y, c.y);
      if (across > 89 || down > 89) continue;
      const double delta64 = exact_ || random() % 2 == 0 ? 0 : coarse_ != 0 ? coarse_ : 0x1p-31;
      const Lines lines = lines_of(b, c, delta64);
      if (!lines.usable) continue;
      // The four children of a node, in class Bilinear's order.
      const std::array<std::array<PlanePoint, 2>, 4> of_nodes{
          {{b, c}, {b, minus(b, c)}, {minus({}, b), minus(c, b)}, {minus({}, b), minus({}, c)}}};
      const std::size_t k = random() % 4;
      return placed(of_nodes[k], lines, k % 2 == 1, sixteen_size(std::max(across, down)), delta64, scale);
    }
  }
  static PlanePoint minus(PlanePoint a, PlanePoint b) { return {a.x - b.x, a.y - b.y}; }
  static double spread(double b, double c) { return std::max({b, c, 0.0}) - std::min({b, c, 0.0}); }
  double on_grid(double x) const {
    return exact_ ? std::round(x * 0x1p14) * 0x1p-14 : std::round(x * 0x1p26) * 0x1p-26;
  }

  std::array<PlanePoint, 2> sides(double e) {
    PlanePoint b{e * sign() * (0.3 + 0.7 * unit()), e * (2 * unit() - 1)},
        c{e * (2 * unit() - 1), e * (2 * unit() - 1)};
    const auto kind = random() % 12;
    if (kind == 4) b = {b.x, std::ldexp(b.y, -static_cast<int>(random() % 12))};
    if (kind == 9) b = {std::ldexp(b.x, -static_cast<int>(random() % 20)), b.y};
    if (kind == 3 || kind == 4 || kind == 9) {  // a sliver; one that all but lies, or stands
      const double part = 0.3 + 0.7 * unit(),
                   thin = sign() * std::ldexp(0.5 + unit(), -static_cast<int>(random() % 16));
      c = {part * b.x - thin * b.y, part * b.y + thin * b.x};
    } else if (kind == 5) {
      b = {sign() * e * 0x1p-20, sign() * e};
    } else if (kind == 6) {
      b = {sign() * e, sign() * e * 0x1p-10};
    } else if (kind == 7) {
      b = {sign() * e, random() % 2 == 0 ? 0 : e * (2 * unit() - 1) * 0x1p-9};
    } else if (kind == 8) {
      b = {sign() * e, 0};
      c = {0, sign() * e};
    }
    for (PlanePoint* const p : {&b, &c}) *p = {on_grid(p->x), on_grid(p->y)};
    switch (random() % 3) {
      case 0: return {b, c};
      case 1: return {c, b};
      default: return {minus(c, b), minus({}, b)};
    }
  }
  /// The lines of a base triangle that is this node, scaled by a power of two.
  Lines lines_of(PlanePoint b, PlanePoint c, double delta64) {
    const auto more = random() % 4;
    for (std::uint32_t height = 0; height <= 11; ++height) {
      const double part = std::exp2(height);
      const Lines lines({PlanePoint{0, 0}, {b.x * part, b.y * part}, {c.x * part, c.y * part}}, delta64);
      if (!lines.usable) continue;
      const double larger = std::exp2(std::min<std::uint32_t>(11, height + static_cast<std::uint32_t>(more)));
      return Lines({PlanePoint{0, 0}, {b.x * larger, b.y * larger}, {c.x * larger, c.y * larger}}, delta64);
    }
    return {};
  }
  Node placed(const std::array<PlanePoint, 2>& to, const Lines& lines, bool turned, double size,
              double delta64, double scale) {
    // The point that is aimed at, from the first corner.
    const std::size_t v = random() % 15, direction = random() % 3;
    const double t = random() % 3 == 0 ? 0 : static_cast<double>(random() % 65) / 64;
    const double i = double{sixteen_lanes.vertex_i[v]} - (direction == 1   ? 0
                                                          : direction == 0 ? -t / 4
                                                                           : t / 4),
                 j = double{sixteen_lanes.vertex_j[v]} + (direction == 0 ? 0 : t / 4);
    const PlanePoint aim{i * to[0].x + j * to[1].x, i * to[0].y + j * to[1].y};
    // Next to a whole number by this much; often beyond a corner, or beside it, on the line of an edge.
    const PlanePoint d = direction == 0 ? to[0] : direction == 1 ? to[1] : minus(to[1], to[0]);
    const Unit off_y = tiny(),
               along = std::fabs(d.x) < 0x1p11 * std::fabs(d.y)
                           ? static_cast<Unit>(static_cast<double>(off_y) * d.x / d.y)
                           : 0,
               off_x = random() % 2 == 0 ? tiny() : along;
    const auto axis = [&](double of_aim, bool aims, Unit off) {
      const double p = 100 + std::ldexp(static_cast<double>(random()), -26);
      if (exact_) return std::round(p * 0x1p16) * 0x1p-16;
      return aims ? std::round(p + of_aim) - of_aim + static_cast<double>(off) * 0x1p-36 : p;
    };
    const auto aims = random() % 8;  // along x, along y, along both as often as not
    const PlanePoint p0{axis(aim.x, aims != 0 && aims != 1, off_x),
                        axis(aim.y, aims != 0 && aims != 2, off_y)};
    const Triangle p{p0, {p0.x + to[0].x, p0.y + to[0].y}, {p0.x + to[1].x, p0.y + to[1].y}};
    const double margin = sixteen_margin(size, delta64);
    // Lines of exact nodes keep their margin.
    Node node{.shape = SixteenShape(to[0], to[1], lines, turned, margin),
              .size = exact_ ? 0 : size,
              .delta64 = delta64,
              .window = SixteenWindow(boxes(delta64).box(p)),
              .corner = {},
              .aimed = {}};
    const SixteenWindow& window = node.window;
    node.shape.take_edges(to[0], to[1], node.delta(), margin);
    take_bounds(node.shape, scale, HUGE_VAL, node.delta());
    node.in.columns = static_cast<std::int32_t>(window.width);
    node.in.rows = static_cast<std::int32_t>(window.height);
    node.in.p0 = window.local(p0);
    node.in.bit = static_cast<std::uint32_t>(random() % 32);
    // All corners are off by as much as they can be, often to the same side.
    const auto off = [&] { return random() % 2 == 0 ? -units(delta64) : units(delta64); };
    const bool together = random() % 2 == 0;
    const Point of_all{off(), off()};
    for (std::size_t k = 0; k < 3; ++k)
      node.corner[k] = Point{units(p[k].x - static_cast<double>(window.left)),
                             units(p[k].y - static_cast<double>(window.top))} +
                       (together ? of_all : Point{off(), off()});
    node.aimed = {units(p0.x + aim.x - static_cast<double>(window.left)),
                  units(p0.y + aim.y - static_cast<double>(window.top))};
    return node;
  }
  /// Only boxes are asked of it.
  static BilinearFilter<std::uint8_t> boxes(double delta64) {
    static const std::uint8_t one = 0;
    static const TexturePropertiesOf<std::uint8_t> sides(
        {&one, 1, 1, 1}, limits_of(Cutoff{1, 2}, {1, 1}, 255), Wrap::repeat, Wrap::repeat, 0);
    return {sides, delta64, {}};
  }
};

/// A plane's bits in a window.
class WindowBits {
 public:
  static constexpr std::size_t strip = 128;

  /// The bit of texel (x, y) turned over; of those before the window nothing.
  void flip(const SixteenInput& in, int x, int y) {
    if (x < 0 || y < 0) return;
    const std::uint32_t at = in.bit + static_cast<std::uint32_t>(x);
    words_[strip * (at / 32) + static_cast<std::size_t>(y)] ^= 1u << (at % 32);
  }
  void fill(std::uint32_t word) { words_.fill(word); }
  const std::uint32_t* words() const { return words_.data(); }

 private:
  std::array<std::uint32_t, 6 * strip> words_{};
};

/// Planes in which one cell alone is mixed: its first texel is the only one that is visible, and the three other cells of
/// that texel are opaque.
class OneCell {
 public:
  explicit OneCell(SixteenInput& in) : in_(in) {
    in.strip = WindowBits::strip;
    in.opaque = opaque_.words();
    in.visible = visible_.words();
  }
  /// Mixed, and at the second call no longer.
  void turn(int i, int j) {
    visible_.flip(in_, i, j);
    for (int y = j - 1; y <= j + 1; ++y)
      for (int x = i - 1; x <= i + 1; ++x)
        if (x != i + 1 || y != j + 1) opaque_.flip(in_, x, y);
  }

 private:
  SixteenInput& in_;
  WindowBits opaque_, visible_;
};

inline std::array<ExactTriangle, 16> micros(const Node& node) {
  const auto all = [&]<std::size_t... k>(std::index_sequence<k...>) {
    return std::array<ExactTriangle, 16>{node.micro(k)...};
  };
  return all(std::make_index_sequence<16>());
}
/// Bit k: micro-triangle k meets the box.
inline std::uint32_t meeting(const std::array<ExactTriangle, 16>& micro, const Box& box) {
  std::uint32_t met = 0;
  for (std::size_t k = 0; k < 16; ++k) met |= std::uint32_t{micro[k].meets(box)} << k;
  return met;
}

/// A third of a unit is exact, too.
constexpr double thirds = 3 * 0x1p36;
/// A centroid, in thirds of units.
inline Point three_times(const ExactTriangle& t) { return t.corner[0] + t.corner[1] + t.corner[2]; }

/// Texels of a window, and four bytes from the last can be read.
template <class Texel>
struct Texels {
  static constexpr std::int32_t pitch = sixteen_window;
  std::array<Texel, pitch*(sixteen_window + 1)> of{};

  Texel& at(std::int64_t i, std::int64_t j) { return of[static_cast<std::size_t>(j * pitch + i)]; }
};
/// All of them 0 or the greatest, or anything.
template <class Texel>
void fill(Texels<Texel>& texels, std::mt19937& random) {
  const bool extreme = random() % 2 == 0;
  for (Texel& t : texels.of) t = static_cast<Texel>(extreme ? (random() % 2 == 0 ? 0u : ~0u) : random());
}
/// Alpha at a place in thirds of units, in squares of such.
template <class Texel>
Wide sampled_exactly(Texels<Texel>& texels, Point p) {
  const Wide one = Wide(3) << unit_bits;
  const std::int64_t i = p.x / (3 * texel), j = p.y / (3 * texel);
  const Wide x = p.x - i * 3 * texel, y = p.y - j * 3 * texel;
  return (one - y) * ((one - x) * texels.at(i, j) + x * texels.at(i + 1, j)) +
         y * ((one - x) * texels.at(i, j + 1) + x * texels.at(i + 1, j + 1));
}

}  // namespace mmverify::tests
