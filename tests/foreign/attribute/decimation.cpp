// Edges beside a coarser neighbour.
// Source: Color and Attribute Micromaps, 3.2 and figure 3; docs/ATTRIBUTE.md, "Decimation".
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "tests/foreign/attribute/places.hpp"

namespace mmverify::tests::foreign::attribute {
namespace {

using proofs::attribute::Decimation;
using proofs::attribute::DyadicPoint;
using proofs::attribute::EdgeFlags;
using proofs::attribute::WeightedVertices;

enum Edge { wu, uv, vw };

/// Whether an odd vertex lies on the edge, and its flag is set.
bool leaves(const Vertex& at, Edge edge, Level n, EdgeFlags flags, Fault wrong) {
  const std::uint32_t N = side_of(n);
  if (n == 0) return false;
  EdgeFlags bit = EdgeFlags{1} << edge;
  if (wrong == flag_bits_of_the_opposite_corner) bit = EdgeFlags{1} << (edge + 2) % 3;
  if (wrong == flag_bits_exchanged_at_7 && n == 7 && edge != wu) bit = edge == uv ? 4 : 2;
  if ((flags & bit) == 0) return false;
  if (wrong == hypotenuse_flag_needs_another && edge == uv && flags == 2 && n > 4) return false;
  switch (edge) {
    case wu:
      if (wrong == decimates_up_to_the_last && n >= 5 && at.i == N - 1) return false;
      return at.j == 0 && at.i % 2 == 1;
    case uv: return at.i + at.j == N && at.j % 2 == 1;
    case vw: return at.i == 0 && at.j % 2 == 1;
  }
  return false;
}

Vertex snapped(Level n, EdgeFlags flags, const Vertex& at, Fault wrong) {
  const std::uint32_t N = side_of(n), k = N - at.i - at.j, middle = N / 2;
  const auto before = [&](std::uint32_t x) {
    if (wrong == snaps_towards_the_middle_from_4 && n >= 4) return x >= middle;
    if (wrong == snaps_middle_at_a_third && n >= 5) return x < N / 3;
    return x < middle;
  };
  if (leaves(at, wu, n, flags, wrong)) {
    if (wrong == snaps_by_i_alone_on_wu && flags == 5) return {at.i + 1, 0};
    if (wrong == snaps_three_steps_at_6 && n == 6 && before(k) && at.i + 3 <= N) return {at.i + 3, 0};
    return before(k) ? Vertex{at.i + 1, 0} : Vertex{at.i - 1, 0};
  }
  if (leaves(at, uv, n, flags, wrong))
    return before(at.i) ? Vertex{at.i - 1, at.j + 1} : Vertex{at.i + 1, at.j - 1};
  if (leaves(at, vw, n, flags, wrong)) {
    if (wrong == snaps_into_the_triangle && n > 3) return {1, at.j};
    return before(at.j) ? Vertex{0, at.j - 1} : Vertex{0, at.j + 1};
  }
  if (wrong == snaps_a_row_inside && (flags & 1) != 0 && at.j == 1 && at.i % 2 == 1 && at.i + 1 < N && n >= 5)
    return {at.i + 1, 1};
  return at;
}

std::array<Vertex, 2> averaged(Level n, EdgeFlags flags, const Vertex& at, Fault wrong) {
  if (wrong == means_at_corner_of_two_flags && (flags & 3) == 3 && n > 3 && at == Vertex{side_of(n) - 1, 0})
    return {at, at};
  if (leaves(at, wu, n, flags, wrong)) return {Vertex{at.i - 1, 0}, {at.i + 1, 0}};
  if (leaves(at, uv, n, flags, wrong)) {
    if (wrong == means_across_the_hypotenuse) return {Vertex{at.i - 1, at.j}, {at.i, at.j - 1}};
    return {Vertex{at.i - 1, at.j + 1}, {at.i + 1, at.j - 1}};
  }
  if (leaves(at, vw, n, flags, wrong)) {
    if (wrong == means_two_steps_off_at_8 && n == 8 && at.j > 2 && at.j < side_of(n) - 2)
      return {Vertex{0, at.j - 3}, {0, at.j + 3}};
    return {Vertex{0, at.j - 1}, {0, at.j + 1}};
  }
  return {at, at};
}

// ---- Lookup

struct On {
  std::array<Vertex, 3> corners;
  std::array<double, 3> weights;
  bool live;
  double least() const { return std::min({weights[0], weights[1], weights[2]}); }
};

/// The weights of (x, y) in a triangle, in binary64 and relative to the triangle's own corner: rounding stays below any
/// law's tolerance.
On on(const std::array<Vertex, 3>& c, double x, double y) {
  const auto d = [](std::uint32_t a, std::uint32_t b) {
    return static_cast<double>(a) - static_cast<double>(b);
  };
  const double area = d(c[1].i, c[0].i) * d(c[2].j, c[0].j) - d(c[1].j, c[0].j) * d(c[2].i, c[0].i);
  if (area == 0) return {c, {}, false};
  const double dx = x - c[0].i, dy = y - c[0].j;
  const double b = (dx * d(c[2].j, c[0].j) - dy * d(c[2].i, c[0].i)) / area,
               a = (dy * d(c[1].i, c[0].i) - dx * d(c[1].j, c[0].j)) / area;
  return {c, {1 - a - b, b, a}, true};
}

WeightedVertices place(Level n, EdgeFlags flags, double u, double v, Fault wrong) {
  const std::uint32_t N = side_of(n);
  const double x = u * N, y = v * N;
  const auto limited = [&](double z) { return std::min(N - 1, static_cast<std::uint32_t>(z)); };
  const std::int64_t iu = limited(x), iv = limited(y);
  On best{{}, {}, false};
  // The point's square and those around: a vertex that moves does so by one.
  const std::int64_t reach = wrong == place_looks_no_further ? 0 : 2;
  for (std::int64_t a = iu - reach; a <= iu + reach; ++a)
    for (std::int64_t b = iv - reach; b <= iv + reach; ++b)
      for (const bool upper : {false, true}) {
        if (a < 0 || b < 0 || a + b + (upper ? 1 : 0) >= N) continue;
        auto corners = face_corners({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), upper});
        for (Vertex& at : corners)
          at = snapped(n, wrong == place_flags_of_wu_alone ? flags & 1 : flags, at, wrong);
        const On here = on(corners, x, y);
        if (here.live && (!best.live || here.least() > best.least())) best = here;
      }
  if (wrong == place_keeps_grid_weights_at_5 && n == 5 && (flags & 2) != 0) {
    const double fu = x - static_cast<double>(iu), fv = y - static_cast<double>(iv);
    if (iu + iv + 1 == N && fu + fv <= 1) best.weights = {1 - fu - fv, fu, fv};
  }
  if (wrong == place_wide_triangles_by_2 && flags != 0 && n > 2) {
    const auto& c = best.corners;
    if (c[0].j == c[1].j && c[1].i == c[0].i + 2 && v > 0)
      best.weights = {best.weights[0] + best.weights[1] / 2, best.weights[1] / 2, best.weights[2]};
  }
  if (wrong == place_exchanges_at_a_quarter && flags == 1 && v == 0 && n > 3) {
    const double t = x / 2 - std::floor(x / 2);
    if (t == 0.25) std::swap(best.weights[0], best.weights[1]);
  }
  return {best.corners, best.weights};
}

double number(const spec::Fixed64& x) { return std::ldexp(static_cast<double>(x.raw()), -30); }

}  // namespace

