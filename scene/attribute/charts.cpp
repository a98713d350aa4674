#include "scene/attribute/charts.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>

namespace mmverify::scene {
namespace {

/// A partition of the numbers 0..count-1 (union-find).
class Parts {
 public:
  explicit Parts(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t root(std::uint32_t k) {
    for (; parent_[k] != k; k = parent_[k]) parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Calls visit(neighbour) for each of up to eight neighbours.
template <class Visit>
void for_each_neighbour(std::size_t texel, std::uint32_t width, std::uint32_t height, Visit visit) {
  const std::size_t x = texel % width, y = texel / width;
  for (std::size_t j = y == 0 ? 0 : y - 1; j <= std::min<std::size_t>(y + 1, height - 1); ++j)
    for (std::size_t i = x == 0 ? 0 : x - 1; i <= std::min<std::size_t>(x + 1, width - 1); ++i)
      if (i != x || j != y) visit(i + j * width);
}

}  // namespace

std::vector<std::uint32_t> charts_of(std::span<const UvTriangle> triangles) {
  using Point = std::pair<float, float>;
  const auto point = [](const Uv& uv) { return Point(uv[0] + 0.0f, uv[1] + 0.0f); };  // -0 is 0
  Parts parts(triangles.size());
  std::map<std::pair<Point, Point>, std::uint32_t> edges;
  for (std::uint32_t k = 0; k < triangles.size(); ++k)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto [a, b] = std::minmax({point(triangles[k][corner]), point(triangles[k][(corner + 1) % 3])});
      const auto [known, is_new] = edges.try_emplace({a, b}, k);
      if (!is_new) parts.join(k, known->second);
    }
  std::map<std::uint32_t, std::uint32_t> numbers;
  std::vector<std::uint32_t> charts;
  for (std::uint32_t k = 0; k < triangles.size(); ++k)
    charts.push_back(
        numbers.try_emplace(parts.root(k), static_cast<std::uint32_t>(numbers.size())).first->second);
  return charts;
}

std::vector<std::uint8_t> bands_of(std::span<const std::uint32_t> charts, std::uint32_t width,
                                   std::uint32_t height, unsigned last) {
  std::vector<std::uint8_t> bands(charts.size(), no_band);
  std::vector<std::size_t> front;
  for (std::size_t texel = 0; texel < charts.size(); ++texel) {
    if (charts[texel] == no_chart) continue;
    bands[texel] = static_cast<std::uint8_t>(last + 1);
    bool at_border = false;
    for_each_neighbour(texel, width, height,
                       [&](std::size_t other) { at_border = at_border || charts[other] != charts[texel]; });
    if (at_border) front.push_back(texel);
  }
  // A texel whose neighbours are all of its chart is one farther from the border than the nearest of them.
  std::vector<bool> reached(charts.size());
  for (const std::size_t texel : front) reached[texel] = true;
  for (std::uint32_t distance = 1; distance <= std::uint32_t{1} << last && !front.empty(); ++distance) {
    std::vector<std::size_t> next;
    for (const std::size_t texel : front) {
      bands[texel] = static_cast<std::uint8_t>(std::bit_width(distance - 1));
      for_each_neighbour(texel, width, height, [&](std::size_t other) {
        if (charts[other] == no_chart || reached[other]) return;
        reached[other] = true;
        next.push_back(other);
      });
    }
    front = std::move(next);
  }
  return bands;
}

}  // namespace mmverify::scene
