#include "bench/index/distance.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "bench/exact.hpp"

namespace mmverify::bench {
namespace {

using spec::times;  // for rationals; Fixed brings its own
using spec::index::Corners;
using spec::index::Vertex;

struct Range {
  std::uint32_t least, most;
};

/// The least and greatest of i, j or i+j over the corners.
template <class Of>
Range range(const Corners& corners, Of of) {
  const auto [least, most] = std::minmax({of(corners[0]), of(corners[1]), of(corners[2])});
  return {least, most};
}

Range range_i(const Corners& c) {
  return range(c, [](const Vertex& x) { return x.i; });
}
Range range_j(const Corners& c) {
  return range(c, [](const Vertex& x) { return x.j; });
}
Range range_sum(const Corners& c) {
  return range(c, [](const Vertex& x) { return x.i + x.j; });
}

}  // namespace

bool on_grid(const Corners& corners, spec::Level n) {
  const std::uint32_t N = spec::side(n);
  // The coordinates are checked first, since a wrapped one could wrap the sum back.
  for (const Vertex& x : corners)
    if (x.i > N || x.j > N || x.i + x.j > N) return false;
  const auto one_wide = [](const Range& r) { return r.most - r.least == 1; };
  return one_wide(range_i(corners)) && one_wide(range_j(corners)) && one_wide(range_sum(corners));
}

Distance distance(const InputPoint& point, const Corners& corners, spec::Level n, const NumberType& numbers) {
  const Range i = range_i(corners), j = range_j(corners), sum = range_sum(corners);
  const bool upright = sum.least == i.least + j.least;
  const std::array<std::uint32_t, 3> lines =
      upright ? std::array{i.least, j.least, sum.most} : std::array{i.most, j.most, sum.least};
  return on_exact(point.u, point.v, [&]<class Q>(const spec::Point<Q>& p) {
    const std::uint32_t N = spec::side(n);
    const Q u = times(N, p.u), v = times(N, p.v), uv = u + v;
    // The signs are those of an upright micro-triangle; an inverted one's sides face the other way.
    std::array<Q, 3> outside{Q(lines[0]) - u, Q(lines[1]) - v, uv - Q(lines[2])};
    if (!upright) outside = {u - Q(lines[0]), v - Q(lines[1]), Q(lines[2]) - uv};
    const auto worst = std::max_element(outside.begin(), outside.end());
    if (!(Q(0) < *worst)) return Distance{0, 0};
    const double line = static_cast<double>(lines[static_cast<std::size_t>(worst - outside.begin())]) / N;
    const double heights = to_double(*worst);
    return Distance{heights, heights / N / numbers.ulp(line)};
  });
}

}  // namespace mmverify::bench
