// Attribute micromaps from textures of 8 or 16 bits a channel, or of binary32: RGBA at micro-vertices and of
// micro-triangles, each the exact number rounded once: codes half up, binary32 to nearest, ties to even.
//
//   vertices   what the sampler gives at the micro-vertex, bilinear or nearest
//   faces      the mean of the texels under the micro-triangle, each by its share of the area
//
// Source: spec/attribute/bake.hpp, which says what a triangle without an area in the texture gives.
// How: error-bounded binary64, a value that lies too near the middle between two codes, or two numbers of binary32, in
// whole numbers wide enough to be exact.  A face is the integral of F dy around it, F(x, y) the sum of the row's texels
// up to x: a line of sums a row, each micro-edge once for both of its sides.
// Of floats the bound goes by the greatest |texel| near by, and whole numbers by the exponents that the texture has:
// docs/ATTRIBUTE_BAKE.md.
// They need IEEE arithmetic rounded to nearest, the default, and numbers below the normal ones kept.
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

/// A texel, or a value of a map.  Channel: std::uint8_t or std::uint16_t, the code c being c / 255 or c / 65535; or float,
/// binary32, itself the number.
template <class Channel>
using RgbaOf = std::array<Channel, 4>;
using Rgba = RgbaOf<std::uint8_t>;
using Rgba16 = RgbaOf<std::uint16_t>;
using RgbaFloat = RgbaOf<float>;

/// Not owned: texel (x, y) is the four channels from texels[4 (x + pitch y)], rows from the top.
template <class Channel>
struct RgbaViewOf {
  const Channel* texels;
  std::uint32_t width, height;
  std::size_t pitch;  ///< in texels
};
using RgbaView = RgbaViewOf<std::uint8_t>;
using RgbaView16 = RgbaViewOf<std::uint16_t>;
using RgbaViewFloat = RgbaViewOf<float>;

/// What codes mean, and so what is averaged.  Alpha is linear in all of them.  Of floats: linear alone.
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
  Filter filter = Filter::bilinear;  ///< of vertices
  Meaning meaning = Meaning::linear;
  RgbaOf<Channel> border{};  ///< outside, with clamp_to_border
};
using AttributeSampling = AttributeSamplingOf<std::uint8_t>;
using AttributeSampling16 = AttributeSamplingOf<std::uint16_t>;
using AttributeSamplingFloat = AttributeSamplingOf<float>;

/// What a bake took.
struct AttributeCounts {
  std::uint64_t values = 0;  ///< micro-vertices or micro-triangles
  std::uint64_t exact = 0;   ///< those that took whole numbers
};

inline constexpr std::uint32_t max_attribute_level = 12;

namespace detail {
template <class Channel>
class Source;
}

/// A texture, or one mip level of it, made ready for any number of triangles; one may be used by many threads at once.
/// Channel: std::uint8_t, std::uint16_t or float.  Of floats any finite texels may stand side by side, of any sign and
/// exponent, below 2^-126 as well; what is 0 is +0, and what is rounded to 0 keeps its sign.
template <class Channel>
class AttributeBakerOf {
 public:
  /// The texels must outlive it, and stay as they are.  Of floats all are looked at.
  /// Errors: std::invalid_argument for no texels, or more than 16384 a side; for Meaning::srgb of 16 bits, which no
  /// graphics API has; of floats for a meaning that is not linear, and for a texel or border that is infinite or NaN.
  explicit AttributeBakerOf(const RgbaViewOf<Channel>& texture,
                            const AttributeSamplingOf<Channel>& sampling = {});
  ~AttributeBakerOf();
  AttributeBakerOf(AttributeBakerOf&&) noexcept;
  AttributeBakerOf& operator=(AttributeBakerOf&&) noexcept;

  /// Micro-triangle k of the curve (impl/index/index.hpp) at out[k].
  /// Domain: coordinates finite and below 2^20 in size, in any order, on a line or in a point as well; over 2^24 texels
  /// at most, and 2^15 along an axis; level in 0..max_attribute_level; out.size() = 4^level.
  /// Memory: 16 bytes a texel of the triangle's box, with sRGB, 16 bits or floats 32; where the box has more than 2^16
  /// texels and does not leave the picture, that of the whole texture, kept from then on, but not of floats.
  /// Errors: std::invalid_argument where the domain does not hold; nothing is written.
  AttributeCounts faces(const BaseTriangle& uv, std::uint32_t level, std::span<RgbaOf<Channel>> out) const;

  /// Micro-vertex (i, j) at out[r (r + 1) / 2 + j], r = i + j: row order, rows from the first vertex.
  /// Domain, errors: the same, but for the number of texels; out.size() = (2^level + 1)(2^level + 2) / 2.
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
