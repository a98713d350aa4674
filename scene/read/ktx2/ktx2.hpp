// Pictures in KTX2.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "scene/read/picture_kind.hpp"
#include "scene/read/rgba_image.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// Why a KTX2 is not read here: its shape, its format, its supercompression, or the colours of BC1 to BC7,
/// of words and of floats.
/// None if it is read or damaged.
std::optional<std::string> why_unread_ktx2(std::span<const unsigned char> bytes, PictureUse use);

/// The four channels of level 0, as the file codes them: sRGB is not made linear.
///   R8, RG8, RGB8, BGR8, RGBA8, BGRA8: its bytes, 0 for a missing colour, 255 for a missing alpha
///   UASTC: texels_of_uastc()                       ETC1S: texels_of_etc1s()
/// Zstandard and ZLIB are undone before.
/// Errors: BadScene if it is damaged, or a side is 0 or above longest_side; precondition: why_unread_ktx2() of
/// colours is none.
/// Source: KTX File Format Specification 2.0; Khronos Data Format Specification 1.4.
/// Test: ktx2_test compares with texels of Basis Universal's decoder.
RgbaImage decode_ktx2(std::span<const unsigned char> bytes, const std::string& file,
                      const std::string& place);

/// The alpha of level 0: of decode_ktx2(), or by the decoders of a DDS for BC1 to BC7; words and floats as they are, 1
/// where RGB, RG or R have none.  Premultiplied colours have the same alpha.  Errors: as above, with why_unread_ktx2() of alpha.
void decode_ktx2_alpha(std::span<const unsigned char> bytes, Image& image, const std::string& file,
                       const std::string& place);

}  // namespace mmverify::scene
