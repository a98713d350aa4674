// Points and the index of each.
//
// Small levels are whole: one point for each vertex, edge and interior of the grid, which decide every other
// point (docs/SOUNDNESS.md). Up to level 16 follow points that break index functions: binary32 numbers next
// to grid lines, parts that add up to 1 only by rounding, numbers on the hypotenuse and one step beyond, the
// smallest numbers.
#include "spec/index/index.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "delivery/vectors/families/index_mistakes.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::vectors::index {
namespace {

using spec::Level;
using RationalPoint = spec::Point<Rational>;

constexpr Level highest = 16, last_whole = 4;

/// The part of the grid that a point lies on.
enum class On : std::uint32_t { interior, edge, vertex, outside };

/// The distance of x from the nearest integer.
Rational from_whole(const Rational& x) {
  const Rational part = x - Rational(spec::whole(x));
  return std::min(part, Rational(1) - part);
}

/// The indices of the micro-triangles that a point touches, edges and corners included, ascending.
/// Domain: a point of the triangle.
std::vector<std::uint32_t> touched(const RationalPoint& p, Level n) {
  const auto N = static_cast<std::int64_t>(spec::side(n));
  const Rational x = p.u * Rational(N), y = p.v * Rational(N);
  const auto i = static_cast<std::int64_t>(spec::whole(x)), j = static_cast<std::int64_t>(spec::whole(y));
  std::vector<std::uint32_t> found;
  for (std::int64_t iu = std::max<std::int64_t>(i - 1, 0); iu <= i; ++iu)
    for (std::int64_t iv = std::max<std::int64_t>(j - 1, 0); iv <= j; ++iv) {
      const Rational a = x - Rational(iu), b = y - Rational(iv);
      if (a > 1 || b > 1) continue;
      for (const bool upper : {false, true})
        if (iu + iv + (upper ? 1 : 0) < N && (upper ? a + b >= 1 : a + b <= 1))
          found.push_back(static_cast<std::uint32_t>(spec::attribute::curve_index(
              {static_cast<std::uint32_t>(iu), static_cast<std::uint32_t>(iv), upper}, n)));
    }
  std::sort(found.begin(), found.end());
  return found;
}

class Points {
 public:
  explicit Points(Builder& out) : out_(out) {}

  void add(const char* about, Level n, std::uint32_t u, std::uint32_t v) {
    if (!seen_.emplace(n, u, v).second) return;
    const RationalPoint p{exactly(u), exactly(v)};
    const bool inside = p.u >= 0 && p.v >= 0 && p.u + p.v <= 1;
    On on = On::outside;
    Rational gap = 0;
    if (inside) {
      const Rational N(spec::side(n));
      const Rational a = from_whole(p.u * N), b = from_whole(p.v * N), c = from_whole((p.u + p.v) * N);
      gap = std::min({a, b, c});
      on = gap != 0 ? On::interior : a == 0 && b == 0 ? On::vertex : On::edge;
    }
    const spec::Point<float> rounded{std::bit_cast<float>(u), std::bit_cast<float>(v)};
    const std::uint32_t exact = spec::index::reference(p, n);
    out_.add({about, n, u, v, static_cast<std::uint32_t>(on), rounded_down(gap), exact,
              spec::index::reference(rounded, n),
              inside ? Optional(spec::index::as_the_prose_says(p, n)) : none,
              inside ? Optional(spec::index::w_minor(p, n)) : none,
              inside ? touched(p, n) : std::vector<std::uint32_t>(), found_by({n, u, v, p}, exact)});
  }

  /// The point and its eight neighbours among pairs of binary32 numbers, up to one step beyond the
  /// hypotenuse.
  void add_around(const char* at, const char* beside, Level n, std::uint32_t u, std::uint32_t v) {
    add(at, n, u, v);
    const Rational most = Rational(1) + spec::scaled(1, -23);
    for (const int du : {-1, 0, 1})
      for (const int dv : {-1, 0, 1}) {
        const std::uint32_t nu = stepped(u, du), nv = stepped(v, dv);
        if (exactly(nu) + exactly(nv) <= most) add(beside, n, nu, nv);
      }
  }

