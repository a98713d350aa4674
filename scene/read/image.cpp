#include "scene/read/image.hpp"

#include <stb/stb_image.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "scene/read/bad_scene.hpp"
#include "scene/read/dds.hpp"
#include "scene/read/ktx2/ktx2.hpp"
#include "scene/read/openexr.hpp"
#include "scene/read/picture_kind.hpp"
#include "scene/read/png.hpp"
#include "scene/read/rgba_image.hpp"
#include "scene/read/tga.hpp"

namespace mmverify::scene {
namespace {

using ImageBytes = std::span<const unsigned char>;

template <class Sample>
std::vector<Sample> alpha_of(const Sample* rgba, std::size_t texels) {
  std::vector<Sample> alpha(texels);
  for (std::size_t k = 0; k < texels; ++k) alpha[k] = rgba[4 * k + 3];
  return alpha;
}

/// The depth at which a PNG of 16 bits is decoded.
enum class Depth { own, eight };

/// Errors: BadScene if a PNG's header or chunks are damaged, or no small file could hold its texels.
void check_png(ImageBytes bytes, const std::string& file, const std::string& place) {
  const auto bad = [&](const std::string& what) { throw BadScene(file, place, what); };
  // IHDR is the first chunk.  The library's own check of it reports less.
  constexpr std::size_t ihdr = 33;
  if (bytes.size() < ihdr || std::memcmp(bytes.data() + 12, "IHDR", 4) != 0)
    bad("a PNG without a header; truncated file?");
  const auto word = [&](std::size_t at) {
    return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 |
           std::uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
  };
  const std::uint64_t width = word(16), height = word(20);
  check_sides(width, height, "a PNG", file, place);
  // Deflate compresses at most 1032 to 1, and a texel has at least `bits` bits.  So no small file claims
  // gigabytes.
  const std::uint64_t bits = bytes[24];
  if (width * bits / 8 * height / 1032 > bytes.size())
    bad("a PNG of " + std::to_string(width) + " x " + std::to_string(height) + " texels cannot be in " +
        std::to_string(bytes.size()) + " bytes; truncated file?");
  if (const auto damage = damage_of_png(bytes)) bad(*damage);
}

/// Errors: BadScene if a texel of a PNG names a colour beyond its palette.
void check_palette(ImageBytes bytes, const std::string& file, const std::string& place) {
  const auto marked = with_palette_marked(bytes);
  if (marked.empty()) return;
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> grey(
      stbi_load_from_memory(marked.data(), static_cast<int>(marked.size()), &width, &height, &channels, 1),
      stbi_image_free);
  if (grey && std::memchr(grey.get(), 0xff,
                          static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) != nullptr)
    throw BadScene(file, place, "a texel has a colour beyond the end of the palette; damaged file?");
}

/// Decodes PNG, JPEG and TGA.
template <class Take>
void decode_by_stb(ImageBytes bytes, PictureKind kind, const std::string& file, const std::string& place,
                   Depth depth, Take take) {
  const auto bad = [&](const std::string& what) { throw BadScene(file, place, what); };
  const int size = static_cast<int>(bytes.size());  // below 2^31, as every file here
  const bool png = kind == PictureKind::png;
  if (png) check_png(bytes, file, place);
  if (kind == PictureKind::tga)
    if (const auto damage = damage_of_tga(bytes)) bad(*damage);
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0)
    bad(std::string("no readable header (") + stbi_failure_reason() + "); truncated file?");
  check_sides(static_cast<std::uint64_t>(std::max(width, 0)), static_cast<std::uint64_t>(std::max(height, 0)),
              "a picture", file, place);
  if (png) check_palette(bytes, file, place);
  const auto decoded = [&](auto* rgba) {
    if (rgba == nullptr)
      bad(std::string("cannot be decoded (") + stbi_failure_reason() + "); truncated file?");
    const std::unique_ptr<std::remove_pointer_t<decltype(rgba)>, void (*)(void*)> owner(rgba,
                                                                                        stbi_image_free);
    take(rgba, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
  };
  if (depth == Depth::own && png && stbi_is_16_bit_from_memory(bytes.data(), size) != 0)
    decoded(stbi_load_16_from_memory(bytes.data(), size, &width, &height, &channels, 4));
  else
    decoded(stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4));
}

/// Decodes and calls take(rgba, width, height); rgba has four channels of 8 or 16 bits a texel.
template <class Take>
void decode(ImageBytes bytes, const std::string& file, const std::string& place, Depth depth, Take take) {
  const auto taken = [&take](const RgbaImage& image) {
    std::visit([&](const auto& rgba) { take(rgba.data(), image.width, image.height); }, image.rgba);
  };
  switch (const PictureKind kind = picture_kind(bytes)) {
    case PictureKind::png:
    case PictureKind::jpeg:
    case PictureKind::tga: return decode_by_stb(bytes, kind, file, place, depth, take);
    case PictureKind::webp: return taken(decode_webp(bytes, file, place));
    case PictureKind::avif: return taken(decode_avif(bytes, depth == Depth::eight, file, place));
    case PictureKind::ktx2: return taken(decode_ktx2(bytes, file, place));
    case PictureKind::unknown:
      throw BadScene(file, place,
                     "no picture that is read here: PNG, JPEG, WebP, AVIF, DDS, KTX2, TGA or OpenEXR");
    default:
      throw UnreadExtension(
          file, place, why_unread(bytes, PictureUse::colour).value_or("a picture that is not read here"));
  }
}

}  // namespace

void check_sides(std::uint64_t width, std::uint64_t height, const char* kind, const std::string& file,
                 const std::string& place) {
  if (width == 0 || height == 0 || width > longest_side || height > longest_side)
    throw BadScene(file, place,
                   std::string(kind) + " of " + std::to_string(width) + " x " + std::to_string(height) +
                       " texels; 1 to " + std::to_string(longest_side) + " a side are read");
}

void decode_alpha(ImageBytes bytes, Image& image, const std::string& file, const std::string& place) {
  const PictureKind kind = picture_kind(bytes);
  if (kind == PictureKind::dds) return decode_dds_alpha(bytes, image, file, place);
  if (kind == PictureKind::ktx2) return decode_ktx2_alpha(bytes, image, file, place);
  if (kind == PictureKind::openexr) return decode_openexr_alpha(bytes, image, file, place);
  decode(bytes, file, place, Depth::own,
         [&image](const auto* rgba, std::uint32_t width, std::uint32_t height) {
           image.width = width;
           image.height = height;
           image.alpha = alpha_of(rgba, std::size_t{width} * height);
         });
}

void decode_colour(ImageBytes bytes, ColourImage& image, const std::string& file, const std::string& place) {
  decode(bytes, file, place, Depth::eight,
         [&image](const auto* rgba, std::uint32_t width, std::uint32_t height) {
           image.width = width;
           image.height = height;
           image.rgba.resize(std::size_t{4} * width * height);
           std::transform(rgba, rgba + image.rgba.size(), image.rgba.begin(),
                          [](auto sample) { return static_cast<std::uint8_t>(sample); });
         });
}

}  // namespace mmverify::scene
