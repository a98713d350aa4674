#ifdef MMVERIFY_HAS_AVIF
#include <avif/avif.h>
#include <dlfcn.h>
#endif

#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include "scene/read/bad_scene.hpp"
#include "scene/read/image.hpp"
#include "scene/read/picture_kind.hpp"
#include "scene/read/rgba_image.hpp"

namespace mmverify::scene {

#ifdef MMVERIFY_HAS_AVIF

namespace {

/// The functions of libavif that are called here.
#define MMVERIFY_AVIF_FUNCTIONS(X) \
  X(avifDecoderCreate)             \
  X(avifDecoderDestroy)            \
  X(avifDecoderNextImage)          \
  X(avifDecoderParse)              \
  X(avifDecoderSetIOMemory)        \
  X(avifImageYUVToRGB)             \
  X(avifResultToString)            \
  X(avifRGBImageSetDefaults)

/// These names, in this namespace, are pointers to the library's functions.  Domain: why_no_avif() is empty.
#define MMVERIFY_AVIF_POINTER(name) decltype(&::name) name = nullptr;
MMVERIFY_AVIF_FUNCTIONS(MMVERIFY_AVIF_POINTER)
#undef MMVERIFY_AVIF_POINTER

/// Opens the library, which brings three coders of video, and finds the functions.  Returns what is missing.
std::optional<std::string> opened() {
  const std::string remedy = "; install libavif (Debian: libavif15, or mmverify-plugins beside mmverify)";
  void* const library = dlopen(MMVERIFY_AVIF_SONAME, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return std::string("no decoder of AVIF: ") + dlerror() + remedy;
  const char* missing = nullptr;
  const auto find = [&](auto& pointer, const char* function) {
    pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(dlsym(library, function));
    if (pointer == nullptr) missing = function;
  };
#define MMVERIFY_AVIF_FIND(name) find(name, #name);
  MMVERIFY_AVIF_FUNCTIONS(MMVERIFY_AVIF_FIND)
#undef MMVERIFY_AVIF_FIND
  if (missing != nullptr)
    return std::string("no decoder of AVIF: " MMVERIFY_AVIF_SONAME " has no ") + missing + remedy;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> why_no_avif() {
  static const std::optional<std::string> why = opened();
  return why;
}

RgbaImage decode_avif(std::span<const unsigned char> bytes, bool eight, const std::string& file,
                      const std::string& place) {
  if (const auto why = why_no_avif()) throw UnreadExtension(file, place, *why);
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

std::optional<std::string> why_no_avif() {
  return "this program was built without AVIF (Debian: libavif-dev)";
}

RgbaImage decode_avif(std::span<const unsigned char>, bool, const std::string& file,
                      const std::string& place) {
  throw UnreadExtension(file, place, *why_no_avif());
}

#endif

}  // namespace mmverify::scene
