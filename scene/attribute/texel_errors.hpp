// How far what maps show is from their textures, texel by texel.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/attribute/code_meaning.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::scene {

/// The difference of a texture and what its maps show, over the texels whose centre a triangle shows; nothing where none
/// is shown.  Normals are made one unit long in both, where they are averaged as such.
struct MapError {
  std::optional<double> rmse;  ///< of the channels in use, in codes of 8 bits
  std::optional<double> flip;  ///< mean FLIP in texture space; of sRGB textures alone
};

/// One of its two measures; nothing where there is none.
enum class Measure : std::uint8_t { flip, rmse };
inline std::optional<double> error_by(const MapError& error, Measure measure) {
  return measure == Measure::flip ? error.flip : error.rmse;
}

/// Sums over texels.
struct ErrorSums {
  double squares = 0, flip = 0;
};

/// What maps are held against, rows of RGB: the texture, its normals made one unit long as theirs are.
std::vector<std::uint8_t> compared_texels(const ColourImage& image, AttributeSet set, Averaging averaging);

/// Normals alone: each one unit long, where they are averaged as such.
void make_unit(std::vector<std::uint8_t>& rgb, AttributeSet set, Averaging averaging);

/// Adds the errors of rgb over the texels that are shown.  Returns FLIP by texel; of other than sRGB textures nothing.
std::vector<float> add_errors(ErrorSums& sums, const ColourImage& image, AttributeSet set,
                              const std::vector<std::uint8_t>& original, const std::vector<std::uint8_t>& rgb,
                              std::span<const std::uint8_t> shown, unsigned threads);

/// Of so many texels; nothing of none.
MapError error_of(const ErrorSums& sums, AttributeSet set, std::uint64_t shown);

}  // namespace mmverify::scene
