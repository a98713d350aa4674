#include "scene/read/texture_source.hpp"

#include <vector>

#include "scene/read/bad_scene.hpp"
#include "scene/read/extensions.hpp"
#include "scene/read/image.hpp"
#include "scene/read/resource.hpp"

namespace mmverify::scene {
namespace {

constexpr const char* texture_extensions[] = {"EXT_texture_webp", "EXT_texture_avif", "MSFT_texture_dds",
                                              "KHR_texture_basisu"};

struct Alternative {
  const char* by;  ///< the extension; null for the fallback
  std::size_t image;
};

std::vector<Alternative> alternatives_of(const nlohmann::json& texture) {
  std::vector<Alternative> all;
  for (const char* name : texture_extensions)
    if (const nlohmann::json& source = member(extension(texture, name), "source");
        source.is_number_unsigned())
      all.push_back({name, source.get<std::size_t>()});
  if (texture.contains("source")) all.push_back({nullptr, texture["source"].get<std::size_t>()});
  return all;
}

std::string alternative_in_words(const Alternative& alternative) {
  const std::string image = place("image", alternative.image);
  return alternative.by == nullptr ? "the fallback " + image : image + " of " + alternative.by;
}

/// Why an image is not taken although another one follows: its kind, or its damage.
std::optional<std::string> why_passed_over(std::span<const unsigned char> bytes, PictureUse use) {
  if (auto why = why_unread(bytes, use)) return why;
  const std::string nobody = "image";
  try {
    Image alpha;
    ColourImage colour;
    if (use == PictureUse::alpha)
      decode_alpha(bytes, alpha, nobody, "");
    else
      decode_colour(bytes, colour, nobody, "");
    return std::nullopt;
  } catch (const BadScene& damaged) {
    return std::string(damaged.what()).substr(nobody.size() + 2);
  }
}

}  // namespace

TextureSource texture_source(const Document& document, const Buffers& buffers, std::size_t texture,
                             PictureUse use) {
  const nlohmann::json& json = document.json["textures"][texture];
  check_extensions(document, json, place("texture", texture));
  const std::vector<Alternative> all = alternatives_of(json);
  if (all.empty()) return {};
  if (all.size() == 1 && all[0].by == nullptr) return {all[0].image, ""};
  TextureSource taken;
  std::string others;
  for (const Alternative& alternative : all) {
    std::string other = alternative_in_words(alternative);
    if (!taken.image) {
      const std::string at = place("image", alternative.image, image_name(document, alternative.image));
      const Bytes bytes = image_bytes(document, buffers, alternative.image, at);
      const bool is_last = &alternative == &all.back();
      const auto why = is_last ? why_unread(bytes, use) : why_passed_over(bytes, use);
      if (!why) {
        taken.image = alternative.image;
        taken.note = other;
        continue;
      }
      other += " (" + *why + ")";
    }
    others += (others.empty() ? "" : ", ") + other;
  }
  const std::string at = place("texture", texture) + ": ";
  if (!taken.image)
    taken.note = at + "no image of it is read: " + others;
  else
    taken.note = others.empty() ? "" : at + taken.note + " is judged; not judged: " + others;
  return taken;
}

}  // namespace mmverify::scene
