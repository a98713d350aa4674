#include "bench/textures/leaves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace mmverify::bench {
namespace {

double distance(const LeafPoint& a, const LeafPoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

Leaves::Leaves(std::uint64_t seed, std::uint32_t least, std::uint32_t most) {
  std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), 0x6c656166u};
  std::mt19937_64 random(words);
  // The standard's distributions differ from library to library; the engine does not.
  const auto unit = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  constexpr double turn = 6.283185307179586;
  const std::size_t count = least + static_cast<std::size_t>(random() % (most - least + 1));
  for (std::size_t k = 0; k < count; ++k) {
    const double length = 0.05 + 0.25 * unit(), breadth = length * (0.2 + 0.3 * unit()),
                 angle = turn * unit();
    // Two circles that meet in the tips: radius r, centres r - breadth/2 to either side of the midrib.
    const double r = (length * length + breadth * breadth) / (4 * breadth), off = r - breadth / 2;
    const LeafPoint middle{unit(), unit()};
    const LeafPoint across{-std::sin(angle), std::cos(angle)};
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

Leaves::Near Leaves::all() const {
  Near all(leaves_.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

Leaves::Near Leaves::near(const Near& among, const LeafPoint& p, double radius) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t k : among) least = std::min(least, lens(k, p));
  Near nearest;
  for (const std::uint32_t k : among)
    if (lens(k, p) <= least + 2 * radius) nearest.push_back(k);
  return nearest;
}

double Leaves::operator()(const Near& among, const LeafPoint& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t k : among) least = std::min(least, lens(k, p));
  for (const Wave& wave : serration_)
    least += wave.height * std::sin(wave.x * p.x + wave.y * p.y + wave.phase);
  return least;
}

double Leaves::lens(std::uint32_t k, const LeafPoint& p) const {
  const Lens& leaf = leaves_[k];
  return std::max(distance(p, leaf.one), distance(p, leaf.other)) - leaf.radius;
}

}  // namespace mmverify::bench
