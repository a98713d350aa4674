// Opacity micromaps of alpha-tested and blended triangles: the exact state of every micro-triangle, for any
// texture coordinates.
//
// A closed micro-triangle, dilated by the margin, is O if alpha is opaque on all of it, T if alpha is transparent on
// all of it, in every mip level; else UO if alpha at its centroid in the first mip level is rather opaque, UT if not.
//   MASK    opaque alpha >= cutoff, transparent alpha < cutoff, rather opaque alpha >= cutoff
//   BLEND   opaque alpha >= 1,      transparent alpha <= 0,     rather opaque alpha >= 1/2
//   alpha = sampled texture x factors, sampled bilinearly or nearest
//
// Source: spec/bake/state.hpp, micro_state.  How: a contour runs only through cells whose four texels differ; bitmaps
// find these cells.  Where a contour may meet an edge of a micro-triangle, floats with an error bound decide, or else
// whole numbers wide enough to be exact.  A node that meets no such cell is not subdivided.  2-state maps:
// impl/micromap/micromap.hpp, force2.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "impl/bake/bake.hpp"
#include "impl/bake/blocks/blocks.hpp"
#include "impl/bake/texture/wrap.hpp"

namespace mmverify::impl::bake {

/// A vertex's texture coordinates: (0, 0) and (1, 1) are outer corners of the first and the last texel.
struct TexturePoint {
  float u, v;
};
using BaseTriangle = std::array<TexturePoint, 3>;

/// A triangle whose vertices move: u of vertex k stays within `across` of middle[k].u, v within `down` of middle[k].v,
/// each vertex on its own.  A point of the triangle is a mean of its vertices, so it moves no farther.
/// Source: Succinct Opacity Micromaps, 3.1.1, "maximum deformation".
struct MovingTriangle {
  BaseTriangle middle;
  float across = 0, down = 0;
};

inline constexpr std::uint32_t max_bake_level = 12;

/// The wrap mode of coordinates outside [0, 1), along each axis.
struct Addressing {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
  std::uint8_t border = 0;  ///< alpha outside, with clamp_to_border
};

/// The filter of a texture.  nearest: texel (i, j) owns [i, i+1) x [j, j+1), before wrapping.
enum class Filter : std::uint8_t { bilinear, nearest };

/// MASK: alpha >= cutoff is opaque.
struct Mask {
  float cutoff = 0.5f;
};
struct Blend {};
/// The alpha mode of a material; Cutoff is MASK at a quotient.
using AlphaMode = std::variant<Mask, Cutoff, Blend>;

/// The texels of one mip level.
using Texels = std::variant<TexelView<std::uint8_t>, TexelView<std::uint16_t>, TexelView<float>>;

/// The sampling and scaling of alpha.
struct Sampling {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
  Filter filter = Filter::bilinear;
  float border = 0;  ///< stored number: a whole number up to 255 or 65535, or any finite one
  /// Alpha is multiplied by both: the material's factor and the one that all vertices have.  Not below 0.
  std::array<float, 2> factors{1, 1};
  /// Micro-triangles are dilated by this many texels (of each mip level) along both axes, exactly.
  float margin = 0;
};

/// The counts of one bake.
struct BakeCounts {
  std::uint64_t micro_triangles = 0;
  std::uint64_t leaves = 0;  ///< micro-triangles not decided by a parent, in all mip levels
  std::uint64_t exact = 0;   ///< leaves that took whole numbers
};

namespace detail {
class MipBaker;
struct Node;
}  // namespace detail

/// A texture made ready for any number of triangles.  Many threads may use one at once.
class TriangleBaker {
 public:
  /// Mip levels come in the order in which they are sampled, the largest first.
  /// Time and memory: a little more than two bits for each texel, twice that with BLEND, spent once.  The texels must
  /// outlive the baker.
  /// Errors: std::invalid_argument, which names the fault: no mip level; a texture without texels, with more than 16384
  /// a side, or larger than memory can be; a texel, border, cutoff, factor or margin that is not finite; a border that
  /// no texel can store; a factor or margin below 0; a margin of 2^20 or more.
  /// Test: impl_bake_errors_test
  TriangleBaker(std::span<const Texels> mips, const AlphaMode& mode, const Sampling& sampling = {});
  /// A baker of one channel of interleaved pixels, which it copies: a byte a texel.  The pixels need not outlive it.
  /// Errors: as above; and channels, a channel or a pitch outside the domain of PixelView.
  /// Test: impl_bake_engine_test
  TriangleBaker(std::span<const PixelView> mips, const AlphaMode& mode, const Sampling& sampling = {});
  /// A baker of blocks, BC1 to BC4 or BC7, whose alpha it decodes: two bytes a texel.  The blocks need not outlive it.  A
  /// border is of 65535.
  /// Errors: as above, and those of alpha_of(BlockView).
  /// Test: impl_blocks_test
  TriangleBaker(std::span<const BlockView> mips, const AlphaMode& mode, const Sampling& sampling = {});
  /// A baker for 8 bits, MASK, bilinear.
  /// Test: impl_bake_errors_test
  TriangleBaker(const AlphaView& texture, Cutoff cutoff, const Addressing& addressing = {});
  ~TriangleBaker();
  TriangleBaker(TriangleBaker&&) noexcept;
  TriangleBaker& operator=(TriangleBaker&&) noexcept;

