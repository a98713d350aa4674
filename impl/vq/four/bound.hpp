// What a codebook of VQ4 keeps at most under one choice of transforms.  Internal to impl/vq.
//
// A block keeps, of source i, max |e| over the entries e that are subsets of it.  For any prices p >= 0 that
// is at most p_i, plus (|e| - p_i)+ of the one entry e that it takes.  Of an entry, let S be what the sources
// that take it and pay (|e| > p_i) have in common: S holds e, so each pays no less for S.  Entries with one
// and the same S share sources none of which is counted twice, so distinct S will do, and 13 entries keep
//   at most sum of p_i + the 13 greatest worth(S), worth(S) = sum over the sources around S of (|S| - p_i)+
// over the distinct S that are intersections of sources, each with |S| > p_i.
// Prices come from a subgradient descent over a pool of sets.  That no other S is worth more than the 13th of
// the pool is then shown by branch and bound over intersections: a subset of a set e is worth no more than
// the sum of (|e & s_i| - p_i)+ over all sources.  Prices are whole 64ths, so nothing is rounded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "impl/vq/four/sets.hpp"

namespace mmverify::impl::vq::detail {

/// As they stand in the codebook, O beside T included; behind the last one empty sets.
struct Bounded4 {
  Vectors4 v{};
  std::array<std::int32_t, 64> most{};   ///< regions that any code can keep of each
  std::array<std::int32_t, 64> price{};  ///< to begin with, and then the best found; 64ths of a region
};

struct BoundLimits {
  std::uint32_t enough = 0;  ///< looks no further once the bound is this or less
  /// A round of branch and bound, chosen by hand; the rest is bounded as it stands.
  std::uint32_t nodes = 200'000;
};

/// At least the regions that any 13 entries keep, whatever the limits.
/// entries: some good ones to begin with, and then those that the prices prefer.
std::uint32_t most_kept(Bounded4& sources, std::vector<Set4>& entries, const BoundLimits& limits = {});

}  // namespace mmverify::impl::vq::detail
