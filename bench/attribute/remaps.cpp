// Four ways from barycentrics of the triangle to those of the micro-triangle, in binary32: their costs and
// errors.
#include <cmath>
#include <random>
#include <utility>

#include "bench/attribute/bench.hpp"
#include "bench/attribute/points.hpp"
#include "bench/rounds.hpp"
#include "impl/attribute/lookup.hpp"
#include "spec/attribute/lookup.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::attribute;
using Three = std::array<float, 3>;

/// Points and the micro-triangles that contain them.
struct Located {
  std::uint32_t level;
  FloatPoints points;
  std::vector<fast::MicroTriangle> at;
  std::vector<float> w0, w1, w2;

  explicit Located(std::uint32_t n, FloatPoints p) : level(n), points(std::move(p)) {
    const std::size_t count = points.u.size();
    for (std::size_t k = 0; k < count; ++k) at.push_back(fast::locate(points.u[k], points.v[k], n).at);
    for (auto* w : {&w0, &w1, &w2}) w->resize(count);
  }
};

/// The weights from two equations of the over-determined system of 4.1: steps between corners are -1, 0 or 1
/// micro-edge.
Three by_two_equations(float u, float v, const fast::MicroTriangle& t, std::uint32_t n) {
  const auto c = fast::corners_of(t);
  const auto number = [](std::uint32_t x) { return static_cast<float>(static_cast<std::int32_t>(x)); };
  const auto step = [](std::uint32_t from, std::uint32_t to) {
    return static_cast<float>(static_cast<std::int32_t>(to - from));
  };
  const auto side = static_cast<float>(std::int32_t{1} << n);
  const float x = u * side - number(c[0].i), y = v * side - number(c[0].j);
  const float a = step(c[0].i, c[1].i), b = step(c[0].i, c[2].i), d = step(c[0].j, c[1].j),
              e = step(c[0].j, c[2].j);
  const float w1 = x * e - b * y, w2 = a * y - x * d;  // the determinant a e - b d is 1
  return {1 - w1 - w2, w1, w2};
}

Three by_cramer(float u, float v, const fast::MicroTriangle& t, std::uint32_t n) {
  return spec::attribute::weights_by_cramer(spec::Point<float>{u, v},
                                            spec::attribute::corners_of({t.iu, t.iv, t.upper}), n);
}

Three by_pattern(float u, float v, const fast::MicroTriangle& t, std::uint32_t n) {
  return spec::attribute::weights_by_pattern(spec::Point<float>{u, v}, {t.iu, t.iv, t.upper}, n);
}

template <Three remap(float, float, const fast::MicroTriangle&, std::uint32_t)>
void each(Located& l) {
  for (std::size_t k = 0; k < l.at.size(); ++k) {
    const Three w = remap(l.points.u[k], l.points.v[k], l.at[k], l.level);
    l.w0[k] = w[0];
    l.w1[k] = w[1];
    l.w2[k] = w[2];
  }
}

void run(Remap remap, Located& l) {
  switch (remap) {
    case Remap::cramer: return each<by_cramer>(l);
    case Remap::two_equations: return each<by_two_equations>(l);
    case Remap::pattern: return each<by_pattern>(l);
    case Remap::ours: return fast::weights(l.points.u, l.points.v, l.level, {l.w0, l.w1, l.w2});
  }
}

/// Points of all magnitudes, since the weights of evenly spread ones, multiples of 2^-24, are hardly ever
/// rounded.  Every other point lies near a grid line, where a weight is small and its terms are not.
FloatPoints judged_points(std::uint32_t level, std::size_t count, std::mt19937_64& random) {
  const auto side = static_cast<float>(1u << level);
  const auto fraction = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  FloatPoints points;
  for (std::size_t k = 0; k < count; ++k) {
    auto u = static_cast<float>(std::ldexp(fraction(), -static_cast<int>(random() % 16)));
    auto v = static_cast<float>((1 - double{u}) * fraction());
    if (k % 4 == 0) u = std::floor(u * side) / side;
    if (k % 4 == 2) v = std::floor(v * side) / side;
    for (std::uint64_t steps = random() % 4; steps > 0; --steps) u = std::nextafter(u, 1.0f);
    if (k % 4 == 1) std::swap(u, v);
    if (double{u} + double{v} > 1) u = v = 0.25f;
    points.u.push_back(u);
    points.v.push_back(v);
  }
  return points;
}

