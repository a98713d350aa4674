// A bound on the regions that a codebook of VQ4 keeps under one choice of transforms.  Internal to impl/vq.
//
// A block keeps, for source i, max |e| over the entries e that are subsets of it.  For any prices p >= 0 that is at
// most p_i, plus (|e| - p_i)+ for the one entry e that it takes.  For an entry, let S be the intersection of the
// sources that take it and pay (|e| > p_i): S contains e, so each pays no less for S.  Entries with the same S share
// sources, none of which is counted twice, so distinct S suffice, and 13 entries keep
//   at most sum of p_i + the 13 greatest worth(S), worth(S) = sum over the sources around S of (|S| - p_i)+
// over the distinct S that are intersections of sources, each with |S| > p_i.
// Prices come from a subgradient descent over a pool of sets.  Branch and bound over intersections then shows that no
// other S is worth more than the 13th of the pool: a subset of a set e is worth no more than the sum of (|e & s_i| -
// p_i)+ over all sources.  Prices are whole 64ths, so nothing is rounded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "impl/vq/four/sets.hpp"

namespace mmverify::impl::vq::detail {

/// The sources as stored in the codebook, with O beside T; behind the last one come empty sets.
struct Bounded4 {
  Vectors4 v{};
  std::array<std::int32_t, 64> most{};   ///< regions of each that any code can keep
  std::array<std::int32_t, 64> price{};  ///< start prices, then the best found; 64ths of a region
};

struct BoundLimits {
  std::uint32_t enough = 0;  ///< the search ends at a bound of this or less
  /// Nodes of one round of branch and bound, chosen by hand; the sets left open enter the bound as they are.
  std::uint32_t nodes = 200'000;
};

/// A bound, whatever the limits, on the regions that any 13 entries keep.
/// entries: some good ones to begin with; then those that the best prices prefer.
std::uint32_t most_kept(Bounded4& sources, std::vector<Set4>& entries, const BoundLimits& limits = {});

}  // namespace mmverify::impl::vq::detail
