#include "delivery/vectors/families/index_mistakes.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace mmverify::vectors::index {
namespace {

using spec::Level;
using spec::Point;
using spec::index::Quantised;

/// A point's coordinates in micro-triangle edges: whole parts and the rest.
struct OnGrid {
  std::uint32_t iu, iv, N;
  Rational uf, vf;
};

OnGrid on_grid(const Asked& a) {
  const std::uint32_t N = spec::side(a.n);
  const Rational u = spec::times(N, spec::index::within_unit(a.p.u)),
                 v = spec::times(N, spec::index::within_unit(a.p.v));
  const std::uint32_t iu = spec::whole(u), iv = spec::whole(v);
  return {iu, iv, N, u - Rational(iu), v - Rational(iv)};
}

std::uint32_t on_curve(std::uint32_t iu, std::uint32_t iv, bool upper_half, std::uint32_t N) {
  return spec::index::curve(spec::index::grid_square<std::uint32_t>(iu, iv, upper_half, N), N - 1);
}

Quantised<std::uint32_t> quantised(const Asked& a) { return spec::index::quantise<std::uint32_t>(a.p, a.n); }

/// Level 0 handled as level 1.
std::uint32_t level_zero(const Asked& a) { return spec::index::reference(a.p, a.n == 0 ? 1 : a.n); }

/// A point on the edge between u and v belongs to the lower half of its square.
std::uint32_t tie_on_diagonal(const Asked& a) {
  const OnGrid g = on_grid(a);
  return on_curve(g.iu, g.iv, g.uf + g.vf > 1, g.N);
}

/// A point on a line u = i/N or v = i/N belongs to the smaller side.
std::uint32_t tie_on_line(const Asked& a) {
  OnGrid g = on_grid(a);
  if (g.uf == 0 && g.iu > 0) --g.iu, g.uf = 1;
  if (g.vf == 0 && g.iv > 0) --g.iv, g.vf = 1;
  return on_curve(g.iu, g.iv, !(g.uf + g.vf < 1), g.N);
}

/// The squares of the hypotenuse are handled as those inside: they get an upper half, and iu is not lowered.
std::uint32_t hypotenuse(const Asked& a) {
  const OnGrid g = on_grid(a);
  const std::uint32_t iu = std::min(g.iu, g.N - 1), iv = std::min(g.iv, g.N - 1),
                      iw = ~(iu + iv) - (g.uf + g.vf < 1 ? 0u : 1u);
  return spec::index::curve(Quantised<std::uint32_t>{iu, iv, iw}, g.N - 1);
}

/// The fractional parts are added in binary32, and the sum rounds up to 1.
std::uint32_t rounded_sum(const Asked& a) {
  return spec::index::reference(Point<float>{std::bit_cast<float>(a.u), std::bit_cast<float>(a.v)}, a.n);
}

/// Significands of 11 bits, as those of binary16 and of mediump.
std::uint32_t half_precision(const Asked& a) {
  const auto rounded = [](std::uint32_t bits) {
    return exactly((bits + 0x0fffu + (bits >> 13 & 1u)) & ~0x1fffu);
  };
  return spec::index::reference(Point<Rational>{rounded(a.u), rounded(a.v)}, a.n);
}

/// Negative coordinates become words without a clamp to 0.
std::uint32_t not_clamped(const Asked& a) {
  OnGrid g = on_grid(a);
  if (a.p.u < 0) g.iu = ~0u;
  if (a.p.v < 0) g.iv = ~0u;
  return on_curve(g.iu, g.iv, !(g.uf + g.vf < 1), g.N);
}

std::uint32_t u_v_exchanged(const Asked& a) {
  return spec::index::reference(Point<Rational>{a.p.v, a.p.u}, a.n);
}

/// The weights of the first and second vertex are taken for those of the second and third.
std::uint32_t first_vertex_as_u(const Asked& a) {
  return spec::index::reference(Point<Rational>{Rational(1) - a.p.u - a.p.v, a.p.u}, a.n);
}

/// The orientation of the triangles further up is left out: the prefix XOR is missing.
std::uint32_t flip_missing(const Asked& a) {
  const std::uint32_t low = spec::side(a.n) - 1;
  return spec::index::interleave(
      spec::index::curve_bits(quantised(a), low, [](const std::uint32_t&) { return 0u; }));
}

/// The prefix XOR has the bit itself and the next one above, and no further ones.
std::uint32_t flip_cut_short(const Asked& a) {
  const std::uint32_t low = spec::side(a.n) - 1;
  return spec::index::interleave(
      spec::index::curve_bits(quantised(a), low, [](const std::uint32_t& t) { return t ^ t >> 1; }));
}

/// The recursion without the turn of its middle triangle, run on the centroid of the point's micro-triangle.
std::uint32_t middle_not_turned(const Asked& a) {
  const spec::index::Corners corners = spec::index::corners(spec::index::reference(a.p, a.n), a.n);
  const Rational third = Rational(1) / (Rational(3) * Rational(spec::side(a.n)));
  Rational u(0), v(0);
  for (const auto& corner : corners) u += Rational(corner.i) * third, v += Rational(corner.j) * third;
  auto s = spec::index::first_step(Point<Rational>{u, v});
  for (Level depth = 0; depth < a.n; ++depth) {
    auto next = spec::index::next_step<spec::index::Reading::printed>(s);
    if (next.index % 4 == 1) {
      next.u = Rational(1) - spec::times(2, s.u);
      next.v = Rational(1) - spec::times(2, s.v);
      next.w = Rational(1) - spec::times(2, s.w);
    }
    s = next;
  }
  return s.index;
}

/// Row order in the place of the curve.
std::uint32_t row_order(const Asked& a) {
  const std::uint32_t index = spec::index::reference(a.p, a.n);
  const bool inside = a.p.u >= 0 && a.p.v >= 0 && a.p.u + a.p.v <= 1;
  return inside ? spec::index::w_minor(a.p, a.n) : index;
}

/// Indices of 16 bits, which levels above 8 need more of.
std::uint32_t cut_to_16_bits(const Asked& a) { return spec::index::reference(a.p, a.n) & 0xffffu; }

constexpr std::array all{
    Mistake{"level_zero", level_zero},
    Mistake{"tie_on_diagonal", tie_on_diagonal},
    Mistake{"tie_on_line", tie_on_line},
    Mistake{"hypotenuse", hypotenuse},
    Mistake{"rounded_sum", rounded_sum},
    Mistake{"half_precision", half_precision},
    Mistake{"not_clamped", not_clamped},
    Mistake{"u_v_exchanged", u_v_exchanged},
    Mistake{"first_vertex_as_u", first_vertex_as_u},
    Mistake{"flip_missing", flip_missing},
    Mistake{"flip_cut_short", flip_cut_short},
    Mistake{"middle_not_turned", middle_not_turned},
    Mistake{"row_order", row_order},
    Mistake{"cut_to_16_bits", cut_to_16_bits},
};

}  // namespace

std::span<const Mistake> mistakes() { return all; }

std::vector<std::string> names_of_mistakes() {
  std::vector<std::string> names;
  for (const Mistake& mistake : all) names.emplace_back(mistake.name);
  return names;
}

std::uint64_t found_by(const Asked& a, std::uint32_t exact) {
  std::uint64_t found = 0;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].index(a) != exact) found |= std::uint64_t{1} << k;
  return found;
}

}  // namespace mmverify::vectors::index