/// The weights in binary64, with a relative error of 2^-53 or less: for figures, not for verdicts.
std::array<double, 3> near_exact(float u, float v, const fast::MicroTriangle& t, std::uint32_t n) {
  return spec::attribute::weights_by_pattern(spec::Point<double>{double{u}, double{v}}, {t.iu, t.iv, t.upper},
                                             n);
}

void judge(const Located& l, RemapFigure& figure) {
  for (std::size_t k = 0; k < l.at.size(); ++k) {
    const auto right = near_exact(l.points.u[k], l.points.v[k], l.at[k], l.level);
    const Three got{l.w0[k], l.w1[k], l.w2[k]};
    if (!std::isfinite(got[0]) || !std::isfinite(got[1]) || !std::isfinite(got[2])) {
      ++figure.no_number;
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = std::fabs(double{got[c]} - right[c]);
      figure.worst = std::max(figure.worst, error);
      if (right[c] >= least_in_ulps)
        figure.worst_ulp = std::max(figure.worst_ulp, std::ldexp(error, 23 - std::ilogb(right[c])));
    }
  }
}

/// The condition of a way's system.  A corner's micro-triangle is the worst
/// (AttributeLookup.the_systems_condition_is_2N_minus_1).
std::optional<double> condition_of(Remap remap, std::uint32_t level) {
  if (remap == Remap::cramer) return spec::attribute::system_condition<double>({0, 0, false}, level);
  if (remap == Remap::two_equations) return 1;
  return std::nullopt;
}

RemapLevel measured(std::uint32_t level, const AttributeBenchOptions& o) {
  RemapLevel result{level, o.samples, {}};
  for (const Remap remap : all_remaps)
    result.by[static_cast<std::size_t>(remap)].condition = condition_of(remap, level);
  std::mt19937_64 random(o.seed + 100 + level);
  constexpr std::uint64_t piece = 1 << 14;
  for (std::uint64_t left = o.samples; left > 0;) {
    const std::uint64_t count = std::min(left, piece);
    Located l(level, judged_points(level, static_cast<std::size_t>(count), random));
    for (const Remap remap : all_remaps) {
      run(remap, l);
      judge(l, result.by[static_cast<std::size_t>(remap)]);
    }
    left -= count;
  }
  Located l(level, uniform_points(points_timed, random));
  std::vector<Work> works;
  for (const Remap remap : all_remaps) works.push_back({points_timed, [&l, remap] { run(remap, l); }});
  const RoundTimes times = times_in_rounds(works, o.rounds);
  for (std::size_t r = 0; r < remaps; ++r) {
    const Spread spread = spread_of(times[r]);
    result.by[r].ns = spread.median;
    result.by[r].least_ns = spread.least;
    result.by[r].most_ns = spread.most;
  }
  return result;
}

}  // namespace

const char* to_string(Remap remap) {
  constexpr const char* names[] = {"3x3 by Cramer", "two equations", "pattern", "ours, locates too, batched"};
  return names[static_cast<std::size_t>(remap)];
}

std::vector<RemapLevel> attribute_remaps(const AttributeBenchOptions& o) {
  std::vector<RemapLevel> levels;
  for (std::uint32_t level = o.first; level <= o.last; ++level) {
    if (o.progress) o.progress("remaps at level " + std::to_string(level));
    levels.push_back(measured(level, o));
  }
  return levels;
}

}  // namespace mmverify::bench
