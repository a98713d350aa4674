#include "scene/read/resource.hpp"

#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

std::filesystem::path path_of(const Document& document, const std::string& uri, const std::string& place) {
  if (document.in_memory)
    throw BadScene(document.file, place,
                   "URI '" + shown(uri) + "': a scene in memory has no files beside it");
  return beside(document.file, uri, place);
}

}  // namespace

bool is_data_uri(const std::string& uri) { return tinygltf::IsDataURI(uri); }

Bytes read_resource(const Document& document, const std::string& uri, const std::string& place) {
  if (const auto held = document.files.find(uri); held != document.files.end()) return held->second;
  if (!is_data_uri(uri)) return read_file(path_of(document, uri, place), document.file, place);
  Bytes bytes;
  std::string mime_type;
  if (!tinygltf::DecodeDataURI(&bytes, mime_type, uri, 0, false))
    throw BadScene(document.file, place,
                   "'" + shown(uri.substr(0, 40)) + "...' is no base64 data URI of a known type");
  return bytes;
}

bool is_missing(const Document& document, const std::string& uri, const std::string& place) {
  std::error_code ignored;
  return !is_data_uri(uri) && !std::filesystem::exists(path_of(document, uri, place), ignored);
}

void check_resource(const Document& document, const std::string& uri, const std::string& place) {
  if (!is_data_uri(uri)) check_file(path_of(document, uri, place), document.file, place);
}

void check_images_there(const Document& document) {
  const nlohmann::json& images = member(document.json, "images");
  constexpr std::size_t most_named = 20;
  std::string names;
  std::size_t missing = 0;
  for (std::size_t k = 0; k < images.size(); ++k) {
    const std::string uri = images[k].value("uri", std::string());
    if (uri.empty() || images[k].contains("bufferView") || !is_missing(document, uri, place("image", k, uri)))
      continue;
    if (++missing <= most_named) names += (names.empty() ? "'" : ", '") + shown(uri) + "'";
  }
  if (missing > most_named) names += " and " + std::to_string(missing - most_named) + " more";
  if (missing > 1)
    throw BadScene(document.file, "images",
                   "there are no files " + names + " beside it; is the folder complete?");
}

Bytes image_bytes(const Document& document, const Buffers& buffers, std::size_t image,
                  const std::string& at) {
  const nlohmann::json& given = document.json["images"][image];
  if (given.contains("bufferView")) {
    const auto bytes = buffers.view(given["bufferView"].get<std::size_t>());
    return {bytes.begin(), bytes.end()};
  }
  const std::string uri = given.value("uri", std::string());
  if (uri.empty()) throw BadScene(document.file, at, "neither a URI nor a bufferView");
  return read_resource(document, uri, at);
}

std::string image_name(const Document& document, std::size_t image) {
  const nlohmann::json& given = document.json["images"][image];
  const std::string uri = given.value("uri", std::string());
  return given.value("name", uri.empty() || is_data_uri(uri) ? std::string() : shown(uri));
}

}  // namespace mmverify::scene
