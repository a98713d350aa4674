// The search for a codebook of VQ4 under one choice of transforms.  Internal to impl/vq.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "impl/vq/four/sets.hpp"

namespace mmverify::impl::vq::detail {

/// The vectors that are not uniform, codable, as they stand in the codebook; behind the last one empty sets,
/// of which nothing can be kept.
struct Sources4 {
  Vectors4 v{};
  std::uint32_t count = 0;
};

struct Codebook4 {
  std::vector<Set4> entries;  ///< at most 13
  std::uint32_t kept = 0;     ///< regions of the sources, each by the entry that keeps most of it
};

/// Beginning with an entry for every distinct source, the two entries whose intersection costs least are made
/// one, or an entry is dropped, until 13 are left; then each is grown to what its users have in common.
/// O(n^2) in the distinct sources.
Codebook4 merged(const Sources4& sources);

/// Each entry is grown as above.  Then one is exchanged for another while that keeps more: for a source, what
/// two sources have in common, or what an entry and a source have.  The best exchange first, and growth after
/// each.
void exchange(const Sources4& sources, Codebook4& codebook);

}  // namespace mmverify::impl::vq::detail