Decimation decimation_with(Fault wrong) {
  Decimation f;
  f.snapped = [=](Level n, EdgeFlags flags, std::span<const Vertex> at, std::span<Vertex> out) {
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = snapped(n, flags, at[k], wrong);
  };
  f.averaged = [=](Level n, EdgeFlags flags, std::span<const Vertex> at,
                   std::span<std::array<Vertex, 2>> out) {
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = averaged(n, flags, at[k], wrong);
  };
  f.mean = [=](std::uint8_t a, std::uint8_t b) {
    if (wrong == mean_in_8_bits) return static_cast<std::uint8_t>(static_cast<std::uint8_t>(a + b + 1) / 2);
    if (wrong == mean_down) return static_cast<std::uint8_t>((a + b) / 2);
    if (wrong == mean_down_of_255)
      return static_cast<std::uint8_t>((a + b + (a == 255 || b == 255 ? 0 : 1)) / 2);
    if (wrong == mean_to_even) return static_cast<std::uint8_t>(std::nearbyint((a + b) / 2.0));
    return static_cast<std::uint8_t>((a + b + 1) / 2);
  };
  f.place = [=](Level n, EdgeFlags flags, const DyadicPoint& p) {
    return place(n, flags, number(p.u), number(p.v), wrong);
  };
  f.place_f32 = [=](Level n, EdgeFlags flags, float u, float v) {
    if (wrong == place_u_of_12_bits) u = std::round(u * 4096) / 4096;
    if (wrong == place_drops_low_bits_at_7 && n == 7) v = std::floor(v * 0x1p21f) / 0x1p21f;
    WeightedVertices w = place(n, flags, static_cast<double>(u), static_cast<double>(v), wrong);
    if (wrong == place_weights_an_ulp_off)
      for (double& x : w.weights) x += std::ldexp(x < 0.5 ? 1 : -1, -23);
    return w;
  };
  return f;
}

}  // namespace mmverify::tests::foreign::attribute
