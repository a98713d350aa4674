// The image of a texture that may have several: the extensions' and the fallback.
#pragma once

#include <optional>
#include <string>

#include "scene/read/buffers.hpp"
#include "scene/read/picture_kind.hpp"

namespace mmverify::scene {

struct TextureSource {
  std::optional<std::size_t> image;  ///< none if the file has none that is read here
  std::string note;                  ///< a sentence about which image was taken and which was not; or empty
};

/// The first of a texture's images that is read here: WebP, AVIF, DDS and KTX2 of EXT_texture_webp,
/// EXT_texture_avif, MSFT_texture_dds and KHR_texture_basisu, since a renderer that knows the extension draws
/// that one; then `source`, the fallback.  A damaged image is passed over while another one follows.
/// Errors: BadScene if the bytes of an image with an alternative cannot be read; UnreadExtension if the file
/// requires an extension of the texture that is not read here.
TextureSource texture_source(const Document& document, const Buffers& buffers, std::size_t texture,
                             PictureUse use);

}  // namespace mmverify::scene
