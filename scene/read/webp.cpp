#ifdef MMVERIFY_HAS_WEBP
#include <webp/decode.h>
#endif

#include "scene/read/bad_scene.hpp"
#include "scene/read/image.hpp"
#include "scene/read/picture_kind.hpp"
#include "scene/read/rgba_image.hpp"

namespace mmverify::scene {

#ifdef MMVERIFY_HAS_WEBP

RgbaImage decode_webp(std::span<const unsigned char> bytes, const std::string& file,
                      const std::string& place) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK)
    throw BadScene(file, place, "a WebP without a readable header; truncated file?");
  if (features.has_animation != 0) throw UnreadExtension(file, place, "an animated WebP is not read here");
  check_sides(static_cast<std::uint64_t>(features.width), static_cast<std::uint64_t>(features.height),
              "a WebP", file, place);
  RgbaImage image{
      static_cast<std::uint32_t>(features.width), static_cast<std::uint32_t>(features.height), {}};
  std::vector<std::uint8_t> rgba(std::size_t{4} * image.width * image.height);
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), rgba.data(), rgba.size(), 4 * features.width) == nullptr)
    throw BadScene(file, place, "a WebP that cannot be decoded; truncated file?");
  image.rgba = std::move(rgba);
  return image;
}

#else

RgbaImage decode_webp(std::span<const unsigned char> bytes, const std::string& file,
                      const std::string& place) {
  throw UnreadExtension(file, place, why_unread(bytes, PictureUse::alpha).value_or("WebP is not read here"));
}

#endif

}  // namespace mmverify::scene
