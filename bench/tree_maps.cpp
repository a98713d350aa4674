#include "bench/tree_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "impl/index.hpp"

namespace mmverify::bench {
namespace {

using impl::tree::Bits;
using impl::tree::Level;

struct Place {
  double x, y;
};

double distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Below zero on a leaf; nowhere steeper than `slope`.
class Leaves {
 public:
  explicit Leaves(std::uint64_t seed) {
    std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                        0x6c656166u};
    std::mt19937_64 random(words);
    // The standard's distributions differ from library to library; the engine does not.
    const auto unit = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    constexpr double turn = 6.283185307179586;
    const std::size_t count = 20 + static_cast<std::size_t>(random() % 80);
    for (std::size_t k = 0; k < count; ++k) {
      const double length = 0.05 + 0.25 * unit(), breadth = length * (0.2 + 0.3 * unit()),
                   angle = turn * unit();
      // Two circles that meet in the tips: radius r, centres r - breadth/2 to either side of the midrib.
      const double r = (length * length + breadth * breadth) / (4 * breadth), off = r - breadth / 2;
      const Place middle{unit(), unit()};
      const Place across{-std::sin(angle), std::cos(angle)};
      leaves_.push_back({{middle.x + off * across.x, middle.y + off * across.y},
                         {middle.x - off * across.x, middle.y - off * across.y},
                         r});
    }
    for (Wave& wave : serration_) {
      const double frequency = turn * (8 + 40 * unit()), angle = turn * unit();
      wave = {frequency * std::cos(angle), frequency * std::sin(angle), turn * unit(), 0.3 / frequency};
      slope_ += 0.3;
    }
  }

  /// Which leaves may be the nearest somewhere; for a start all of them.
  using Near = std::vector<std::uint32_t>;
  Near all() const {
    Near all(leaves_.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  /// Of those, the ones that may be the nearest within `radius` of p: no distance is steeper than 1.
  Near near(const Near& among, const Place& p, double radius) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t k : among) least = std::min(least, lens(k, p));
    Near nearest;
    for (const std::uint32_t k : among)
      if (lens(k, p) <= least + 2 * radius) nearest.push_back(k);
    return nearest;
  }

  double operator()(const Near& among, const Place& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t k : among) least = std::min(least, lens(k, p));
    for (const Wave& wave : serration_)
      least += wave.height * std::sin(wave.x * p.x + wave.y * p.y + wave.phase);
    return least;
  }
  double slope() const { return slope_; }

 private:
  struct Lens {
    Place one, other;
    double radius;
  };
  struct Wave {
    double x, y, phase, height;
  };
  double lens(std::uint32_t k, const Place& p) const {
    const Lens& leaf = leaves_[k];
    return std::max(distance(p, leaf.one), distance(p, leaf.other)) - leaf.radius;
  }

  std::vector<Lens> leaves_;
  std::array<Wave, 4> serration_;
  double slope_ = 1;
};

struct Painter {
  const Leaves& leaves;
  Level n;
  std::uint32_t b;
  std::vector<std::uint8_t>& map;

  void put(std::uint64_t k, std::uint32_t state) {
    const std::uint64_t bit = k * b;
    map[bit / 8] = static_cast<std::uint8_t>(map[bit / 8] | state << (bit % 8));
  }

  void node(Level d, std::uint32_t k, const Leaves::Near& above) {
    const double side = std::ldexp(1.0, -static_cast<int>(d));
    std::array<Place, 3> corner{};
    Place centre{0, 0};
    const impl::index::Corners on_grid = impl::index::corners(k, d);
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = {on_grid[c].i * side, on_grid[c].j * side};
      centre.x += corner[c].x / 3;
      centre.y += corner[c].y / 3;
    }
    // No corner is farther than sqrt(5)/3 sides from the centre.
    const double radius = 0.7454 * side;
    const Leaves::Near near = leaves.near(above, centre, radius);
    const double at_centre = leaves(near, centre);
    const std::uint32_t state = at_centre < 0;
    const bool one_side = std::abs(at_centre) > leaves.slope() * radius;
    if (one_side) {
      const std::uint64_t run = std::uint64_t{1} << (2 * (n - d));
      if (state == 0) return;
      if (run * b < 8)
        for (std::uint64_t j = 0; j < run; ++j) put(k * run + j, 1);
      else
        std::fill_n(map.begin() + static_cast<std::ptrdiff_t>(k * run * b / 8), run * b / 8,
                    static_cast<std::uint8_t>(b == 1 ? 0xff : 0x55));
      return;
    }
    if (d < n) {
      for (std::uint32_t c = 0; c < 4; ++c) node(d + 1, 4 * k + c, near);
      return;
    }
    bool crossed = false;
    if (b == 2)
      for (const Place& p : corner) crossed = crossed || (leaves(near, p) < 0) != (state != 0);
    put(k, state + (crossed ? 2 : 0));
  }
};

}  // namespace

std::vector<std::uint8_t> leaf_map(Level level, Bits bits, std::uint64_t seed) {
  const Leaves leaves(seed);
  const auto b = static_cast<std::uint32_t>(bits);
  std::vector<std::uint8_t> map(static_cast<std::size_t>(((std::uint64_t{b} << (2 * level)) + 7) / 8));
  Painter{leaves, level, b, map}.node(0, 0, leaves.all());
  return map;
}

}  // namespace mmverify::bench
