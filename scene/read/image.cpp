#include "scene/read/image.hpp"

#include <stb/stb_image.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "scene/read/bad_scene.hpp"
#include "scene/read/png.hpp"

namespace mmverify::scene {
namespace {

using ImageBytes = std::span<const unsigned char>;

bool begins_with(ImageBytes bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

template <class Sample>
std::vector<Sample> alpha_of(const Sample* rgba, std::size_t texels) {
  std::vector<Sample> alpha(texels);
  for (std::size_t k = 0; k < texels; ++k) alpha[k] = rgba[4 * k + 3];
  return alpha;
}

/// The depth at which a PNG of 16 bits is decoded.
enum class Depth { own, eight };

/// Decodes and calls take(rgba, width, height); rgba has four channels of 8 or 16 bits a texel.
template <class Take>
void decode(ImageBytes bytes, const std::string& file, const std::string& place, Depth depth, Take take) {
  using namespace std::string_view_literals;
  const auto bad = [&](const std::string& what) { throw BadScene(file, place, what); };
  const bool png = begins_with(bytes, "\x89PNG\r\n\x1a\n"sv), jpeg = begins_with(bytes, "\xff\xd8\xff"sv);
  if (!png && !jpeg) bad("neither PNG nor JPEG");
  const int size = static_cast<int>(bytes.size());  // below 2^31, as every file here
  if (png) {
    // IHDR is the first chunk.  The library's own check of it reports less.
    constexpr std::size_t ihdr = 33;
    if (bytes.size() < ihdr || std::memcmp(bytes.data() + 12, "IHDR", 4) != 0)
      bad("a PNG without a header; truncated file?");
    const auto word = [&](std::size_t at) {
      return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 |
             std::uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
    };
    const std::uint64_t width = word(16), height = word(20);
    if (width == 0 || height == 0 || width > longest_side || height > longest_side)
      bad("a PNG of " + std::to_string(width) + " x " + std::to_string(height) + " texels; 1 to " +
          std::to_string(longest_side) + " a side are read");
    // Deflate compresses at most 1032 to 1, and a texel has at least `bits` bits.  So no small file claims
    // gigabytes.
    const std::uint64_t bits = bytes[24];
    if (width * bits / 8 * height / 1032 > bytes.size())
      bad("a PNG of " + std::to_string(width) + " x " + std::to_string(height) + " texels cannot be in " +
          std::to_string(bytes.size()) + " bytes; truncated file?");
    if (const auto damage = damage_of_png(bytes)) bad(*damage);
  }
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0)
    bad(std::string("no readable header (") + stbi_failure_reason() + "); truncated file?");
  constexpr int longest = longest_side;
  if (width <= 0 || height <= 0 || width > longest || height > longest)
    bad("a picture of " + std::to_string(width) + " x " + std::to_string(height) + " texels; 1 to " +
        std::to_string(longest) + " a side are read");
  if (const auto marked = png ? with_palette_marked(bytes) : std::vector<unsigned char>(); !marked.empty()) {
    const std::unique_ptr<stbi_uc, void (*)(void*)> grey(
        stbi_load_from_memory(marked.data(), static_cast<int>(marked.size()), &width, &height, &channels, 1),
        stbi_image_free);
    if (grey && std::memchr(grey.get(), 0xff,
                            static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) != nullptr)
      bad("a texel has a colour beyond the end of the palette; damaged file?");
  }
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

}  // namespace

void decode_alpha(ImageBytes bytes, Image& image, const std::string& file, const std::string& place) {
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
