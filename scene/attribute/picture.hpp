// Pictures of a level and its texture, side by side.
#pragma once

#include <cstdint>

#include "scene/attribute/measure.hpp"
#include "scene/attribute/mip_errors.hpp"
#include "scene/rgb_picture.hpp"

namespace mmverify::scene {

/// The upper row has the texture, faces, vertices; the lower row a scale of errors, from 0 on the left to 1,
/// and the errors of both.  Each tile is the texture made smaller by the least whole number that leaves no
/// side above `longest`, as means of codes.
/// Domain: longest > 0.
RgbPicture side_by_side(const AttributePicture& picture, std::uint32_t longest);

/// The upper row has the texture's mip, faces, vertices; the lower row their errors.  Texels that no triangle
/// shows are grey, so that charts have borders.  Tiles are as above.
RgbPicture side_by_side(const MipPicture& picture, std::uint32_t longest);

/// The image made smaller by the least whole number that leaves no side above `longest`, as means of codes.
/// Domain: longest > 0.
RgbPicture made_smaller(const ColourImage& image, std::uint32_t longest);

/// The colour of an error in [0, 1]: black, blue, purple, orange, yellow, white, in equal steps, linear
/// between them.
std::array<std::uint8_t, 3> colour_of_error(float error);

}  // namespace mmverify::scene
