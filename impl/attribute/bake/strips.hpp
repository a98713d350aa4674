// Faces strip by strip, in binary64 with a bound, by SIMD.  Internal to impl/attribute.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "impl/attribute/bake/frame.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::attribute::detail {

struct Face {
  std::uint32_t iu, iv, upper;  ///< grid square (iu, iv); upper is 0 or 1
};

/// The corners of a face, in the orientation of the base triangle.
inline index::Corners corners_of(const Face& f) {
  if (f.upper != 0)
    return {index::Vertex{f.iu + 1, f.iv + 1}, index::Vertex{f.iu, f.iv + 1}, index::Vertex{f.iu + 1, f.iv}};
  return {index::Vertex{f.iu, f.iv}, index::Vertex{f.iu + 1, f.iv}, index::Vertex{f.iu, f.iv + 1}};
}

/// The bound of a face by itself, m (still + each e): m the greatest |texel| of its box, e the box's greater side.
/// docs/ATTRIBUTE_BOUNDS.md, "A face of floats by itself", derives it.
struct NearBound {
  double still, each;
};

/// The input of bake_strips(): a base triangle, its sums and its bounds.
template <class Channel, class Sum>
struct StripJob {
  const Source<Channel>& source;
  const Frame& frame;
  RowSums<Sum> sums;            ///< of the frame's box
  std::uint32_t side;           ///< N
  double scale;                 ///< the mean is this times an integral
  std::array<double, 4> bound;  ///< bound of the mean, of each channel
  NearBound near;               ///< for floats
};

/// Writes the faces of which binary64 is sure, in the order of the curve, and appends the others to `unsure`.
/// Domain: bounds below most_off() of the channels' coding.
void bake_strips(const StripJob<std::uint8_t, float>& job, Rgba* out, std::vector<Face>& unsure);
void bake_strips(const StripJob<std::uint8_t, double>& job, Rgba* out, std::vector<Face>& unsure);
void bake_strips(const StripJob<std::uint16_t, double>& job, Rgba16* out, std::vector<Face>& unsure);
void bake_strips(const StripJob<float, double>& job, RgbaFloat* out, std::vector<Face>& unsure);

}  // namespace mmverify::impl::attribute::detail
