// Which sides of the cutoff have been seen.  Internal to impl/bake.
#pragma once

#include <cstdint>

namespace mmverify::impl::bake::detail {

/// What has been seen of a region: some alpha below the cutoff, some not.
using Marks = std::uint8_t;
inline constexpr Marks below = 1, opaque = 2, both = 3;

}  // namespace mmverify::impl::bake::detail
