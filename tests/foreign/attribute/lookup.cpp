// A point's micro-triangle, weights and value.
// Source: Color and Attribute Micromaps, 4.1 and figure 4; docs/ATTRIBUTE.md, "Lookup".
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "tests/foreign/attribute/places.hpp"

namespace mmverify::tests::foreign::attribute {
namespace {

using proofs::attribute::FixedWeights;
using proofs::attribute::FloatPoints;
using proofs::attribute::FloatWeights;
using proofs::attribute::GridPoint;
using proofs::attribute::Lookup;
using proofs::attribute::Points;
using proofs::attribute::Rational;
using proofs::attribute::RationalPoint;
using proofs::attribute::RationalWeights;
using proofs::attribute::Remap;
using proofs::attribute::Ties;

constexpr std::int64_t one = std::int64_t{1} << 30;

/// Parts of a coordinate times N: of grid points whole numbers of 2^-30, of floats doubles, exactly.
template <class Number>
struct Cut {
  std::uint32_t whole;
  Number part;
};
Cut<std::int64_t> cut(const proofs::attribute::Fixed64& x, Level n) {
  const std::int64_t scaled = x.raw() << n;
  return {static_cast<std::uint32_t>(scaled / one), scaled % one};
}
Cut<double> cut(float x, Level n) {
  const double scaled = std::ldexp(static_cast<double>(x), static_cast<int>(n)), down = std::floor(scaled);
  return {static_cast<std::uint32_t>(down), scaled - down};
}

bool reach_one(std::int64_t a, std::int64_t b) { return a + b >= one; }
/// Exactly: 1 - x is a double where x >= 1/2.
bool reach_one(double a, double b) { return std::max(a, b) >= 0.5 && std::min(a, b) >= 1 - std::max(a, b); }
bool exceed_one(std::int64_t a, std::int64_t b) { return a + b > one; }
bool exceed_one(double a, double b) { return std::max(a, b) >= 0.5 && std::min(a, b) > 1 - std::max(a, b); }

template <class Number>
MicroTriangle by_vulkan(const Cut<Number>& u, const Cut<Number>& v, Level n, Fault wrong) {
  const std::uint32_t last = side_of(n) - 1;
  std::uint32_t iu = std::min(u.whole, last), iv = std::min(v.whole, last);
  const std::uint32_t s = iu + iv;
  if (s > last) {
    if (wrong == hypotenuse_gives_way_in_v && iv > 0)
      iv = last - iu;
    else
      iu = last - iv;
    if (wrong == hypotenuse_limit_one_early_from_4 && n >= 4 && iu > 0 && iv > 0) --iu;
  }
  bool upper = reach_one(u.part, v.part);
  if (wrong == diagonal_stays_below) upper = exceed_one(u.part, v.part);
  if (wrong == diagonal_below_at_8 && n == 8 && iv % 16 == 5) upper = exceed_one(u.part, v.part);
  if constexpr (std::is_same_v<Number, double>) {
    const bool rounded = static_cast<float>(u.part) + static_cast<float>(v.part) >= 1.0f;
    if (wrong == float_sum_rounded || (wrong == float_sum_rounded_at_16 && n == 16)) upper = rounded;
    if (wrong == float_epsilon_sum) upper = upper || u.part + v.part >= 1 - 1e-6;
  }
  if (wrong == half_diagonal_below_from_4 && n >= 4 && iu + iv + 1 == side_of(n) / 2)
    upper = exceed_one(u.part, v.part);
  if (wrong == lines_of_u_below_from_5 && n >= 5 && iu > 0 && u.whole == iu && u.part == Number{} &&
      v.part > Number{})
    return {iu - 1, iv, true};
  return {iu, iv, upper && s < last};
}

template <class Number>
MicroTriangle by_figure_4(const Cut<Number>& u, const Cut<Number>& v, Level n, Fault wrong) {
  const std::uint32_t N = side_of(n), last = N - 1;
  const std::uint32_t row = std::min(last, u.whole + v.whole + (reach_one(u.part, v.part) ? 1 : 0));
  std::uint32_t column = std::min(row, v.whole);
  if (wrong == figure_4_column_from_below && v.part == Number{} && column > 0 && v.whole < N) --column;
  const std::uint32_t up = u.whole + (u.part > Number{} ? 1 : 0);
  std::uint32_t diagonal = std::min(last, N - std::min(N, up));
  if (wrong == figure_4_ties_of_vulkan) diagonal = last - std::min(last, u.whole);
  if (wrong == figure_4_ties_of_vulkan_in_the_middle && n >= 4 && u.whole == N / 2 && u.part == Number{})
    diagonal = last - std::min(last, u.whole);
  const std::uint32_t place = std::min(column + diagonal + row - last, 2 * row);
  const std::uint32_t upper = place % 2, iv = place / 2;
  return {row - upper - iv, iv, upper != 0};
}

template <class Number>
MicroTriangle holder(Ties ties, const Cut<Number>& u, const Cut<Number>& v, Level n, Fault wrong) {
  return ties == Ties::vulkan ? by_vulkan(u, v, n, wrong) : by_figure_4(u, v, n, wrong);
}

/// The weights in a lower or an upper micro-triangle, from the fractions within its square.
template <class Number>
std::array<Number, 3> pattern(const MicroTriangle& t, const Number& fu, const Number& fv, const Number& whole,
                              Fault wrong) {
  if (wrong == weights_lower_on_upper_in_last_row && t.upper && t.iu == 0 && t.iv > 2)
    return {fu + fv - whole, fu, fv};
  if (wrong == weights_upper_turned && t.upper) return {whole - fu, whole - fv, fu + fv - whole};
  if (wrong == weights_upper_exchanged_from_5 && t.upper && (t.iu > 15 || t.iv > 15))
    return {fu + fv - whole, whole - fv, whole - fu};
  if (t.upper) return {fu + fv - whole, whole - fu, whole - fv};
  if (wrong == weights_exchanged_in_first_column && t.iu == 0 && t.iv > 0) return {whole - fu - fv, fv, fu};
  return {whole - fu - fv, fu, fv};
}

FixedWeights weights(Level n, const GridPoint& p, Fault wrong) {
  const auto u = cut(p.u, n), v = cut(p.v, n);
  const MicroTriangle t = by_vulkan(u, v, n, wrong);
  // The fractions within the micro-triangle's own square, which may differ from the square of the floors.
  std::int64_t fu = u.part + (std::int64_t{u.whole} - t.iu) * one;
  std::int64_t fv = v.part + (std::int64_t{v.whole} - t.iv) * one;
  if (wrong == weights_of_the_floors) fu = u.part, fv = v.part;
  if (wrong == weights_of_the_floor_at_v_from_4 && n >= 4 && v.whole == side_of(n)) fv = v.part;
  std::array<std::int64_t, 3> w = pattern(t, fu, fv, one, wrong);
  if (wrong == weights_flush_quarters && n >= 6)
    for (std::int64_t& x : w)
      if (x == one / 4 && t.iu == t.iv) x = 0;
  if (wrong == weights_edge_vw_smoothed && t.iu == 0 && fu == 0 && !t.upper) {
    const std::int64_t x = w[2];
    w[2] = x * x / one * 3 - 2 * (x * x / one * x / one);
    w[0] = one - w[2];
  }
  if (wrong == weights_hypotenuse_leaks_at_7 && n == 7 && !t.upper && t.iu + t.iv + 1 == side_of(n) &&
      w[0] == 0 && w[1] > one / 2 && w[1] < one)
    w[0] = 1, w[1] -= 1;
  return {proofs::attribute::Fixed64::from_raw(w[0]), proofs::attribute::Fixed64::from_raw(w[1]),
          proofs::attribute::Fixed64::from_raw(w[2])};
}

Triplet triplet(VertexOrder order, Level n, const GridPoint& p, Fault wrong) {
  const auto u = cut(p.u, n), v = cut(p.v, n);
  if (wrong == triplet_of_figure_4_weights_of_vulkan)
    return triplet_of(order, n, by_figure_4(u, v, n, wrong), wrong);
  if (wrong == triplet_edge_by_bird_levels && order == VertexOrder::bird && n > 3 && v.whole == 0 &&
      v.part == 0) {
    // The next vertex of the edge as though the order went along it.
    Triplet x = triplet_of(order, n, by_vulkan(u, v, n, wrong), wrong);
    x[1] = x[0] + 1;
    return x;
  }
  return triplet_of(order, n, by_vulkan(u, v, n, wrong), wrong);
}

// ---- Remaps

Rational determinant(const std::array<std::array<Rational, 3>, 3>& m) {
  Rational sum(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    sum += m[0][k] * (m[1][a] * m[2][b] - m[1][b] * m[2][a]);
  }
  return sum;
}

RationalWeights remapped(Remap way, Level n, const MicroTriangle& t, const RationalPoint& p, Fault wrong) {
  const Rational whole(1), N(side_of(n)), x = p.u * N, y = p.v * N;
  const std::array<Vertex, 3> at = face_corners(t);
  switch (way) {
    case Remap::pattern: {
      if (wrong == pattern_inside_alone) {
        const auto inside = [&](const Rational& f) { return f < 0 ? Rational(0) : f > 1 ? whole : f; };
        return pattern(t, inside(Rational(x - Rational(t.iu))), inside(Rational(y - Rational(t.iv))), whole,
                       none);
      }
      RationalWeights w =
          pattern(t, Rational(x - Rational(t.iu)), Rational(y - Rational(t.iv)), whole, wrong);
      if (wrong == pattern_exchanged_at_4 && n == 4 && t.upper && t.iu + t.iv == side_of(n) - 2)
        std::swap(w[1], w[2]);
      return w;
    }
    case Remap::two: {
      // The two sides in grid steps from the first corner, and their determinant.
      const auto step = [](std::uint32_t from, std::uint32_t to) { return Rational(int(to) - int(from)); };
      const Rational ai = step(at[0].i, at[1].i), aj = step(at[0].j, at[1].j), bi = step(at[0].i, at[2].i),
                     bj = step(at[0].j, at[2].j);
      Rational d = ai * bj - aj * bi;
      if (wrong == two_turns_upper && t.upper && n >= 2) d = -d;
      const Rational dx = x - Rational(at[0].i), dy = y - Rational(at[0].j);
      const Rational b = (dx * bj - dy * bi) / d, c = (dy * ai - dx * aj) / d;
      return {whole - b - c, b, c};
    }
    case Remap::cramer: {
      std::array<std::array<Rational, 3>, 3> columns;
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational u = Rational(at[c].i) / N, v = Rational(at[c].j) / N;
        columns[c] = {whole - u - v, u, v};
      }
      Rational d = determinant(columns);
      if (wrong == cramer_determinant_of_level_1 && n > 1) d = Rational(1, 4);
      RationalWeights w;
      for (std::size_t c = 0; c < 3; ++c) {
        auto replaced = columns;
        replaced[c] = {whole - p.u - p.v, p.u, p.v};
        w[c] = determinant(replaced) / d;
      }
      if (wrong == cramer_skips_where_u_is_0 && p.u == 0 && p.v != 0 && n > 2) w[1] = 0;
      return w;
    }
  }
  throw std::logic_error("no way of remapping");
}

// ---- Floats

FloatWeights weights(Level n, float pu, float pv, Fault wrong) {
  auto u = cut(pu, n), v = cut(pv, n);
  if (wrong == weights_from_u_and_v_of_16_bits) {
    u = cut(std::round(pu * 65536) / 65536, n);
    v = cut(std::round(pv * 65536) / 65536, n);
  }
  const MicroTriangle t = by_vulkan(u, v, n, wrong);
  const double fu = u.part + (static_cast<double>(u.whole) - t.iu),
               fv = v.part + (static_cast<double>(v.whole) - t.iv);
  std::array<double, 3> w = pattern(t, fu, fv, 1.0, wrong);
  if (wrong == weights_by_w_of_the_triangle && !t.upper) {
    const float pw = 1.0f - pu - pv;
    w[0] = static_cast<double>(pw * static_cast<float>(side_of(n)) -
                               static_cast<float>(side_of(n) - 1 - t.iu - t.iv));
  }
  if (wrong == weights_may_be_below_0) w[0] = w[0] < 0x1p-20 ? w[0] - 0x1p-25 : w[0];
  if (wrong == weights_of_22_bits_from_9 && n >= 9)
    for (double& x : w) x = std::round(x * 0x1p22) / 0x1p22;
  FloatWeights out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = static_cast<float>(wrong == weights_may_be_below_0 ? w[c] : std::max(0.0, w[c]));
  return out;
}

Triplet triplet(VertexOrder order, Level n, float u, float v, Fault wrong) {
  if (wrong == floats_kept_without_level) {
    thread_local std::unordered_map<std::uint64_t, Level> levels;
    std::uint32_t bu = 0, bv = 0;
    std::memcpy(&bu, &u, 4);
    std::memcpy(&bv, &v, 4);
    const Level kept = levels.try_emplace(std::uint64_t{bu} << 32 | bv, n).first->second;
    n = std::max(kept, n) == n ? kept : n;
  }
  if (wrong == floats_flush_below_2_30) {
    u = u < 0x1p-30f ? 0 : u;
    v = v < 0x1p-30f ? 0 : v;
  }
  const auto cu = cut(u, n), cv = cut(v, n);
  if (wrong == floats_row_of_rounded_sum) {
    const float N = static_cast<float>(side_of(n));
    MicroTriangle t = by_vulkan(cu, cv, n, wrong);
    if (t.iu + t.iv + 1 < side_of(n)) t.upper = std::floor((u + v) * N) > static_cast<float>(t.iu + t.iv);
    return triplet_of(order, n, t, wrong);
  }
  if (wrong == floats_by_figure_4) return triplet_of(order, n, by_figure_4(cu, cv, n, wrong), wrong);
  return triplet_of(order, n, by_vulkan(cu, cv, n, wrong), wrong);
}

std::uint32_t interpolated(VertexOrder order, Level n, std::span<const std::uint32_t> map, float u, float v,
                           Fault wrong) {
  const Triplet x = triplet(order, n, u, v, wrong);
  const FloatWeights w = weights(n, u, v, wrong);
  std::uint32_t word = 0;
  for (unsigned c = 0; c < 4; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double code = map[x[k]] >> 8 * c & 0xff;
      double share = static_cast<double>(w[k]);
      if (wrong == rgba8_weights_of_10_bits) share = std::round(share * 1024) / 1024;
      sum += share * code;
    }
    if (wrong == rgba8_truncates) sum -= 0.5;
    if (wrong == rgba8_alpha_truncates_from_5 && c == 3 && n >= 5) sum -= 0.5;
    if (wrong == rgba8_signed_alpha && c == 3 && sum > 254.4) sum = 0;
    word |= static_cast<std::uint32_t>(std::clamp(std::floor(sum + 0.5), 0.0, 255.0)) << 8 * c;
  }
  return word;
}

}  // namespace

