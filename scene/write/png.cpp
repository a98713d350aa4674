#include "scene/write/png.hpp"

#include <stb/stb_image_write.h>

#include <stdexcept>

namespace mmverify::scene {

std::vector<unsigned char> png(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgb) {
  constexpr std::uint32_t longest = 32768;
  if (width < 1 || height < 1 || width > longest || height > longest ||
      rgb.size() != std::size_t{3} * width * height)
    throw std::invalid_argument("png: rows of another size");
  std::vector<unsigned char> bytes;
  const auto append = [](void* context, void* data, int size) {
    const auto* const first = static_cast<const unsigned char*>(data);
    static_cast<std::vector<unsigned char>*>(context)->insert(
        static_cast<std::vector<unsigned char>*>(context)->end(), first, first + size);
  };
  const int stride = 3 * static_cast<int>(width);
  if (stbi_write_png_to_func(append, &bytes, static_cast<int>(width), static_cast<int>(height), 3, rgb.data(),
                             stride) == 0)
    throw std::runtime_error("png: no memory");
  return bytes;
}

}  // namespace mmverify::scene
