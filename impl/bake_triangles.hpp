// Opacity micromaps of alpha-tested triangles: the exact state of every micro-triangle, for any texture
// coordinates.
//
// A closed micro-triangle is O where alpha >= cutoff on all of it, T where alpha < cutoff on all of it; else
// UO where alpha >= cutoff at its centroid, and UT where not.  Alpha is sampled bilinearly.
//
// Source: spec/bake_state.hpp, micro_state.  How: an error-bounded test in binary64 answers where it can,
// whole numbers wide enough to be exact where it cannot; a parent whose texels are all on one side of the
// cutoff is not cut further.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "impl/bake.hpp"
#include "impl/bake_wrap.hpp"

namespace mmverify::impl::bake {

/// A vertex's texture coordinates: (0, 0) and (1, 1) are outer corners of the first and the last texel.
struct TexturePoint {
  float u, v;
};
using BaseTriangle = std::array<TexturePoint, 3>;

inline constexpr std::uint32_t max_bake_level = 12;

struct Addressing {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
  std::uint8_t border = 0;  ///< alpha outside, with clamp_to_border
};

/// What a bake took.
struct BakeCounts {
  std::uint64_t micro_triangles = 0;
  std::uint64_t leaves = 0;  ///< not decided by a parent
  std::uint64_t exact = 0;   ///< leaves that took whole numbers
};

namespace detail {
class Sides;
}

/// A texture made ready for any number of triangles; one may be used by many threads at once.
class TriangleBaker {
 public:
  /// Time and memory: 4 bytes a texel, once.  The texels must outlive it.
  /// Errors: std::invalid_argument for a texture without texels or with more than 16384 a side, or a cutoff
  /// over 0.
  TriangleBaker(const AlphaView& texture, Cutoff cutoff, const Addressing& addressing = {});
  ~TriangleBaker();
  TriangleBaker(TriangleBaker&&) noexcept;
  TriangleBaker& operator=(TriangleBaker&&) noexcept;

  /// The 4-state map, packed (impl/micromap.hpp), in the order of impl/index.hpp.
  /// Domain: coordinates finite and below 2^20 in size, in any order, on a line or in a point as well; level
  /// in 0..max_bake_level; map.size() = ceil(4^level / 4).
  /// Time: that of the micro-triangles that meet texels of both sides; for one that spans very many texels,
  /// at worst that of the rows and of the cells along its edges. Errors: std::invalid_argument where that
  /// does not hold; nothing is written.
  BakeCounts bake(const BaseTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map) const;

 private:
  AlphaView texture_;
  std::unique_ptr<const detail::Sides> sides_;
};

}  // namespace mmverify::impl::bake
