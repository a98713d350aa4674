// Bakers as they are written most often: by samples, and by rasterising in binary64.  Bilinear, 8 bits, the
// texture repeated.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "impl/bake/triangles.hpp"

namespace mmverify::bench {

/// What they know of a texture.
struct BakeTexture {
  const impl::bake::AlphaView& view;
  double cutoff;
};

/// States, a byte each, T 0, O 1, UT 2, UO 3, in the order of the index.
/// Domain: sizes of all coordinates below 2^20; states.size() = 4^level.
using BakeInto = void (*)(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t level,
                          std::span<std::uint8_t> states);

/// O or T as alpha at the centroid is.
void bake_centre(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t, std::span<std::uint8_t>);
/// O or T where all three corners are.
void bake_corners(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t,
                  std::span<std::uint8_t>);
/// O or T where the centroids of its 16 parts all are.
void bake_sixteen(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t,
                  std::span<std::uint8_t>);
/// Cell by cell the micro-triangle's part, and alpha's extremes on that: the specification's way, rounded.
void bake_rasterised(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t,
                     std::span<std::uint8_t>);

}  // namespace mmverify::bench
