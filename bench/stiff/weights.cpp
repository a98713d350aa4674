// The weights of a point in a tiny micro-triangle.
#include <cmath>

#include "bench/attribute/points.hpp"
#include "bench/exact.hpp"
#include "bench/stiff/parts.hpp"
#include "impl/attribute/lookup.hpp"
#include "spec/attribute/lookup.hpp"

namespace mmverify::bench::stiff {
namespace {

namespace fast = impl::attribute;
namespace exact = spec::attribute;
using spec::Rational;

constexpr std::uint32_t stiff_level = 12, ordinary_level = 2;
constexpr std::size_t timed_weights = 2048;
constexpr std::uint64_t samples_a_weight = 16;
constexpr double bound = 0x1p-24;

struct WeightPoints {
  std::uint32_t level;
  FloatPoints points;
  std::vector<exact::MicroTriangle> at = {};
  std::vector<exact::Weights<Rational>> truth = {};
  std::vector<float> w0 = {}, w1 = {}, w2 = {};
  double rational_ns = 0;

  WeightPoints(std::uint32_t n, std::size_t count, Random random)
      : level(n), points(uniform_points(count, random)), w0(count), w1(count), w2(count) {
    std::vector<spec::Point<Rational>> exactly;
    for (std::size_t k = 0; k < count; ++k) {
      const fast::MicroTriangle t = fast::locate(points.u[k], points.v[k], n).at;
      at.push_back({t.iu, t.iv, t.upper});
      exactly.push_back({exact_rational(double{points.u[k]}), exact_rational(double{points.v[k]})});
    }
    rational_ns = once_ns([&] {
                    for (std::size_t k = 0; k < count; ++k)
                      truth.push_back(exact::weights_by_pattern(exactly[k], at[k], n));
                  }) /
                  static_cast<double>(count);
  }

  template <class Q, class Weigh>
  void each(std::size_t count, Weigh weigh) {
    for (std::size_t k = 0; k < count; ++k) {
      const auto w = weigh(spec::Point<Q>{Q{points.u[k]}, Q{points.v[k]}}, at[k], level);
      w0[k] = static_cast<float>(w[0]);
      w1[k] = static_cast<float>(w[1]);
      w2[k] = static_cast<float>(w[2]);
    }
  }

  std::uint64_t wrong() const {
    const auto off = [](float got, const Rational& right) {
      return !std::isfinite(got) || abs(exact_rational(double{got}) - right) > exact_rational(bound);
    };
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < truth.size(); ++k)
      count += off(w0[k], truth[k][0]) || off(w1[k], truth[k][1]) || off(w2[k], truth[k][2]) ? 1 : 0;
    return count;
  }
};

using Weighing = void (*)(WeightPoints&, std::size_t count);

template <class Q>
void by_cramer(WeightPoints& p, std::size_t count) {
  p.each<Q>(count, [](const auto& at, const auto& t, std::uint32_t n) {
    return exact::weights_by_cramer(at, exact::corners_of(t), n);
  });
}
void by_two(WeightPoints& p, std::size_t count) {
  p.each<float>(count, [](const auto& at, const auto& t, std::uint32_t n) {
    return exact::weights_by_two(at, exact::corners_of(t), n);
  });
}
void by_pattern(WeightPoints& p, std::size_t count) {
  p.each<float>(count, [](const auto& at, const auto& t, std::uint32_t n) {
    return exact::weights_by_pattern(at, t, n);
  });
}
void by_ours(WeightPoints& p, std::size_t count) {
  fast::weights(std::span(p.points.u).first(count), std::span(p.points.v).first(count), p.level,
                {std::span(p.w0).first(count), std::span(p.w1).first(count), std::span(p.w2).first(count)});
}

}  // namespace

void add_weights(const StiffBenchOptions& o, std::vector<StiffFigure>& figures) {
  constexpr const char* kind = "tiny";
  if (o.progress) o.progress(kind);
  const std::size_t count = std::max<std::size_t>(1, o.samples / samples_a_weight),
                    few = std::min(count, timed_weights);
  WeightPoints stiff(stiff_level, count, stream(o.seed, 20)),
      ordinary(ordinary_level, count, stream(o.seed, 20));
  const std::pair<const char*, Weighing> methods[] = {{"Cramer, binary32", by_cramer<float>},
                                                      {"Cramer, binary64", by_cramer<double>},
                                                      {"2 equations, binary32", by_two},
                                                      {"pattern, binary32", by_pattern},
                                                      {"ours", by_ours}};
  for (const auto& [name, weigh] : methods) {
    weigh(stiff, count);
    weigh(ordinary, count);
    StiffFigure figure{.kind = kind,
                       .method = name,
                       .cases = count,
                       .wrong = stiff.wrong(),
                       .ordinary_wrong = ordinary.wrong(),
                       .is_ours = weigh == by_ours};
    add_times(figure, few, few, o.rounds,
              [&, weigh = weigh](bool is_stiff) { weigh(is_stiff ? stiff : ordinary, few); });
    figures.push_back(figure);
  }
  figures.push_back({.kind = kind,
                     .method = "rational",
                     .cases = count,
                     .ns = stiff.rational_ns,
                     .ratio = stiff.rational_ns / ordinary.rational_ns});
}

}  // namespace mmverify::bench::stiff
