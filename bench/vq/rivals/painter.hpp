// A painter of maps with brushes: greedily, and by mutation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bench/vq/rivals/brushes.hpp"

namespace mmverify::bench::rivals {

/// A set of regions: bit x of row y.
using Rows = std::array<std::uint32_t, 32>;

class Painter {
 public:
  /// Domain: side 16 or 32, and a map of side x side regions.
  Painter(States map, std::uint32_t side);

  /// The greedy painting of Brushes::encode; at most `most` brushes, the first on top.
  std::vector<Brush> greedy(std::uint32_t most) const;
  /// The painting after mutations.  It never keeps fewer regions.
  std::vector<Brush> mutated(const std::vector<Brush>& painting, std::uint32_t most, std::uint32_t tries,
                             std::uint64_t seed) const;

  /// The number of regions whose T or O the painting has; -1 if a region has another state than its own or C.
  std::int64_t kept(const std::vector<Brush>& painting) const;

 private:
  Rows rows_of(const Brush& brush) const;
  const Rows& of(State s) const { return states_[static_cast<std::size_t>(s)]; }
  /// Finds in `best` the brush of its colour that gives most open regions their state, and no open region
  /// another.  Returns the number of those regions.
  std::uint32_t exact_brush(State colour, const Rows& open, Brush& best) const;
  /// The brush of C that covers most of `wanted`, minus the open O and T that it covers.
  Brush checking_brush(const Rows& wanted, const Rows& open) const;
  void cover(const Brush& brush, Rows& open) const;
  /// Adds exact brushes of these colours until there are `most`, or none keeps another region.
  void add_exact(std::span<const State> colours, std::uint32_t most, Rows& open,
                 std::vector<Brush>& painting) const;
  std::int64_t kept_of(const std::vector<Rows>& covered, const std::vector<Brush>& painting) const;

  std::uint32_t side_;
  std::array<Rows, 3> states_{};
  Rows all_{};
};

}  // namespace mmverify::bench::rivals
