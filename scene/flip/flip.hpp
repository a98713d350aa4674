// FLIP: how different two pictures look to somebody who flips between them, texel by texel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mmverify::flip {

/// Texels of 8-bit sRGB: red, green and blue of texel (x, y) begin at rgb[3 (x + width y)], rows from the top.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::span<const std::uint8_t> rgb;
};

/// The number of pixels in a degree of the field of view.
///   pixels per degree = distance x (pixels across the screen / its width) x pi / 180
/// The authors' default: a screen 3840 pixels and 0.7 m wide, seen from 0.7 m.  About 67.02.
double pixels_per_degree(double distance, double pixels_across, double width);
inline constexpr double default_pixels_per_degree = 3840 * 3.14159265358979323846 / 180;
inline constexpr double least_pixels_per_degree = 1, most_pixels_per_degree = 1000;
/// The longest side of a picture, as in impl/bake.
inline constexpr std::uint32_t longest_side = 16384;

struct Options {
  double pixels_per_degree = default_pixels_per_degree;
  unsigned threads = 0;  ///< 0: as many as the machine has
};

/// The error of each texel, from 0, equal to the eye, to 1.
///   error = c^(1 - f),  c: difference of colour, f: difference of edges and points, both in [0, 1]
/// Symmetric in the two pictures; exactly 0 everywhere if they are equal.  Beyond its border a picture
/// repeats its last texels.  Computed in binary32 without contraction, so that it is the same for any number
/// of threads and any vector width.
/// Domain: sides 1..longest_side, the same of both; rgb.size() = 3 width height; pixels per degree within the bounds above;
/// else std::invalid_argument.
/// Source: Andersson et al., FLIP: A Difference Evaluator for Alternating Images (2020), section 4.
std::vector<float> error_map(const Picture& reference, const Picture& test, const Options& options = {});

/// The mean of an error map, its sum in binary64; 0 if the map is empty.
double mean(std::span<const float> errors);

/// The mean over the texels k with counted[k] != 0; 0 if there is none.
/// Domain: counted.size() = errors.size(), else std::invalid_argument.
double mean(std::span<const float> errors, std::span<const std::uint8_t> counted);

}  // namespace mmverify::flip
