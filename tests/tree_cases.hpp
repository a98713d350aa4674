// Maps for the tests of the tree, and the packing that they go through.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "impl/tree/stream.hpp"

namespace mmverify::tests {

using States = std::vector<std::uint8_t>;

inline std::uint32_t width(impl::tree::Format b) { return static_cast<std::uint32_t>(b); }

inline std::uint64_t micro_triangles(impl::tree::Level n) { return std::uint64_t{1} << (2 * n); }

/// Level 2, four states, of the kind of the paper's figure 4:
///   child 0  O O O O     one state: a leaf             0               1
///   child 1  T T T O     mixed                         1 0 0 0 0       0 0 0 1
///   child 2  UT UT UT UT a leaf                        0               2
///   child 3  O UO UO UO  mixed                         1 0 0 0 0       1 3 3 3
/// The root before them is mixed: 1.  So the tree is 1 0 10000 0 10000, 13 nodes, and the states are
/// 1 0 0 0 1 2 1 3 3 3, of 10 leaves: 3 internal nodes, 4*3+1 and 3*3+1.
/// In bytes, the first in the lowest bits: the tree 00000101 00000001; the states, two bits each,
/// 00 00 00 01, 11 01 10 01, 11 11.
inline const States by_hand{1, 1, 1, 1, 0, 0, 0, 1, 2, 2, 2, 2, 1, 3, 3, 3};

/// Packs states, the first in the lowest bits of the first byte.
inline std::vector<std::uint8_t> packed(const States& states, impl::tree::Format b) {
  std::vector<std::uint8_t> map((states.size() * width(b) + 7) / 8);
  for (std::size_t k = 0; k < states.size(); ++k) {
    const std::size_t bit = k * width(b);
    map[bit / 8] = static_cast<std::uint8_t>(map[bit / 8] | states[k] << (bit % 8));
  }
  return map;
}

/// States in runs of 1 to `longest`, so that leaves of every size occur; a run may repeat the state before.
inline States runs(impl::tree::Level n, impl::tree::Format b, std::uint64_t longest, std::uint32_t seed) {
  std::mt19937 random(seed);
  States states;
  while (states.size() < micro_triangles(n)) {
    const auto state = static_cast<std::uint8_t>(random() & (width(b) == 1 ? 1u : 3u));
    for (std::uint64_t left = 1 + random() % longest; left > 0 && states.size() < micro_triangles(n); --left)
      states.push_back(state);
  }
  return states;
}

/// Mixed seeds and run lengths for a level: from single states to the whole map.
inline std::vector<States> assorted(impl::tree::Level n, impl::tree::Format b, std::uint32_t count) {
  std::vector<States> all{States(micro_triangles(n), 0), States(micro_triangles(n), width(b) == 1 ? 1 : 3)};
  for (std::uint32_t seed = 0; seed < count; ++seed)
    all.push_back(runs(n, b, std::uint64_t{1} << (seed % (2 * n + 1)), 100 * n + seed));
  return all;
}

}  // namespace mmverify::tests
