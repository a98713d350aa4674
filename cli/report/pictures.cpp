#include "cli/report/pictures.hpp"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/attribute/picture.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/file.hpp"
#include "scene/read/image.hpp"
#include "scene/write/png.hpp"

namespace mmverify::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Three tiles of 512 and the gaps between them: enough for a page of 1280 pixels, in a megabyte or two.
constexpr std::uint32_t longest_shown = 1560;

/// Source: RFC 4648, section 4.
std::string base64(std::span<const unsigned char> bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j) three = three << 8 | (k + j < bytes.size() ? bytes[k + j] : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += k + j <= bytes.size() ? digits[three >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

std::string shown_picture(const std::string& result, const std::string& named) {
  std::filesystem::path path = named;
  std::error_code none;
  if (path.is_relative() && !std::filesystem::exists(path, none))
    path = std::filesystem::path(result).parent_path() / path;
  mmverify::scene::ColourImage image;
  mmverify::scene::decode_colour(mmverify::scene::read_file(path, named, "picture"), image, named, "picture");
  const mmverify::scene::RgbPicture small = mmverify::scene::made_smaller(image, longest_shown);
  return base64(mmverify::scene::png(small.width, small.height, small.rgb));
}

/// The pictures that a result names, each with its number; for views they are in the rows.
std::vector<std::pair<std::size_t, std::string>> named_by(const Json& result) {
  std::vector<std::pair<std::size_t, std::string>> files;
  const bool views = result.value("topic", "") == "views";
  const auto list = result.find(views ? "rows" : "pictures");
  if (list == result.end()) return files;
  const char* const key = views ? "picture" : "file";
  for (std::size_t k = 0; k < list->size(); ++k)
    if ((*list)[k].contains(key)) files.emplace_back(k, (*list)[k][key]);
  return files;
}

}  // namespace

Json pictures_of(const std::vector<ReportInput>& inputs) {
  Json pictures = Json::array();
  for (std::size_t file = 0; file < inputs.size(); ++file)
    for (const auto& [number, name] : named_by(inputs[file].content)) {
      Json picture{{"file", file}, {"picture", number}};
      try {
        picture["png"] = shown_picture(inputs[file].name, name);
      } catch (const mmverify::scene::BadScene& bad) {
        picture["why"] = bad.what();
      }
      pictures.push_back(std::move(picture));
    }
  return {{"pictures", std::move(pictures)}};
}

}  // namespace mmverify::cli
