#include "impl/attribute/decimation.hpp"

namespace mmverify::impl::attribute {
namespace {

/// A point's grid square and its place there, exactly: x = iu + fu, y = iv + fv in squares of the level.
struct GridPlace {
  std::uint32_t iu, iv;
  double fu, fv;
  bool upper;
};

GridPlace locate(float u, float v, std::uint32_t N) noexcept {
  const float side = static_cast<float>(N);
  // The product is exact: N is a power of two.
  const float un = index::detail::clamped(u) * side, vn = index::detail::clamped(v) * side;
  std::uint32_t iu = std::min(static_cast<std::uint32_t>(un), N - 1);
  const std::uint32_t iv = std::min(static_cast<std::uint32_t>(vn), N - 1);
  iu = std::min(iu, N - 1 - iv);
  // Exact in binary64: 24 bits and up to 16 more of the square.
  const double fu = static_cast<double>(un) - iu, fv = static_cast<double>(vn) - iv;
  // lesser >= 1 - greater stands for fu + fv >= 1, as in index::detail::reach_one.
  const bool upper = iu + iv + 1 < N && std::min(fu, fv) >= 1 - std::max(fu, fv);
  return {iu, iv, fu, fv, upper};
}

/// a + b + c to within an ulp or two, with the sign of the exact sum.
/// Domain: c whole and below 2^52, the sum of a and b too.  a + b is s + e exactly (Knuth's two-sum) with |e| <=
/// ulp(s)/2.  c is a multiple of ulp(s), so that s + c is 0, and e decides, or at least ulp(s).
double signed_sum(double a, double b, double c) noexcept {
  const double s = a + b, of_b = s - a, e = (a - (s - of_b)) + (b - of_b);
  const double sum = s + c;
  return sum != 0 ? sum : e;
}

double along(std::uint32_t to, std::uint32_t from) noexcept {
  return static_cast<double>(to) - static_cast<double>(from);
}

struct Shares {
  double share[3], area;
  double least() const { return std::min({share[0], share[1], share[2]}); }
};

/// Twice the areas that the point makes with the sides of a triangle.  A side has 2 steps at most, or is the whole of
/// level 1.
Shares shares_of(const std::array<Vertex, 3>& c, const GridPlace& p) noexcept {
  const auto share = [&](Vertex a, Vertex b) {
    const double di = along(b.i, a.i), dj = along(b.j, a.j);
    return signed_sum(di * p.fv, -dj * p.fu, di * along(p.iv, a.j) - dj * along(p.iu, a.i));
  };
  const double area =
      along(c[1].i, c[0].i) * along(c[2].j, c[0].j) - along(c[2].i, c[0].i) * along(c[1].j, c[0].j);
  return {{share(c[1], c[2]), share(c[2], c[0]), share(c[0], c[1])}, area};
}

std::array<Vertex, 3> moved(std::array<Vertex, 3> c, Level n, EdgeFlags flags) noexcept {
  for (Vertex& x : c) x = snapped(x, n, flags);
  return c;
}

}  // namespace

VertexWeights decimated_lookup(float u, float v, Level level, EdgeFlags flags) noexcept {
  const Level n = std::min(level, max_level);
  const std::uint32_t N = std::uint32_t{1} << n;
  const GridPlace p = locate(u, v, N);
  const std::array<Vertex, 3> before = corners_of(MicroTriangle{p.iu, p.iv, p.upper});

  std::array<Vertex, 3> found = moved(before, n, flags);
  Shares best = shares_of(found, p);
  const auto fits = [](const Shares& s) { return s.area > 0 && s.least() >= 0; };
  if (!fits(best) && found != before) {
    // The point's micro-triangle shrank to a line or moved away.  One around a corner that moved holds it now.
    const auto consider = [&](std::uint32_t i, std::uint32_t j, bool upper) {
      if (i + j + (upper ? 1 : 0) >= N) return false;
      const std::array<Vertex, 3> c = moved(corners_of(MicroTriangle{i, j, upper}), n, flags);
      const Shares s = shares_of(c, p);
      if (s.area <= 0) return false;
      // No micro-triangle holds a point outside the triangle; the nearest one is taken.
      if (best.area <= 0 || s.least() > best.least()) found = c, best = s;
      return fits(s);
    };
    const auto around = [&](Vertex x) {
      const std::uint32_t i = x.i, j = x.j;
      return consider(i, j, false) || (i > 0 && (consider(i - 1, j, false) || consider(i - 1, j, true))) ||
             (j > 0 && (consider(i, j - 1, false) || consider(i, j - 1, true))) ||
             (i > 0 && j > 0 && consider(i - 1, j - 1, true));
    };
    for (const Vertex& x : before)
      if (snapped(x, n, flags) != x && around(x)) break;
  }
  VertexWeights result{found, {}};
  for (std::size_t c = 0; c < 3; ++c)
    result.weights[c] = static_cast<float>(best.share[c] / best.area);  // areas are 1, 2 and 4
  return result;
}

}  // namespace mmverify::impl::attribute
