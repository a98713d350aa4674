#include "scene/attribute/map_reading.hpp"

#include <algorithm>

#include "impl/index/index.hpp"

namespace mmverify::scene {

std::size_t face_index(unsigned level, double u, double v) {
  return impl::index::from_barycentrics(static_cast<float>(u), static_cast<float>(v), level);
}

namespace {

/// The corners of the micro-triangle that contains a point, and the point's weights there.
struct Corners {
  std::array<MapValue, 3> values;
  std::array<double, 3> weights;
};

Corners corners_at(std::span<const MapValue> map, unsigned level, double u, double v) {
  const std::uint32_t n = std::uint32_t{1} << level;
  const double x = std::clamp(u, 0.0, 1.0) * n, y = std::clamp(v, 0.0, 1.0) * n;
  std::uint32_t i = std::min(static_cast<std::uint32_t>(x), n - 1),
                j = std::min(static_cast<std::uint32_t>(y), n - 1);
  // i + j > n - 1 only on the edge opposite the first corner; the square is then the one before.
  if (i + j > n - 1) (i > 0 ? i : j) -= 1;
  const double fu = x - i, fv = y - j;
  const auto at = [&map](std::uint32_t a, std::uint32_t b) { return map[(a + b) * (a + b + 1) / 2 + b]; };
  if (fu + fv <= 1 || i + j == n - 1)
    return {{at(i, j), at(i + 1, j), at(i, j + 1)}, {std::max(0.0, 1 - fu - fv), fu, fv}};
  return {{at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)}, {fu + fv - 1, 1 - fu, 1 - fv}};
}

CodeMeaning::Mean mean_of(const Corners& corners, const CodeMeaning& meaning) {
  CodeMeaning::Mean mean{};
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const CodeMeaning::Mean one = meaning.mean_of(corners.values[k]);
    for (std::size_t c = 0; c < 3; ++c) mean[c] += corners.weights[k] * one[c];
    sum += corners.weights[k];
  }
  for (double& c : mean) c /= sum;
  return mean;
}

}  // namespace

CodeMeaning::Mean vertex_mean(std::span<const MapValue> map, unsigned level, double u, double v,
                              const CodeMeaning& meaning) {
  return mean_of(corners_at(map, level, u, v), meaning);
}

MapValue vertex_value(std::span<const MapValue> map, unsigned level, double u, double v, MapReading reading,
                      const CodeMeaning& meaning) {
  const Corners corners = corners_at(map, level, u, v);
  const auto& weights = corners.weights;
  if (reading == MapReading::nearest)
    return corners
        .values[static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin())];
  return meaning.code_of(mean_of(corners, meaning));
}

}  // namespace mmverify::scene
