#include "scene/flip/rows.hpp"

#include "scene/flip/colour.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/flip/rows.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Sums of products are not fused: each target rounds as every other one does.
HWY_BEFORE_NAMESPACE();
namespace mmverify::flip::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using V = hn::Vec<Floats>;

HWY_INLINE V all(double x) { return hn::Set(Floats(), static_cast<float>(x)); }
HWY_INLINE V plus_product(V sum, V a, V b) { return hn::Add(sum, hn::Mul(a, b)); }

// ---- Functions

/// The cube root.  Domain: x normal and positive.  A first guess from the bits, then Halley's step twice:
/// errors 3e-2, 2e-5, rounding.
HWY_INLINE V cube_root(V x) {
  const hn::RebindToSigned<Floats> integers;
  const V third = hn::Mul(hn::ConvertTo(Floats(), hn::BitCast(integers, x)), all(1. / 3));
  V y = hn::BitCast(Floats(), hn::Add(hn::ConvertTo(integers, third), hn::Set(integers, 0x2a514067)));
  for (int step = 0; step < 2; ++step) {
    const V cube = hn::Mul(y, hn::Mul(y, y));
    y = hn::Mul(y, hn::Div(hn::Add(cube, hn::Add(x, x)), hn::Add(hn::Add(cube, cube), x)));
  }
  return y;
}

/// log2 x = e + log2 m, 1/sqrt 2 <= m < sqrt 2, by the series of artanh at t = (m - 1)/(m + 1), |t| < 0.172.
HWY_INLINE V log2_of(V x) {
  const hn::RebindToSigned<Floats> integers;
  // The bits of 1/sqrt 2.  e counts the powers of 2 from there.
  const auto root = hn::Set(integers, 0x3f3504f3);
  const auto bits = hn::BitCast(integers, x);
  const auto e = hn::ShiftRight<23>(hn::Sub(bits, root));
  const V m = hn::BitCast(Floats(), hn::Sub(bits, hn::ShiftLeft<23>(e)));
  const V t = hn::Div(hn::Sub(m, all(1)), hn::Add(m, all(1))), s = hn::Mul(t, t);
  constexpr double two_over_ln2 = 2.8853900817779268;
  V sum = all(two_over_ln2 / 9);
  for (const int n : {7, 5, 3, 1}) sum = plus_product(all(two_over_ln2 / n), sum, s);
  return plus_product(hn::ConvertTo(Floats(), e), sum, t);
}

/// 2^y, -126 <= y <= 1: 2^(y - n) by the series of e^z, |z| <= ln 2 / 2.
HWY_INLINE V exp2_of(V y) {
  const hn::RebindToSigned<Floats> integers;
  const auto n = hn::NearestInt(y);
  const V z = hn::Mul(hn::Sub(y, hn::ConvertTo(Floats(), n)), all(0.6931471805599453));
  V sum = all(1);
  for (const int k : {7, 6, 5, 4, 3, 2, 1}) sum = hn::Add(all(1), hn::Mul(hn::Mul(sum, z), all(1. / k)));
  const auto power = hn::ShiftLeft<23>(hn::Add(n, hn::Set(integers, 127)));
  return hn::Mul(sum, hn::BitCast(Floats(), power));
}

/// x^p, 0 <= p <= 1; 0 if x is below every normal number.
HWY_INLINE V power(V x, V p) {
  const V least = all(0x1p-126);
  const V value = exp2_of(hn::Max(all(-126), hn::Mul(p, log2_of(hn::Max(x, least)))));
  return hn::IfThenElseZero(hn::Ge(x, least), value);
}

// ---- Filters

void along_x(const Filters& filters, const std::array<const float*, opponents>& rows, float (*out)[piece]) {
  const Floats f;
  const SpatialFilters& s = filters.spatial;
  const FeatureFilters& g = filters.feature;
  for (std::size_t x = 0; x < piece; x += hn::Lanes(f)) {
    const float *const y = rows[opponent_y] + x, *const xy = rows[opponent_xy] + x,
                       *const yz = rows[opponent_yz] + x;
    const auto weight = [](const Half& half, std::size_t k) { return hn::Set(Floats(), half[k]); };
    const V centre = hn::LoadU(f, y), centre_yz = hn::LoadU(f, yz);
    V by = hn::Mul(weight(s.luminance, 0), centre), bxy = hn::Mul(weight(s.red_green, 0), hn::LoadU(f, xy));
    V wide = hn::Mul(weight(s.blue_yellow[0], 0), centre_yz),
      narrow = hn::Mul(weight(s.blue_yellow[1], 0), centre_yz);
    for (std::size_t k = 1; k <= s.radius; ++k) {
      const V sides_yz = hn::Add(hn::LoadU(f, yz - k), hn::LoadU(f, yz + k));
      by = plus_product(by, weight(s.luminance, k), hn::Add(hn::LoadU(f, y - k), hn::LoadU(f, y + k)));
      bxy = plus_product(bxy, weight(s.red_green, k), hn::Add(hn::LoadU(f, xy - k), hn::LoadU(f, xy + k)));
      wide = plus_product(wide, weight(s.blue_yellow[0], k), sides_yz);
      narrow = plus_product(narrow, weight(s.blue_yellow[1], k), sides_yz);
    }
    // The weights of `point` sum to 0, so the centre is subtracted first: a constant gives exactly 0.
    V smooth = hn::Mul(weight(g.smooth, 0), centre), edge = hn::Zero(f), point = hn::Zero(f);
    const V twice = hn::Add(centre, centre);
    for (std::size_t k = 1; k <= g.radius; ++k) {
      const V left = hn::LoadU(f, y - k), right = hn::LoadU(f, y + k), sides = hn::Add(left, right);
      smooth = plus_product(smooth, weight(g.smooth, k), sides);
      edge = plus_product(edge, weight(g.edge, k), hn::Sub(right, left));
      point = plus_product(point, weight(g.point, k), hn::Sub(sides, twice));
    }
    const V results[filtered] = {by, bxy, wide, narrow, smooth, edge, point};
    for (std::size_t k = 0; k < filtered; ++k) hn::StoreU(results[k], f, out[k] + x);
  }
}

