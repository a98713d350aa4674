// The differences between the texels of maps and of their textures.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/attribute/code_meaning.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::scene {

/// The difference of a texture and its maps, over the texels whose centre a triangle shows; none if no texel
/// is shown.  Normals have length 1 in both, if they are averaged as normals.
struct MapError {
  std::optional<double> rmse;  ///< over the channels in use, in codes of 8 bits
  std::optional<double> flip;  ///< mean FLIP in texture space, for sRGB textures alone
};

/// One of the two measures of MapError; none if it is missing.
enum class Measure : std::uint8_t { flip, rmse };
inline std::optional<double> error_by(const MapError& error, Measure measure) {
  return measure == Measure::flip ? error.flip : error.rmse;
}

/// Sums over texels.
struct ErrorSums {
  double squares = 0, flip = 0;
};

/// The rows of RGB with which maps are compared: the texture, its normals made one unit long as in maps.
std::vector<std::uint8_t> compared_texels(const ColourImage& image, AttributeSet set, Averaging averaging);

/// Makes each normal one unit long, if normals are averaged as such; other sets stay.
void make_unit(std::vector<std::uint8_t>& rgb, AttributeSet set, Averaging averaging);

/// Adds the errors of `rgb` over the texels that are shown.  Returns FLIP by texel, or nothing unless the set
/// is sRGB.
std::vector<float> add_errors(ErrorSums& sums, const ColourImage& image, AttributeSet set,
                              const std::vector<std::uint8_t>& original, const std::vector<std::uint8_t>& rgb,
                              std::span<const std::uint8_t> shown, unsigned threads);

/// The error over `shown` texels; none if shown is 0.
MapError error_of(const ErrorSums& sums, AttributeSet set, std::uint64_t shown);

}  // namespace mmverify::scene
