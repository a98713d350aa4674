// Checks of a Targa picture before it is decoded.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace mmverify::scene {

/// Whether bytes begin with a possible header of TGA, which has no mark.
/// Source: Truevision TGA File Format Specification 2.0, "Field 1" to "Field 5".
bool is_tga(std::span<const unsigned char> bytes);

/// The damage of a picture whose texels are cut off, or none.  The decoder takes what is missing for black.
/// Precondition: is_tga().
std::optional<std::string> damage_of_tga(std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
