// Pictures of single maps: bits of the tree that are read, triangles over a texture, square maps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bench/papers/measured.hpp"
#include "bench/textures/alpha_textures.hpp"
#include "display/render/picture.hpp"
#include "impl/tree/stream.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::bench::papers {

/// A number for each pixel, rows from the top; 0 if nothing is there.
struct PixelNumbers {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint32_t> of = {};

  /// The greatest one that at least 1 pixel in 1000 of those above 0 reaches; at least 1.
  std::uint32_t most() const;
  /// The mean of those above 0; 0 without any.
  double mean() const;
};

/// The bits of a tree that Algorithm 3 reads for each index, bits 0 to that of the leaf, as stream_reads() counts them one
/// by one.  Time: linear in the tree and in 4^level.
/// Domain: a stream of encode_stream() of this level.
std::vector<std::uint32_t> bits_read_by_index(unsigned level, const impl::tree::Stream& tree);

/// The bits of the tree that Algorithm 3 reads at each pixel of a texture, from 2-state maps of the triangles on a
/// surface.  A triangle is moved by whole repeats, so that its centroid lies in the texture.
/// Source: Succinct Opacity Micromaps, figure 9.  Domain: a surface of the scene's plan.
PixelNumbers bits_read(Measured& measured, const PlannedScene& of, std::uint32_t surface, unsigned level);

/// The number of distinct planned triangles over each texel of a surface's texture, every repeat counted.
/// Source: Succinct Opacity Micromaps, figure 11.  Domain: as above.
PixelNumbers triangles_over(const PlannedScene& of, std::uint32_t surface);

/// Colours from dark blue (1) to red (`most` or more); white for 0.
render::Picture coloured(const PixelNumbers& numbers, std::uint32_t most);

/// The alpha of a surface's texture, and the edges of all its triangles, each pixel `times` times as large.
render::Picture edges_on_texture(const PlannedScene& of, std::uint32_t surface, std::uint32_t times);

/// Each pixel `times` times as large.
render::Picture enlarged(const render::Picture& picture, std::uint32_t times);

/// The alpha of a texture's opaque box, `side` pixels wide and high, by the nearest texel.
render::Picture alpha_picture(const AlphaTexture& texture, std::uint32_t side);

/// A square map, `cell` pixels a region, y from the bottom: T blue, C orange, O green; red where `decoded` has C in the
/// place of T or O.  Uniform vectors of 2x2 are white if `vectors_alone`.
/// Domain: side^2 states in both.
render::Picture square_picture(std::span<const impl::vq::State> map, std::span<const impl::vq::State> decoded,
                               std::uint32_t side, std::uint32_t cell, bool vectors_alone = false);

}  // namespace mmverify::bench::papers
