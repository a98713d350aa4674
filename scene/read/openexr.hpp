// The alpha of a picture in OpenEXR; there if its library was at build time.
#pragma once

#include <span>
#include <string>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// The channel A as floats, exactly: half and float as they are, whole numbers of 32 bits rounded to float; 1 where there
/// is none.  Rows from the top.
/// Errors: BadScene if it is damaged, a side is above longest_side, or an alpha is not finite; UnreadExtension for several
/// parts, deep data, a data window that is not the display window, or an alpha of fewer texels, and in a build without the
/// library.
/// Source: Technical Introduction to OpenEXR.
/// Test: pictures_test
void decode_openexr_alpha(std::span<const unsigned char> bytes, Image& image, const std::string& file,
                          const std::string& place);

}  // namespace mmverify::scene
