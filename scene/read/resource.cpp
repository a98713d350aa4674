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

}  // namespace mmverify::scene