 private:
  Builder& out_;
  std::set<std::tuple<Level, std::uint32_t, std::uint32_t>> seen_;
};

/// One point for each cell of the grid: vertices, edges and interiors, in multiples of 1/4N.
void add_whole_level(Points& points, Level n) {
  const std::uint32_t N = spec::side(n);
  const auto at = [&](const char* about, std::uint32_t a, std::uint32_t b) {
    points.add(about, n, dyadic(a, n + 2), dyadic(b, n + 2));
  };
  for (std::uint32_t j = 0; j <= N; ++j)
    for (std::uint32_t i = 0; i + j <= N; ++i) {
      at("cell of a whole level: vertex", 4 * i, 4 * j);
      if (i + j == N) continue;
      at("cell of a whole level: edge along u", 4 * i + 2, 4 * j);
      at("cell of a whole level: edge along v", 4 * i, 4 * j + 2);
      at("cell of a whole level: edge between u and v", 4 * i + 2, 4 * j + 2);
      at("cell of a whole level: lower interior", 4 * i + 1, 4 * j + 1);
      if (i + j + 1 < N) at("cell of a whole level: upper interior", 4 * i + 3, 4 * j + 3);
    }
}

void add_vertices(Points& points, Level n) {
  const std::uint32_t N = spec::side(n), pattern = 0x5555u & (N - 1);
  const std::pair<std::uint32_t, std::uint32_t> vertices[] = {{0, 0},
                                                              {N, 0},
                                                              {0, N},
                                                              {N / 2, 0},
                                                              {0, N / 2},
                                                              {N / 2, N / 2},
                                                              {N / 4, N / 4},
                                                              {N - 1, 0},
                                                              {1, 1},
                                                              {0, N - 1},
                                                              {1, N - 1},
                                                              {N - 1, 1},
                                                              {pattern, 0},
                                                              {0, pattern},
                                                              {pattern / 2, pattern / 2},
                                                              {pattern, N - pattern}};
  for (const auto& [i, j] : vertices)
    if (i + j <= N)
      points.add_around("vertex: a tie of up to six", "one float from a vertex", n, dyadic(i, n),
                        dyadic(j, n));
}

void add_edges(Points& points, Level n) {
  const std::uint32_t N = spec::side(n);
  for (const std::uint32_t i : {0u, 1u, N / 2 - 1, N - 2})
    for (const std::uint32_t j : {0u, N / 4}) {
      if (i + j + 1 >= N) continue;
      points.add_around("edge along v: a tie", "one float from an edge along v", n, dyadic(i, n),
                        dyadic(4 * j + 1, n + 2));
      points.add_around("edge along u: a tie", "one float from an edge along u", n, dyadic(4 * j + 1, n + 2),
                        dyadic(i, n));
      points.add_around("edge between u and v: a tie", "one float from an edge between u and v", n,
                        dyadic(4 * i + 1, n + 2), dyadic(4 * j + 3, n + 2));
    }
}

/// Parts whose sum is at least 1 - 2^-25 and less than 1: the binary32 sum is 1. The square's upper half does
/// not have them.
/// Source: law index.published_differs_where, docs/INDEX.md.
void add_rounded_sums(Points& points, Level n) {
  const auto scaled = [n](float x) { return bits_of(std::ldexp(x, -static_cast<int>(n))); };
  const float below_one = std::nextafter(1.0f, 0.0f), half_step = std::ldexp(1.0f, -25);
  const auto both_ways = [&](const char* about, std::uint32_t a, std::uint32_t b) {
    points.add(about, n, a, b);
    points.add(about, n, b, a);
  };
  for (const float small : {half_step, half_step * 1.5f, std::nextafter(2 * half_step, 0.0f)})
    both_ways("below a diagonal, and the float sum rounds up to it", scaled(small), scaled(below_one));
  both_ways("below a diagonal; the float sum rounds down", scaled(half_step * 0.5f), scaled(below_one));
  both_ways("on a diagonal, parts of very different size", scaled(2 * half_step), scaled(below_one));
  both_ways("beyond a diagonal by a hair", scaled(3 * half_step), scaled(below_one));
  both_ways("below a diagonal, and the float sum rounds up to it",
            scaled(std::ldexp(1.0f, -13) - std::ldexp(1.0f, -25)), scaled(1 - std::ldexp(1.0f, -13)));
}

void add_smallest(Points& points, Level n) {
  constexpr std::uint32_t least = 1, least_normal = 0x00800000, minus_zero = 0x80000000;
  const std::uint32_t one = bits_of(1), half = bits_of(0.5f), below_one = one - 1;
  for (const std::uint32_t small : {least, least_normal - 1, least_normal, minus_zero}) {
    for (const std::uint32_t other : {std::uint32_t{0}, half, below_one, one}) {
      points.add("smallest numbers, and minus zero", n, small, other);
      points.add("smallest numbers, and minus zero", n, other, small);
    }
    points.add("smallest numbers, and minus zero", n, small, small);
  }
}

void add_outside(Points& points, Level n) {
  const std::uint32_t one = bits_of(1), two = bits_of(2), minus = bits_of(-0.25f), third = bits_of(0.375f);
  for (const auto& [u, v] : {std::pair{one, one},
                             {two, third},
                             {third, two},
                             {minus, third},
                             {third, minus},
                             {minus, minus},
                             {one, third},
                             {third, one}})
    points.add("outside: each coordinate is clamped by itself", n, u, v);
}

void add_anywhere(Points& points, Level n) {
  Mixed mixed(n);
  for (unsigned k = 0; k < 12; ++k) {
    std::uint32_t u = mixed.bits(24), v = mixed.bits(24);
    if (u + v > 0xffffffu) u = 0xffffffu - u, v = 0xffffffu - v;
    points.add("anywhere", n, dyadic(u, 24), dyadic(v, 24));
  }
}

}  // namespace

