// Opacity micromaps of alpha-tested and blended triangles: the exact state of every micro-triangle, for any
// texture coordinates.
//
// A closed micro-triangle, dilated by the margin, is O where alpha is opaque on all of it, T where alpha is
// transparent on all of it, in every mip level; else UO where alpha at its centroid in the first mip level is
// rather opaque, and UT where not.
//   MASK    opaque alpha >= cutoff, transparent alpha < cutoff, rather opaque alpha >= cutoff
//   BLEND   opaque alpha >= 1,      transparent alpha <= 0,     rather opaque alpha >= 1/2
//   alpha = sampled texture x factors, sampled bilinearly or nearest
//
// Source: spec/bake/state.hpp, micro_state.  How: a contour runs only through cells between four texels that
// differ, which bits find; where it meets an edge of a micro-triangle there, error-bounded floats answer
// where they can, whole numbers wide enough to be exact where they cannot; a parent that meets no such cell
// is not cut further.  2-state maps: impl/micromap/micromap.hpp, force2.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "impl/bake/bake.hpp"
#include "impl/bake/texture/wrap.hpp"

namespace mmverify::impl::bake {

/// A vertex's texture coordinates: (0, 0) and (1, 1) are outer corners of the first and the last texel.
struct TexturePoint {
  float u, v;
};
using BaseTriangle = std::array<TexturePoint, 3>;

inline constexpr std::uint32_t max_bake_level = 12;

/// How coordinates outside [0, 1) are brought back, along each axis.
struct Addressing {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
  std::uint8_t border = 0;  ///< alpha outside, with clamp_to_border
};

/// nearest: texel (i, j) owns [i, i+1) x [j, j+1), before wrapping.
enum class Filter : std::uint8_t { bilinear, nearest };

/// Opaque where alpha >= cutoff.
struct Mask {
  float cutoff = 0.5f;
};
struct Blend {};
/// Cutoff: MASK at a quotient.
using AlphaMode = std::variant<Mask, Cutoff, Blend>;

/// One mip level.
using Texels = std::variant<TexelView<std::uint8_t>, TexelView<std::uint16_t>, TexelView<float>>;

/// How alpha is sampled and scaled.
struct Sampling {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
  Filter filter = Filter::bilinear;
  float border = 0;  ///< as it is stored: a whole number up to 255 or 65535, or any finite one
  /// Alpha is multiplied by both: the material's and the one that all vertices have.  Not below 0.
  std::array<float, 2> factors{1, 1};
  /// Micro-triangles are dilated by so many texels (of each mip level) along both axes, exactly.
  float margin = 0;
};

/// What a bake took.
struct BakeCounts {
  std::uint64_t micro_triangles = 0;
  std::uint64_t leaves = 0;  ///< not decided by a parent; of all mip levels
  std::uint64_t exact = 0;   ///< leaves that took whole numbers
};

namespace detail {
class MipBaker;
}

/// A texture made ready for any number of triangles; one may be used by many threads at once.
class TriangleBaker {
 public:
  /// Mip levels in the order in which they are sampled, the largest first.
  /// Time and memory: two bits and a bit more a texel, twice that with BLEND, once.  The texels must outlive
  /// it. Errors: std::invalid_argument, naming it, for no mip level; a texture without texels, with more than
  /// 16384 a side, or larger than memory can be; a texel, border, cutoff, factor or margin that is not
  /// finite; a border that is not as texels are stored; a factor or margin below 0; a margin of 2^20 or more.
  TriangleBaker(std::span<const Texels> mips, const AlphaMode& mode, const Sampling& sampling = {});
  /// 8 bits, MASK, bilinear.
  TriangleBaker(const AlphaView& texture, Cutoff cutoff, const Addressing& addressing = {});
  ~TriangleBaker();
  TriangleBaker(TriangleBaker&&) noexcept;
  TriangleBaker& operator=(TriangleBaker&&) noexcept;

  /// The 4-state map, packed (impl/micromap/micromap.hpp), in the order of impl/index/index.hpp.
  /// Domain: coordinates finite and below 2^20 in size, in any order, on a line or in a point as well; level
  /// in 0..max_bake_level; map.size() = ceil(4^level / 4).
  /// Time: that of the micro-triangles that meet texels of both sides; of one of these, at worst that of the texture's
  /// texels and of the repeats of it that its edges cross, where they do not come back to where they were.  What
  /// addressing makes one texel, or one row, of is taken as one, however far it goes. Errors: std::invalid_argument where that
  /// does not hold; nothing is written.
  BakeCounts bake(const BaseTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map) const;

 private:
  std::vector<std::unique_ptr<const detail::MipBaker>> mips_;
};

}  // namespace mmverify::impl::bake
