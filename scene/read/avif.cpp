#ifdef MMVERIFY_HAS_AVIF
#include <avif/avif.h>
#endif

#include <memory>

#include "scene/read/bad_scene.hpp"
#include "scene/read/image.hpp"
#include "scene/read/picture_kind.hpp"
#include "scene/read/rgba_image.hpp"

namespace mmverify::scene {

#ifdef MMVERIFY_HAS_AVIF

RgbaImage decode_avif(std::span<const unsigned char> bytes, bool eight, const std::string& file,
                      const std::string& place) {
  const std::unique_ptr<avifDecoder, void (*)(avifDecoder*)> decoder(avifDecoderCreate(), avifDecoderDestroy);
  const auto check = [&](avifResult result) {
    if (result != AVIF_RESULT_OK)
      throw BadScene(file, place,
                     std::string("an AVIF that cannot be decoded (") + avifResultToString(result) +
                         "); truncated file?");
  };
  check(avifDecoderSetIOMemory(decoder.get(), bytes.data(), bytes.size()));
  check(avifDecoderParse(decoder.get()));
  const avifImage* const decoded = decoder->image;
  check_sides(decoded->width, decoded->height, "an AVIF", file, place);
  if ((decoded->transformFlags & (AVIF_TRANSFORM_CLAP | AVIF_TRANSFORM_IROT | AVIF_TRANSFORM_IMIR)) != 0)
    throw UnreadExtension(file, place, "an AVIF that is turned, mirrored or cropped is not read here");
  check(avifDecoderNextImage(decoder.get()));
  RgbaImage image{decoded->width, decoded->height, {}};
  avifRGBImage rgb;
  avifRGBImageSetDefaults(&rgb, decoded);
  rgb.format = AVIF_RGB_FORMAT_RGBA;
  const bool of_bytes = eight || decoded->depth == 8;
  rgb.depth = of_bytes ? 8 : 16;
  rgb.rowBytes = image.width * 4 * (of_bytes ? 1 : 2);
  const std::size_t channels = std::size_t{4} * image.width * image.height;
  if (!of_bytes) image.rgba = std::vector<std::uint16_t>(channels);
  if (of_bytes) image.rgba = std::vector<std::uint8_t>(channels);
  rgb.pixels =
      std::visit([](auto& rgba) { return reinterpret_cast<std::uint8_t*>(rgba.data()); }, image.rgba);
  check(avifImageYUVToRGB(decoded, &rgb));
  return image;
}

#else

RgbaImage decode_avif(std::span<const unsigned char> bytes, bool, const std::string& file,
                      const std::string& place) {
  throw UnreadExtension(file, place, why_unread(bytes, PictureUse::alpha).value_or("AVIF is not read here"));
}

#endif

}  // namespace mmverify::scene