Family family() {
  Builder out("index", 2,
              "the micro-triangle that holds a point: u of the second vertex, v of the third; binary32");
  out.table(
      "points", "Points, and the index of each by each dialect.",
      {{"about", Kind::about, "why the vector is there"},
       {"level", Kind::number, "n; 4^n micro-triangles"},
       {"u", Kind::binary32, "barycentric of the second vertex"},
       {"v", Kind::binary32, "barycentric of the third vertex"},
       {"on", Kind::name, "on what of the grid the point lies", {"interior", "edge", "vertex", "outside"}},
       {"gap", Kind::binary32, "distance to the next grid line in micro-triangle edges, rounded down"},
       {"exact", Kind::number, "Vulkan's reference code in exact arithmetic on these very numbers"},
       {"published", Kind::number, "the same code in binary32, each operation rounded to nearest"},
       {"prose", Kind::optional,
        "Vulkan's chapter on traversal to the letter, exact; may exceed 4^n; none outside"},
       {"rows", Kind::optional, "row order, exact; none outside"},
       {"touched", Kind::words, "all micro-triangles that the point touches; none outside"},
       {"finds", Kind::set, "the mistakes whose function is wrong here", names_of_mistakes()}});
  Points points(out);
  for (Level n = 0; n <= last_whole; ++n) add_whole_level(points, n);
  for (Level n = 1; n <= highest; ++n) {
    if (n == 1 || n == 5 || n == 8 || n == 12 || n >= 15) add_vertices(points, n);
    if (n == 2 || n == 3 || n == 5 || n == 8 || n == 12 || n == 16) add_edges(points, n);
    add_rounded_sums(points, n);
    add_anywhere(points, n);
  }
  for (const Level n : {0u, 1u, 2u, 5u, 12u, 16u}) {
    add_smallest(points, n);
    add_outside(points, n);
  }
  return out.take();
}

}  // namespace mmverify::vectors::index
