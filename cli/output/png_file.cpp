#include "cli/output/png_file.hpp"

#include <fmt/format.h>

#include <vector>

#include "scene/write/png.hpp"

namespace mmverify::cli {

void commit_png(OutputFile& file, std::uint32_t width, std::uint32_t height,
                std::span<const std::uint8_t> rgb) {
  const std::vector<unsigned char> bytes = mmverify::scene::png(width, height, rgb);
  file.commit({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string png_name(const std::string& name) {
  return name.ends_with(".png") || name.ends_with(".PNG")
             ? ""
             : fmt::format("{:.200}: pictures are PNG; name it .png", name);
}

}  // namespace mmverify::cli
