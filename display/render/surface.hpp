// The alpha test of an any-hit shader: the texture at one point, against the cutoff.
#pragma once

#include <array>
#include <cstdint>

#include "display/render/barycentrics.hpp"
#include "impl/bake/triangles.hpp"

namespace mmverify::render {

/// The alpha of a surface, from the same inputs as its micromaps: mip level 0 alone, no margin.
/// The texels outlive the surface.
class Surface {
 public:
  /// Errors: std::invalid_argument for texels of 32 bits, and as of impl::bake::TriangleBaker.
  Surface(const impl::bake::Texels& texels, const impl::bake::Sampling& sampling,
          const impl::bake::AlphaMode& mode);

  /// Whether the hit is opaque.
  ///   MASK    alpha >= cutoff, exactly: doubles with an error bound, rationals if the bound does not decide
  ///   BLEND   alpha > chance: stochastic transparency; `chance` is in 2^-25 .. 1 - 2^-25 and a function of ray and
  ///           triangle alone.  So alpha <= 0 is never opaque, and alpha >= 1 always
  ///   uv = w uv[0] + u uv[1] + v uv[2], exactly
  /// Domain: barycentrics of a point of the triangle; coordinates below 2^20 in size.
  bool opaque(const impl::bake::BaseTriangle& uv, const Barycentrics& at, float chance) const;

  /// The texel whose square holds the hit, before it is wrapped: floor of u width and of v height, exactly.
  /// Domain: that of opaque().
  std::array<std::int64_t, 2> texel(const impl::bake::BaseTriangle& uv, const Barycentrics& at) const;

  /// The code of a texel, wrapped, or of the border.
  std::uint32_t code(std::int64_t x, std::int64_t y) const noexcept;

  /// Sums of `parts` codes, whose mean stands for one code.  From `opaque` on, alpha >= cutoff (BLEND: >= 1).  Below
  /// `transparent`, alpha < cutoff (BLEND: <= 0).  From `half` on, alpha >= cutoff (BLEND: >= 1/2).
  /// A sum that no code reaches stands for none.
  struct SumBounds {
    std::uint64_t opaque, transparent, half;
  };
  SumBounds bounds_of_sums(std::uint32_t parts) const;

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

  /// The number of texels that opaque() reads: 4 bilinear, 1 nearest.
  unsigned fetches() const { return nearest_ ? 1 : 4; }

  const impl::bake::Texels& texels() const { return texels_; }
  const impl::bake::Sampling& sampling() const { return sampling_; }
  const impl::bake::AlphaMode& mode() const { return mode_; }

 private:
  bool opaque_exactly(const impl::bake::BaseTriangle& uv, const Barycentrics& at) const;

  impl::bake::Texels texels_;
  impl::bake::Sampling sampling_;
  impl::bake::AlphaMode mode_;
  std::uint32_t width_ = 0, height_ = 0;
  bool nearest_ = false, blend_ = false;
  double cutoff_ = 0;  ///< for MASK: the cutoff times the greatest code, over the factors' product
  double factor_ = 0;  ///< from a code to alpha
  std::uint32_t least_opaque_ = 0;  ///< the least code that is opaque by itself
};

}  // namespace mmverify::render
