#include <random>
#include <stdexcept>

#include "bench/rounds.hpp"
#include "bench/subdivision/bench.hpp"
#include "impl/subdivision/subdivision.hpp"
#include "spec/subdivision/subdivision.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::subdivision;
using spec::subdivision::Scheme;
using Cell = spec::subdivision::Cell<double>;

constexpr std::size_t count = 1 << 10, rounds = 5;

/// Points of a shape whose determinants at level 8 and below are whole numbers below 2^53.
std::vector<fast::Point> points_in(Scheme scheme, std::uint64_t seed) {
  const auto c = spec::subdivision::cut(scheme);
  const std::uint32_t denominator = c.dimension == 3 ? 1 << 9 : 1 << 12;
  std::mt19937_64 random(seed);
  std::vector<fast::Point> points;
  while (points.size() < count) {
    fast::Point p{{}, denominator};
    std::uint32_t sum = 0;
    for (std::size_t axis = 0; axis < c.dimension; ++axis) {
      p.numerators[axis] = static_cast<std::uint32_t>(random() % (denominator + 1));
      sum += p.numerators[axis];
    }
    if (c.corners > c.dimension + 1 || sum <= denominator) points.push_back(p);
  }
  return points;
}

SubdivisionTimes times_of(Scheme scheme, std::uint32_t level, std::uint64_t seed) {
  const auto of_library = static_cast<fast::Scheme>(scheme);
  const std::vector<fast::Point> points = points_in(scheme, seed);
  const double N = fast::side(of_library, level), unit = N * points[0].denominator;
  std::vector<std::uint32_t> found(count), specified(count);
  std::vector<fast::Corners> corners(count);
  std::vector<Cell> cells(count);
  const RoundTimes ns =
      times_in_rounds({{count,
                        [&] {
                          for (std::size_t k = 0; k < count; ++k)
                            found[k] = fast::index(of_library, level, points[k]);
                        }},
                       {count,
                        [&] {
                          for (std::size_t k = 0; k < count; ++k) {
                            const auto& [x, y, z] = points[k].numerators;
                            specified[k] = static_cast<std::uint32_t>(
                                spec::subdivision::index<double>(scheme, level, {x * N, y * N, z * N}, unit));
                          }
                        }},
                       {count,
                        [&] {
                          for (std::size_t k = 0; k < count; ++k)
                            corners[k] = fast::corners(of_library, level, found[k]);
                        }},
                       {count,
                        [&] {
                          for (std::size_t k = 0; k < count; ++k)
                            cells[k] = spec::subdivision::cell<double>(scheme, level, found[k], N);
                        }}},
                      rounds);
  if (found != specified) throw std::runtime_error("subdivision bench: two ways give other cells");
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t c = 0; c < cells[k].corners.size(); ++c)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (cells[k].corners[c][axis] != corners[k][c][axis])
          throw std::runtime_error("subdivision bench: two ways give other corners");
  return {spec::subdivision::cut(scheme).name, level,         median(ns[0]),
          median_ratio(ns[1], ns[0]),          median(ns[2]), median_ratio(ns[3], ns[2])};
}

}  // namespace

std::vector<SubdivisionTimes> subdivision_times(const SubdivisionBenchOptions& options) {
  std::vector<SubdivisionTimes> all;
  for (const Scheme scheme : spec::subdivision::all_schemes)
    for (std::uint32_t n = options.first; n <= options.last; ++n) {
      const std::uint32_t level = scheme == Scheme::bisection ? 2 * n : n;
      if (options.progress)
        options.progress(std::string(spec::subdivision::cut(scheme).name) + ", level " +
                         std::to_string(level));
      all.push_back(times_of(scheme, level, options.seed));
    }
  return all;
}

}  // namespace mmverify::bench
