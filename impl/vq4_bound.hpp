// What a codebook of VQ4 keeps at most under one choice of transforms.  Internal to impl/vq*.
//
// A block keeps, of source i, max |e| over the entries e that are subsets of it.  For any prices p >= 0 that
// is at most p_i plus the sum over such e of (|e| - p_i)+, so 13 entries keep
//   at most  sum of p_i + the 13 greatest worth(e),   worth(e) = sum over the sources around e of (|e| -
//   p_i)+.
// Prices come from a subgradient descent over a pool of entries.  That no other entry is worth more than the
// 13th of the pool is then shown by branch and bound: a subset of a set e is worth no more than the sum of
// (|e & s_i| - p_i)+ over all sources.  Prices are whole 64ths, so nothing is rounded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "impl/vq4_sets.hpp"

namespace mmverify::impl::vq::detail {

/// As they stand in the codebook, O beside T included; behind the last one empty sets.
struct Bounded4 {
  Vectors4 v{};
  std::array<std::int32_t, 64> most{};   ///< regions that any code can keep of each
  std::array<std::int32_t, 64> price{};  ///< to begin with, and then the best found; 64ths of a region
};

/// At least the regions that any 13 entries keep; looks no further once that is `enough` or less.
/// entries: some good ones to begin with, and then those that the prices prefer.
std::uint32_t most_kept(Bounded4& sources, std::vector<Set4>& entries, std::uint32_t enough);

}  // namespace mmverify::impl::vq::detail
