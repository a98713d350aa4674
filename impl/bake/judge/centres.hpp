// The marks of the texel centres within a triangle, several rows at a time.  Internal to impl/bake.
#pragma once

#include <cstddef>
#include <cstdint>

#include "impl/bake/marks.hpp"
#include "impl/bake/plane/points.hpp"

namespace mmverify::impl::bake::detail {

/// Bits of a window of texels, in the strips of planes (impl/bake/texture/plane.hpp).
struct WindowBits {
  /// Row 0 of the strip of column 0, which is at `bit` of its word.  visible is opaque with MASK.
  const std::uint32_t *opaque, *visible;
  std::size_t strip;
  std::uint32_t bit;
  std::int64_t left, top;      ///< the window's first texel
  std::int32_t columns;        ///< texels in a row of it
};

/// The marks of the texels whose centres, at whole numbers, are in p, until all `wanted` marks are found.
/// On row j a centre counts from ceil(x) to floor(x') of the two crossings of p's edges.  A crossing is off by less than
/// 2^-51 of the greatest coordinate: by two roundings of a slope and one of its product, 2^-53 each of an edge's extent
/// along x, since no edge is evaluated beyond its ends, and by one of the sum.
/// Domain: the window holds all centres in p; a plane has 8 rows beyond it.
/// Test: impl_bake_cells_test
Marks centres_within(const Triangle& p, const WindowBits& bits, Marks wanted);

}  // namespace mmverify::impl::bake::detail
