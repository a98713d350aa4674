// Bakers as they are usually written: by samples, and by rasterising in binary64.  Bilinear, 8 bits, the
// texture repeated.
#pragma once

#include <cstdint>
#include <span>

#include "impl/bake/triangles.hpp"

namespace mmverify::bench {

/// The texture and cutoff that the obvious bakers get.
struct BakeTexture {
  const impl::bake::AlphaView& view;
  double cutoff;
};

/// An obvious baker.  It writes a state a byte, T 0, O 1, UT 2, UO 3, in the order of the index.
/// Domain: sizes of all coordinates below 2^20; states.size() = 4^level.
using BakeInto = void (*)(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t level,
                          std::span<std::uint8_t> states);

/// Writes O or T by alpha at the centroid.
void bake_centre(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t, std::span<std::uint8_t>);
/// Writes O or T if all three corners agree, else unknown.
void bake_corners(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t,
                  std::span<std::uint8_t>);
/// Writes O or T if the centroids of the 16 parts agree, else unknown.
void bake_sixteen(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t,
                  std::span<std::uint8_t>);
/// Clips the micro-triangle cell by cell, and takes alpha's extremes on each part: the specification's way,
/// rounded.
void bake_rasterised(const BakeTexture&, const impl::bake::BaseTriangle&, std::uint32_t,
                     std::span<std::uint8_t>);

}  // namespace mmverify::bench