/// A part's texels after both filters.
struct FilteredTexels {
  V y, xy, yz;          ///< as the eye resolves them
  V edge[2], point[2];  ///< gradients along x and along y
};

HWY_INLINE FilteredTexels along_y(const Filters& filters, Window rows, std::size_t radius, std::size_t x) {
  const Floats f;
  const SpatialFilters& s = filters.spatial;
  const FeatureFilters& g = filters.feature;
  const auto load = [&](std::size_t row, Filtered what) { return hn::LoadU(f, rows[row][what] + x); };
  const auto weight = [](const Half& half, std::size_t k) { return hn::Set(Floats(), half[k]); };
  const auto sides = [&](std::size_t k, Filtered what) {
    return hn::Add(load(radius - k, what), load(radius + k, what));
  };
  V y = hn::Mul(weight(s.luminance, 0), load(radius, spatial_y));
  V xy = hn::Mul(weight(s.red_green, 0), load(radius, spatial_xy));
  V wide = hn::Mul(weight(s.blue_yellow[0], 0), load(radius, spatial_yz_wide));
  V narrow = hn::Mul(weight(s.blue_yellow[1], 0), load(radius, spatial_yz_narrow));
  for (std::size_t k = 1; k <= s.radius; ++k) {
    y = plus_product(y, weight(s.luminance, k), sides(k, spatial_y));
    xy = plus_product(xy, weight(s.red_green, k), sides(k, spatial_xy));
    wide = plus_product(wide, weight(s.blue_yellow[0], k), sides(k, spatial_yz_wide));
    narrow = plus_product(narrow, weight(s.blue_yellow[1], k), sides(k, spatial_yz_narrow));
  }
  V edge_x = hn::Mul(weight(g.smooth, 0), load(radius, edge_y));
  V point_x = hn::Mul(weight(g.smooth, 0), load(radius, point_y));
  V edge_down = hn::Zero(f), point_down = hn::Zero(f);
  const V centre = load(radius, smooth_y), twice = hn::Add(centre, centre);
  for (std::size_t k = 1; k <= g.radius; ++k) {
    const V above = load(radius - k, smooth_y), below = load(radius + k, smooth_y);
    edge_x = plus_product(edge_x, weight(g.smooth, k), sides(k, edge_y));
    point_x = plus_product(point_x, weight(g.smooth, k), sides(k, point_y));
    edge_down = plus_product(edge_down, weight(g.edge, k), hn::Sub(below, above));
    point_down = plus_product(point_down, weight(g.point, k), hn::Sub(hn::Add(above, below), twice));
  }
  return {y, xy, hn::Add(wide, narrow), {edge_x, edge_down}, {point_x, point_down}};
}

// ---- Texel by texel

HWY_INLINE V product(const Vector& row, V a, V b, V c) {
  return plus_product(plus_product(hn::Mul(all(row[0]), a), all(row[1]), b), all(row[2]), c);
}

HWY_INLINE V length(V a, V b) { return hn::Sqrt(hn::Add(hn::Mul(a, a), hn::Mul(b, b))); }

/// | |m + d| - |m - d| | = 4 |m d| / (|m + d| + |m - d|): no two lengths are subtracted.
HWY_INLINE V difference_of_lengths(const V (&m)[2], const V (&d)[2]) {
  const V both = hn::Add(length(hn::Add(m[0], d[0]), hn::Add(m[1], d[1])),
                         length(hn::Sub(m[0], d[0]), hn::Sub(m[1], d[1])));
  const V product = hn::Abs(hn::Mul(all(4), hn::Add(hn::Mul(m[0], d[0]), hn::Mul(m[1], d[1]))));
  return hn::Div(product, hn::Max(both, all(0x1p-126)));
}

/// The values of both pictures, and their difference, which has only its own rounding.
struct Both {
  V a, b, difference;
};

