// Textures of one alpha, but for one texel at most: as large as a texture may be, and yet it is plain what is in them.
#pragma once

#include "proofs/bake/support.hpp"

namespace mmverify::proofs::bake {

/// Stored texels by their bits.
struct LoneTexel {
  std::uint32_t all = 0;       ///< what every other texel is
  std::uint32_t lone = 0;      ///< what texel (i, j) is; the same where there is none
  std::uint32_t i = 0, j = 0;  ///< outside of the texture: there is none
};

inline constexpr char lone_begins[] = "lone-";
/// "lone-ff-0-17-300", in the place of all texels in a case's text.
std::string text_of(const LoneTexel& texel);
/// Throws BadCase.
LoneTexel lone_texel(const std::string& text);

/// One mip.
std::vector<std::uint32_t> texels(const LoneTexel& texel, std::uint32_t width, std::uint32_t height);

/// Sample k of a level: 13 shapes of 65,536 texels and more, in turn of one alpha, opaque but for one texel,
/// transparent, transparent but for one; half of the texture, all of it, or a triangle somewhere on it.
/// What the subject does not support is fitted to it.
Case case_with_lone_texel(const Support& support, Level n, std::uint64_t k, std::uint64_t seed);

}  // namespace mmverify::proofs::bake
