// Attribute micromaps from textures of 8 or 16 bits a channel, or of binary32: RGBA at micro-vertices and of
// micro-triangles, each the exact number rounded once: codes half up, binary32 to nearest, ties to even.
//
//   vertices   what the sampler gives at the micro-vertex, bilinear or nearest
//   faces      the mean of the texels under the micro-triangle, each by its share of the area
//
// Source: spec/attribute/bake.hpp, which also defines the values of a triangle without an area in the texture.
// How: binary64 with an error bound.  A value too near the middle between two codes, or between two numbers of
// binary32, is computed in whole numbers wide enough to be exact.  A face is the integral of F dy around it, F(x, y)
// the sum of the row's texels up to x: each row gets a line of sums, and each micro-edge is integrated once for both of
// its sides.  For floats, the bound depends on the greatest |texel| nearby, and the width of whole numbers on the
// texture's exponents: docs/ATTRIBUTE_BAKE.md.
// IEEE arithmetic must be rounded to nearest, the default, with numbers below the normal ones kept.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "impl/bake/triangles.hpp"

namespace mmverify::impl::attribute {

using bake::BaseTriangle;
using bake::Filter;
using bake::TexturePoint;
using bake::Wrap;

/// A texel, or a value of a map.  Channel is std::uint8_t or std::uint16_t, where code c means c / 255 or c / 65535, or
/// float, where the number (binary32) means itself.
template <class Channel>
using RgbaOf = std::array<Channel, 4>;
using Rgba = RgbaOf<std::uint8_t>;
using Rgba16 = RgbaOf<std::uint16_t>;
using RgbaFloat = RgbaOf<float>;

/// A view, not an owner: texel (x, y) is the four channels from texels[4 (x + pitch y)], rows from the top.
template <class Channel>
struct RgbaViewOf {
  const Channel* texels;
  std::uint32_t width, height;
  std::size_t pitch;  ///< in texels
};
using RgbaView = RgbaViewOf<std::uint8_t>;
using RgbaView16 = RgbaViewOf<std::uint16_t>;
using RgbaViewFloat = RgbaViewOf<float>;

/// The meaning of codes, which decides how they are averaged.  Alpha is linear under each meaning.  Floats have
/// `linear` only.
enum class Meaning : std::uint8_t {
  linear,            ///< the code's number; of sRGB codes, the paper's own reading
  srgb,              ///< RGB on the sRGB curve, averaged in linear light; of 8 bits alone
  normal,            ///< RGB a direction, 2 number - 1, made one unit long again
  normal_and_length  ///< the same, and the mean's own length in the place of alpha
};

/// How a texture is read.
template <class Channel>
struct AttributeSamplingOf {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
  Filter filter = Filter::bilinear;  ///< for vertices()
  Meaning meaning = Meaning::linear;
  RgbaOf<Channel> border{};  ///< the texel outside, with clamp_to_border
};
using AttributeSampling = AttributeSamplingOf<std::uint8_t>;
using AttributeSampling16 = AttributeSamplingOf<std::uint16_t>;
using AttributeSamplingFloat = AttributeSamplingOf<float>;

/// The counts of one bake.
struct AttributeCounts {
  std::uint64_t values = 0;  ///< micro-vertices or micro-triangles
  std::uint64_t exact = 0;   ///< values computed in whole numbers
};

inline constexpr std::uint32_t max_attribute_level = 12;

namespace detail {
template <class Channel>
class Source;
}

/// A texture, or one mip level of it, made ready for any number of triangles.  Many threads may use one at once.
/// Channel: std::uint8_t, std::uint16_t or float.  Float texels may be any finite numbers, subnormal ones too.  A mean
/// of 0 is +0; a mean that rounds to 0 keeps its sign.
template <class Channel>
class AttributeBakerOf {
 public:
  /// The texels must outlive the baker and stay as they are.  All float texels are read here.
  /// Errors: std::invalid_argument for no texels, or more than 16384 a side; for Meaning::srgb of 16 bits, which no
  /// graphics API has; for floats, a meaning that is not linear, or a texel or border that is infinite or NaN.
  explicit AttributeBakerOf(const RgbaViewOf<Channel>& texture,
                            const AttributeSamplingOf<Channel>& sampling = {});
  ~AttributeBakerOf();
  AttributeBakerOf(AttributeBakerOf&&) noexcept;
  AttributeBakerOf& operator=(AttributeBakerOf&&) noexcept;

  /// Writes micro-triangle k of the curve (impl/index/index.hpp) to out[k].
  /// Domain: finite coordinates below 2^20 in size, in either orientation; a triangle may be a segment or a point; it
  /// covers at most 2^24 texels, and 2^15 along an axis; level in 0..max_attribute_level; out.size() = 4^level.
  /// Memory: 16 bytes a texel of the triangle's box; 32 with sRGB, 16 bits or floats.  A box of more than 2^16 texels
  /// that lies in the picture takes as much for the whole texture, once; the baker keeps it (not for floats).
  /// Errors: std::invalid_argument outside the domain; nothing is written.
  /// Law: attribute.bake_face, attribute.bake_on_floats, attribute.bake_texels16, attribute.bake_texel_floats
  AttributeCounts faces(const BaseTriangle& uv, std::uint32_t level, std::span<RgbaOf<Channel>> out) const;

  /// Writes micro-vertex (i, j) to out[r (r + 1) / 2 + j], r = i + j: row order, rows from the first vertex.
  /// Domain, errors: as faces(), but for any number of texels; out.size() = (2^level + 1)(2^level + 2) / 2.
  /// Law: attribute.bake_vertex, attribute.bake_on_floats, attribute.bake_texels16, attribute.bake_texel_floats
  AttributeCounts vertices(const BaseTriangle& uv, std::uint32_t level, std::span<RgbaOf<Channel>> out) const;

 private:
  std::unique_ptr<const detail::Source<Channel>> source_;
};
extern template class AttributeBakerOf<std::uint8_t>;
extern template class AttributeBakerOf<std::uint16_t>;
extern template class AttributeBakerOf<float>;
using AttributeBaker = AttributeBakerOf<std::uint8_t>;
using AttributeBaker16 = AttributeBakerOf<std::uint16_t>;
using AttributeBakerFloat = AttributeBakerOf<float>;

}  // namespace mmverify::impl::attribute
