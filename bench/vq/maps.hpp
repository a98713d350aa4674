// Opacity maps of alpha textures, read or generated from a seed: exact coverage at alpha >= 1/2 of the
// textures cut down to their opaque boxes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/textures/alpha_textures.hpp"
#include "impl/bake/bake.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::bench {

/// A point of the map's square, y from the bottom, and whether the texture is opaque there: bilinear alpha >= 1/2.
struct SampledHit {
  float u, v;
  bool opaque;
};

/// The maps of one texture, as if it covered a pair of triangles: square maps, region (x, y) at x + side y
/// with y from the bottom, and other maps of the same memory.
struct OpacityMaps {
  std::string of;                                        ///< the texture's file
  std::array<impl::vq::State, 64> regions_8{};           ///< 128 bits at 2 a region
  impl::vq::Map2 regions_16{};                           ///< 512 bits, or 256 of VQ2
  impl::vq::Map4 regions_32{};                           ///< 2048 bits, or 512 of VQ4
  std::array<impl::vq::State, 128> sub_triangles_64x2{}; /**< 256 bits: both triangles at level 3, the halves
                                                              of an 8x8 map (impl/bake/square/map.hpp) */
  std::vector<SampledHit> hits;  ///< 4096, evenly over the square, the same at every run
};

/// The smallest rectangle of texels that contains all with alpha >= 1/2, cut out: beyond its edge the edge is
/// sampled, as in papers that crop their pictures.  None if the texture has no such texel.  It points into
/// the texture.
/// Domain: width, height in 1..16384.
std::optional<impl::bake::AlphaView> opaque_part(const AlphaTexture& texture);

/// The maps of each texture that has an opaque part, in order.
std::vector<OpacityMaps> opacity_maps(const std::vector<AlphaTexture>& textures);

/// The maps of the leaf textures seed, seed + 1, ...
std::vector<OpacityMaps> leaf_opacity_maps(std::size_t count, std::uint64_t seed);

/// The share of O and T: hits that do not read the texture, if they fall evenly.
/// Source: Compressed Opacity Maps, 1 ("savings") and figures 6, 7, 10.  Domain: not empty.
double savings(std::span<const impl::vq::State> states);

}  // namespace mmverify::bench
