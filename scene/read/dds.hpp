// The alpha of a DDS, blocks of BC1 to BC7 and plain texels.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// Why a DDS is not read here: a cube, a volume, or a format without a decoder.  None if it is read or damaged.
std::optional<std::string> why_unread_dds(std::span<const unsigned char> bytes);

/// The alpha of a DDS's largest level: 16 bits for BC3, else 8.
///   BC1, BC2, BC3: alpha_of_bc1() and the others   BC7: alpha_of_bc7()
///   RGBA8, BGRA8: its byte / 255
///   BC4, BC5, BC6H: 1, since they have no alpha
/// Errors: BadScene if it is cut off, or a side is 0 or above longest_side; precondition: why_unread_dds() is none.
/// Source: Khronos Data Format Specification 1.3, 20 (S3TC), 21 (RGTC), 22 (BPTC); DDS_HEADER of Direct3D.
void decode_dds_alpha(std::span<const unsigned char> bytes, Image& image, const std::string& file,
                      const std::string& place);

}  // namespace mmverify::scene
