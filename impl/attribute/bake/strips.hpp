// Faces strip by strip, in binary64 with a bound, by SIMD.  Internal to impl/attribute.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "impl/attribute/bake/frame.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::attribute::detail {

struct Face {
  std::uint32_t iu, iv, upper;  ///< of grid square (iu, iv), 0 or 1
};

/// Of the same orientation.
inline index::Corners corners_of(const Face& f) {
  if (f.upper != 0)
    return {index::Vertex{f.iu + 1, f.iv + 1}, index::Vertex{f.iu, f.iv + 1}, index::Vertex{f.iu + 1, f.iv}};
  return {index::Vertex{f.iu, f.iv}, index::Vertex{f.iu + 1, f.iv}, index::Vertex{f.iu, f.iv + 1}};
}

/// A face by itself is known within m (still + each e): m the greatest |texel| of its box, e the box's greater side.
struct NearBound {
  double still, each;
};

/// What faces of a base triangle are made of.
template <class Channel, class Sum>
struct StripJob {
  const Source<Channel>& source;
  const Frame& frame;
  RowSums<Sum> sums;            ///< of the frame's box
  std::uint32_t side;           ///< N
  double scale;                 ///< the mean is an integral times this
  std::array<double, 4> bound;  ///< within which the mean is known, of each channel
  NearBound near;               ///< of floats
};

/// Writes the faces that floats are sure of, in the order of the curve, and names the others.
/// Domain: bounds below most_off() of the channels' coding.
void bake_strips(const StripJob<std::uint8_t, float>& job, Rgba* out, std::vector<Face>& unsure);
void bake_strips(const StripJob<std::uint8_t, double>& job, Rgba* out, std::vector<Face>& unsure);
void bake_strips(const StripJob<std::uint16_t, double>& job, Rgba16* out, std::vector<Face>& unsure);
void bake_strips(const StripJob<float, double>& job, RgbaFloat* out, std::vector<Face>& unsure);

}  // namespace mmverify::impl::attribute::detail
