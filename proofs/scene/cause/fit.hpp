// How well stored maps fit expected ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "impl/micromap/micromap.hpp"
#include "scene/bake/bake.hpp"

namespace mmverify::proofs::scene {

/// The states of one map, by index.
using States = std::vector<impl::micromap::State>;

/// The states of a map as it is stored.
States states_of(const mmverify::scene::BakedTriangle& map);

/// Counts of micro-triangles.
struct Fit {
  std::uint64_t wrong = 0;     ///< known, and not as expected
  std::uint64_t needless = 0;  ///< unknown, and expected to be known
  std::uint64_t side = 0;      ///< unknown on the other side
  std::uint64_t equal = 0;     ///< known as expected
  std::uint64_t same = 0;      ///< unknown as expected, on the same side

  Fit& operator+=(const Fit& more);
  /// The lesser is the better.
  friend auto operator<=>(const Fit& a, const Fit& b) {
    if (const auto order = a.wrong <=> b.wrong; order != 0) return order;
    if (const auto order = a.needless <=> b.needless; order != 0) return order;
    return a.side <=> b.side;
  }
  friend bool operator==(const Fit& a, const Fit& b) { return (a <=> b) == 0; }
  /// States that speak for the expected map: the known ones; if every state is as expected, the unknown ones, too.
  std::uint64_t evidence() const { return wrong + needless + side == 0 ? equal + same : equal; }
  std::uint64_t unknown() const { return needless + side + same; }
  /// Whether the map may be shown: no known state is wrong, and fewer are needlessly unknown than known.
  bool is_right() const { return wrong == 0 && needless <= equal / 4; }
};

/// Domain: spans of one size.
Fit fit(std::span<const impl::micromap::State> stored, std::span<const impl::micromap::State> expected);

}  // namespace mmverify::proofs::scene
