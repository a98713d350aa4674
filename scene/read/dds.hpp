// The alpha of a DDS, blocks of BC1 to BC7 and plain texels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// Why a DDS is not read here: a cube, a volume, or a format without a decoder.  None if it is read or damaged.
std::optional<std::string> why_unread_dds(std::span<const unsigned char> bytes);

/// The alpha of a DDS's largest level: 16 bits for BC3, else 8.
///   BC1: 0 for the code 3 of a block with colour 0 <= colour 1, else 1
///   BC2: code / 15                                 BC3: alpha_of_bc3()
///   BC7: alpha_of_bc7()                            RGBA8, BGRA8: its byte / 255
///   BC4, BC5, BC6H: 1, since they have no alpha
/// Errors: BadScene if it is cut off, or a side is 0 or above longest_side; precondition: why_unread_dds() is none.
/// Source: Khronos Data Format Specification 1.3, 20 (S3TC), 21 (RGTC), 22 (BPTC); DDS_HEADER of Direct3D.
void decode_dds_alpha(std::span<const unsigned char> bytes, Image& image, const std::string& file,
                      const std::string& place);

/// The 16 alphas of a BC3 block, row by row, of 65535: the rational of the specification, rounded to nearest.
///   a0 > a1: ((7 - i) a0 + i a1) / 7, i in 0..7; else ((5 - i) a0 + i a1) / 5, i in 0..5, then 0 and 1
/// The code k stands for i = 0, 7 (or 5), 1, 2, ...  Domain: 8 bytes.
/// Test: dds_test compares all endpoints and codes with rationals.
std::array<std::uint16_t, 16> alpha_of_bc3(std::span<const unsigned char> block);

}  // namespace mmverify::scene
