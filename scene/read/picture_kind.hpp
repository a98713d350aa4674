// The kinds of pictures, and which of them are read.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace mmverify::scene {

enum class PictureKind : std::uint8_t { png, jpeg, webp, avif, dds, tga, ktx2, openexr, unknown };

/// The kind by the first bytes; TGA, which has no mark, by a header of which all fields are possible.
PictureKind picture_kind(std::span<const unsigned char> bytes);

const char* name_of(PictureKind kind) noexcept;

/// The part of a picture that is read; a DDS, an OpenEXR, or a KTX2 of BC1 to BC7, has its alpha read alone.
enum class PictureUse : std::uint8_t { alpha, colour };

/// Why a picture is not read, whatever its bytes are otherwise: "an animated WebP is not read here".  None if it is read,
/// or refused as damaged.
std::optional<std::string> why_unread(std::span<const unsigned char> bytes, PictureUse use);

}  // namespace mmverify::scene
