// The search for a codebook of VQ4 under one choice of transforms.  Internal to impl/vq.
#pragma once

#include <cstdint>
#include <vector>

#include "impl/vq/four/sets.hpp"

namespace mmverify::impl::vq::detail {

/// The vectors that are not uniform, made codable, as stored in the codebook; behind the last one come empty sets, of
/// which nothing can be kept.
struct Sources4 {
  Vectors4 v{};
  std::uint32_t count = 0;
};

struct Codebook4 {
  std::vector<Set4> entries;  ///< at most 13
  std::uint32_t kept = 0;     ///< regions kept of the sources, each by its best entry
};

/// Begins with an entry for every distinct source.  The two entries whose intersection costs least are made one, or an
/// entry is dropped, until 13 are left; then each is grown to the intersection of its users.  O(n^2) in the distinct
/// sources.
Codebook4 merged(const Sources4& sources);

/// Grows each entry as above.  Then one entry is exchanged for another while that keeps more: for a source, an
/// intersection of two sources, or one of an entry and a source.  The best exchange comes first, and growth after each.
void exchange(const Sources4& sources, Codebook4& codebook);

}  // namespace mmverify::impl::vq::detail
