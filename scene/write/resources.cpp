#include "scene/write/resources.hpp"

#include <algorithm>
#include <string_view>

#include "scene/read/bad_scene.hpp"
#include "scene/read/meshopt.hpp"
#include "scene/read/resource.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;
using namespace std::string_view_literals;

/// The new number of a buffer, and where its bytes begin there.
struct NewPlace {
  std::size_t buffer, start;
};

void move_view(Json& view, const std::vector<NewPlace>& places) {
  const NewPlace& to = places[view["buffer"].get<std::size_t>()];
  view["buffer"] = to.buffer;
  if (to.start != 0) view["byteOffset"] = view.value("byteOffset", std::size_t{0}) + to.start;
}

/// The type of an image by its first bytes.
std::string_view type_by_content(std::span<const unsigned char> bytes) {
  struct Magic {
    std::size_t at;
    std::string_view bytes, type;
  };
  constexpr Magic known[] = {{0, "\x89PNG\r\n\x1a\n"sv, "image/png"}, {0, "\xff\xd8\xff"sv, "image/jpeg"},
                             {8, "WEBPVP8"sv, "image/webp"},          {0, "\xabKTX 20\xbb"sv, "image/ktx2"},
                             {0, "DDS "sv, "image/vnd-ms.dds"},       {4, "ftypavif"sv, "image/avif"}};
  for (const Magic& magic : known)
    if (bytes.size() >= magic.at + magic.bytes.size() &&
        std::equal(magic.bytes.begin(), magic.bytes.end(),
                   bytes.begin() + static_cast<std::ptrdiff_t>(magic.at),
                   [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; }))
      return magic.type;
  return "";
}

std::string type_of(std::span<const unsigned char> bytes, const Json& image, const std::string& uri) {
  if (const std::string_view type = type_by_content(bytes); !type.empty()) return std::string(type);
  if (image.contains("mimeType")) return image["mimeType"].get<std::string>();
  if (is_data_uri(uri)) return uri.substr(5, uri.find(';') - 5);
  return "";
}

}  // namespace

void embed_buffers(const Document& document, const Buffers& buffers, Json& json, BinaryChunk& binary) {
  std::vector<NewPlace> places;
  for (std::size_t k = 0; k < buffers.all().size(); ++k)
    places.push_back(buffers.is_placeholder(k) ? NewPlace{binary.add_placeholder(json["buffers"][k]), 0}
                                               : NewPlace{0, binary.append(buffers.all()[k])});
  const auto views = json.find("bufferViews");
  if (views == json.end()) return;
  for (std::size_t k = 0; k < views->size(); ++k) {
    buffers.check_view(k);  // it lies within its own buffer, and so in nothing else of the new one
    Json& view = (*views)[k];
    move_view(view, places);
    // This extension alone names buffers: it has the same bytes, compressed.
    for (const MeshoptView& compressed : meshopt_views(document, view, place("bufferView", k)))
      move_view(view["extensions"][compressed.extension], places);
  }
}

void embed_images(const Document& document, Json& json, BinaryChunk& binary) {
  const auto images = json.find("images");
  if (images == json.end()) return;
  for (std::size_t k = 0; k < images->size(); ++k) {
    Json& image = (*images)[k];
    if (image.contains("bufferView")) continue;
    const std::string uri = image.value("uri", std::string()), name = image.value("name", std::string());
    const bool has_file = !is_data_uri(uri);
    const std::string at = place("image", k, name.empty() && has_file ? uri : name);
    if (uri.empty()) throw BadScene(document.file, at, "neither a URI nor a bufferView");
    const Bytes bytes = read_resource(document, uri, at);
    const std::string type = type_of(bytes, image, uri);
    if (type.empty())
      throw BadScene(document.file, at,
                     "of no known type; a mimeType would say it, and a GLB has to name it");
    image.erase("uri");
    image["bufferView"] = binary.add_view(bytes);
    image["mimeType"] = type;
    // The name becomes the URI from which the image came.
    if (name.empty() && has_file) image["name"] = uri;
  }
}

}  // namespace mmverify::scene
