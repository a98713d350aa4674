// Marks: the sides of the cutoff on which alpha has been seen.  Internal to impl/bake.
#pragma once

#include <cstdint>

namespace mmverify::impl::bake::detail {

/// A mark says that some alpha of a region is below the cutoff, or that some is not.
using Marks = std::uint8_t;
inline constexpr Marks below = 1, opaque = 2, both = 3;

}  // namespace mmverify::impl::bake::detail
