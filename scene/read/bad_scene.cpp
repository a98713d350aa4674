#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

std::string on_one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return line;
}

}  // namespace

std::string shown(std::string_view name) {
  std::size_t length = 200;  // a data URI may be megabytes
  if (name.size() <= length) return on_one_line(name);
  // A character of UTF-8 is cut before its first byte, not within.
  while (length > 196 && (static_cast<unsigned char>(name[length]) & 0xc0) == 0x80) --length;
  return on_one_line(name.substr(0, length)) + "...";
}

BadScene::BadScene(std::string_view file, std::string_view place, std::string_view what)
    : std::runtime_error(on_one_line(std::string(file) + ": " +
                                     (place.empty() ? "" : std::string(place) + ": ") + std::string(what))) {}

}  // namespace mmverify::scene
