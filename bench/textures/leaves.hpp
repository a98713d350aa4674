// A distance field of overlapping leaves, generated from a seed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mmverify::bench {

struct LeafPoint {
  double x, y;
};

/// Leaves of random place in the unit square, turn and size: lens shapes (two circles cut) with serrated
/// outlines.  The distance is below zero on a leaf, and nowhere steeper than slope().
class Leaves {
 public:
  /// The seed gives the number of leaves, from `least` to `most`.  Domain: 1 <= least <= most.
  Leaves(std::uint64_t seed, std::uint32_t least, std::uint32_t most);

  /// Leaves that may be the nearest somewhere; at first all of them.
  using Near = std::vector<std::uint32_t>;
  Near all() const;
  /// The leaves `among` these that may be the nearest within `radius` of p: no distance is steeper than 1.
  Near near(const Near& among, const LeafPoint& p, double radius) const;

  double operator()(const Near& among, const LeafPoint& p) const;
  double slope() const { return slope_; }

 private:
  struct Lens {
    LeafPoint one, other;
    double radius;
  };
  struct Wave {
    double x, y, phase, height;
  };
  double lens(std::uint32_t k, const LeafPoint& p) const;

  std::vector<Lens> leaves_;
  std::array<Wave, 4> serration_;
  double slope_ = 1;
};

}  // namespace mmverify::bench