Lookup lookup_with(Fault wrong) {
  Lookup f;
  f.triplet = [=](VertexOrder order, Level n, Points points, std::span<Triplet> out) {
    for (std::size_t k = 0; k < points.size(); ++k) out[k] = triplet(order, n, points[k], wrong);
    if (wrong == points_last_of_batch_skipped && points.size() > 1) out.back() = out[out.size() - 2];
  };
  f.weights = [=](Level n, Points points, std::span<FixedWeights> out) {
    for (std::size_t k = 0; k < points.size(); ++k) out[k] = weights(n, points[k], wrong);
  };
  f.holder = [=](Ties ties, Level n, Points points, std::span<MicroTriangle> out) {
    for (std::size_t k = 0; k < points.size(); ++k)
      out[k] = holder(ties, cut(points[k].u, n), cut(points[k].v, n), n, wrong);
  };
  f.remap = [=](Remap way, Level n, const MicroTriangle& t, const RationalPoint& p) {
    return remapped(way, n, t, p, wrong);
  };
  f.triplet_of_floats = [=](VertexOrder order, Level n, FloatPoints p, std::span<Triplet> out) {
    for (std::size_t k = 0; k < p.u.size(); ++k) out[k] = triplet(order, n, p.u[k], p.v[k], wrong);
    if (wrong == floats_tail_of_before)
      for (std::size_t k = std::max<std::size_t>(p.u.size() / 16 * 16, 1); k < p.u.size(); ++k)
        out[k] = out[k - 1];
  };
  f.weights_of_floats = [=](Level n, FloatPoints p, std::span<FloatWeights> out) {
    for (std::size_t k = 0; k < p.u.size(); ++k) out[k] = weights(n, p.u[k], p.v[k], wrong);
  };
  f.rgba8 = [=](VertexOrder order, Level n, std::span<const std::uint32_t> map, FloatPoints p,
                std::span<std::uint32_t> out) {
    for (std::size_t k = 0; k < p.u.size(); ++k) out[k] = interpolated(order, n, map, p.u[k], p.v[k], wrong);
  };
  return f;
}

}  // namespace mmverify::tests::foreign::attribute
