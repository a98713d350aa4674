#include "bench/textures/alpha_textures.hpp"

#include <stb/stb_image.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace mmverify::bench {
namespace {

namespace fs = std::filesystem;

AlphaTexture loaded(const std::string& file) {
  AlphaTexture texture;
  texture.file = file;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load(file.c_str(), &texture.width, &texture.height, &channels, 4), stbi_image_free);
  if (!pixels) throw std::runtime_error(file + ": no PNG that can be read (" + stbi_failure_reason() + ")");
  const std::size_t count =
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
  for (std::size_t k = 0; k < count; ++k) texture.alpha.push_back(pixels.get()[4 * k + 3]);
  return texture;
}

}  // namespace

std::vector<AlphaTexture> alpha_textures(const std::string& folder) {
  std::error_code error;
  fs::recursive_directory_iterator entries(folder, error);
  if (error) throw std::runtime_error(folder + ": " + error.message());
  std::vector<std::string> files;
  for (const auto& entry : entries)
    if (entry.is_regular_file() && entry.path().extension() == ".png") files.push_back(entry.path().string());
  if (files.empty()) throw std::runtime_error(folder + ": no PNG file in or below it");
  std::sort(files.begin(), files.end());
  std::vector<AlphaTexture> textures;
  for (const std::string& file : files) textures.push_back(loaded(file));
  return textures;
}

}  // namespace mmverify::bench
