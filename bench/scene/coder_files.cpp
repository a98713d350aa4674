#include "bench/scene/coder_files.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "scene/read/image.hpp"

namespace mmverify::bench {

namespace fs = std::filesystem;

void write_file(const std::string& path, const std::vector<unsigned char>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written to the end; is the disk full?");
}

std::vector<std::uint8_t> rgb_of_png(const std::string& path, const scene::TexturePixels& pixels,
                                     const std::string& program) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file),
                                         std::istreambuf_iterator<char>()};
  scene::ColourImage image;
  scene::decode_colour(bytes, image, path, "what " + program + " wrote");
  if (image.width != pixels.width || image.height != pixels.height)
    throw std::runtime_error(program + ": a picture of " + std::to_string(image.width) + " x " +
                             std::to_string(image.height) + " came back, of another size than went in");
  std::vector<std::uint8_t> rgb;
  rgb.reserve(pixels.rgb.size());
  for (std::size_t k = 0; k < image.rgba.size(); k += 4)
    for (std::size_t c = 0; c < 3; ++c) rgb.push_back(image.rgba[k + c]);
  return rgb;
}

void expect_size(const std::string& file, std::uint64_t bytes, const std::string& program) {
  std::error_code none;
  const std::uintmax_t written = fs::file_size(file, none);
  if (!none && written == bytes) return;
  throw std::runtime_error(program + ": a file of " + std::to_string(bytes) + " bytes was due, and " +
                           (none ? "none is there" : "one of " + std::to_string(written) + " came"));
}

}  // namespace mmverify::bench