  /// Bakes the 4-state map, packed (impl/micromap/micromap.hpp), in the order of impl/index/index.hpp.
  /// Domain: finite coordinates below 2^20 in size, in either orientation; a triangle may be a segment or a point;
  /// level in 0..max_bake_level; map.size() = ceil(4^level / 4).
  /// Time: linear in the micro-triangles that meet both opaque and other texels.  At worst one of these visits each
  /// texel of the texture, and each repeat that its edges cross before their texels repeat.  Texels and rows that
  /// addressing makes equal are visited once, however far they go.
  /// Memory: none is allocated with one mip level.  With several, the map of each but the first goes to `room`, of
  /// map.size() bytes; an empty room is allocated.
  /// Errors: std::invalid_argument outside the domain; nothing is written.
  /// Law: bake.conservative, bake.tight, bake.unknown_side, bake.equals_spec
  BakeCounts bake(const BaseTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map,
                  std::span<std::uint8_t> room = {}) const;

  /// Bakes one map for all positions of a moving triangle: O or T holds in each of them.
  ///   micro-triangle of the middle + [-across width, across width] x [-down height, down height] is O or T, as a
  ///   dilated one is; else UO or UT, as the middle's centroid tells
  /// All vertices moved alike by all of the range: the union of positions is that sum, and no state is needlessly
  /// unknown.  With a margin, the two dilations' sum is rounded up to binary64.
  /// Domain: as bake(); across and down are finite, from 0 and below 2^20.
  /// Errors: as bake().
  /// Law: bake.moving, bake.moving_positions
  BakeCounts bake_moving(const MovingTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map,
                         std::span<std::uint8_t> room = {}) const;

  /// Bakes again what a change of texels may have changed.  This baker was made from the changed texture; `map` is
  /// bake_moving()'s of the texture before, and becomes bake_moving()'s of this one, bit for bit.
  /// changed[k] holds every texel of mip level k that differs; an empty box: none does.  The border, factors and cutoff
  /// are those of before.
  /// Time: as bake() on the nodes of 16 micro-triangles whose texels may have changed.
  /// Domain: as bake_moving(); a box for each mip level, within it.  micro_triangles counts those baked again.
  /// Errors: std::invalid_argument outside the domain; nothing is written.
  /// Law: bake.update
  BakeCounts rebake(const MovingTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map,
                    std::span<const Box> changed, std::span<std::uint8_t> room = {}) const;

 private:
  BakeCounts bake_all(const MovingTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map,
                      std::span<std::uint8_t> room, const std::vector<detail::Node>* only) const;
  void prepare(std::span<const Texels> mips, const AlphaMode& mode, const Sampling& sampling);

  std::vector<std::vector<std::uint8_t>> channels_;  ///< copies of interleaved pixels, by mip level
  std::vector<std::vector<std::uint16_t>> decoded_;  ///< the alpha of blocks, by mip level
  std::vector<std::unique_ptr<const detail::MipBaker>> mips_;
};

}  // namespace mmverify::impl::bake