/// Linear RGB, limited to what a screen shows.
HWY_INLINE Both limited(V m, V d) {
  const auto limit = [](V c) { return hn::Min(hn::Max(c, all(0)), all(1)); };
  const V a = hn::Add(m, d), b = hn::Sub(m, d), la = limit(a), lb = limit(b);
  const auto inside = hn::And(hn::Eq(a, la), hn::Eq(b, lb));
  return {la, lb, hn::IfThenElse(inside, hn::Add(d, d), hn::Sub(la, lb))};
}

/// f(t) of L*a*b*; for cube roots fa - fb = (ta - tb) / (fa^2 + fa fb + fb^2).
HWY_INLINE Both lab_f_of(const Both& t) {
  constexpr double cube = lab_delta * lab_delta * lab_delta, slope = 1 / (3 * lab_delta * lab_delta);
  const auto f = [](V x) {
    return hn::IfThenElse(hn::Gt(x, all(cube)), cube_root(hn::Max(x, all(cube))),
                          plus_product(all(4. / 29), x, all(slope)));
  };
  const V a = f(t.a), b = f(t.b);
  const V squares = hn::Add(hn::Add(hn::Mul(a, a), hn::Mul(b, b)), hn::Mul(a, b));
  const auto low_a = hn::Le(t.a, all(cube)), low_b = hn::Le(t.b, all(cube));
  const V roots = hn::Div(t.difference, squares), lines = hn::Mul(t.difference, all(slope));
  return {a, b, hn::IfThenElse(hn::Xor(low_a, low_b), hn::Sub(a, b), hn::IfThenElse(low_a, lines, roots))};
}

/// The difference of colour: back to linear RGB, to L*a*b* with its a* and b* times L*/100 (Hunt), HyAB of that.
HWY_INLINE V colour_difference(const FilteredTexels& m, const FilteredTexels& d) {
  Both rgb[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& row = rgb_of_relative_xyz[i];
    rgb[i] = limited(product(row, hn::Add(m.y, m.xy), m.y, hn::Sub(m.y, m.yz)),
                     product(row, hn::Add(d.y, d.xy), d.y, hn::Sub(d.y, d.yz)));
  }
  Both f[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& row = relative_xyz_of_rgb[i];
    f[i] = lab_f_of({product(row, rgb[0].a, rgb[1].a, rgb[2].a), product(row, rgb[0].b, rgb[1].b, rgb[2].b),
                     product(row, rgb[0].difference, rgb[1].difference, rgb[2].difference)});
  }
  const auto l_of = [](V y) { return hn::Sub(hn::Mul(all(116), y), all(16)); };
  const Both l{l_of(f[1].a), l_of(f[1].b), hn::Mul(all(116), f[1].difference)};
  // La a - Lb b = ((La + Lb)(a - b) + (a + b)(La - Lb)) / 2.
  const auto faded = [&l](const Both& from, const Both& take, double factor) {
    const V difference = hn::Sub(from.difference, take.difference);
    const V sum = hn::Add(hn::Sub(from.a, take.a), hn::Sub(from.b, take.b));
    const V twice = hn::Add(hn::Mul(hn::Add(l.a, l.b), difference), hn::Mul(sum, l.difference));
    return hn::Mul(all(factor / 200), twice);
  };
  return hn::Add(hn::Abs(l.difference), length(faded(f[0], f[1], 500), faded(f[1], f[2], 200)));
}

void errors(const Filters& filters, const std::array<Window, parts>& windows, std::size_t radius,
            float* out) {
  const Floats f;
  const double greatest = greatest_difference(), bend = p_c * greatest;
  for (std::size_t x = 0; x < piece; x += hn::Lanes(f)) {
    const FilteredTexels m = along_y(filters, windows[middle], radius, x),
                         d = along_y(filters, windows[difference], radius, x);
    const V apart = power(colour_difference(m, d), all(q_c));
    const V below = hn::Mul(apart, all(p_t / bend));
    const V above = plus_product(all(p_t), hn::Sub(apart, all(bend)), all((1 - p_t) / (greatest - bend)));
    const V colour = hn::Min(hn::IfThenElse(hn::Lt(apart, all(bend)), below, above), all(1));
    const V feature = hn::Max(difference_of_lengths(m.edge, d.edge), difference_of_lengths(m.point, d.point));
    // q_f is 1/2.
    const V sharpened = hn::Min(hn::Sqrt(hn::Mul(feature, all(0.70710678118654752))), all(1));
    hn::StoreU(power(colour, hn::Sub(all(1), sharpened)), f, out + x);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::flip::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::flip::detail {

HWY_EXPORT(along_x);
HWY_EXPORT(errors);

void filter_along_x(const Filters& filters, const std::array<const float*, opponents>& rows,
                    float (*out)[piece]) {
  HWY_DYNAMIC_DISPATCH(along_x)(filters, rows, out);
}

void errors_of_piece(const Filters& filters, const std::array<Window, parts>& windows, std::size_t radius,
                     float* out) {
  HWY_DYNAMIC_DISPATCH(errors)(filters, windows, radius, out);
}

}  // namespace mmverify::flip::detail
#endif  // HWY_ONCE
