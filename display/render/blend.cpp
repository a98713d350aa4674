#include "display/render/blend.hpp"

#include <algorithm>
#include <stdexcept>

#include "display/render/camera.hpp"

namespace mmverify::render {

std::uint32_t neutral(impl::traverse::Operation operation) {
  using impl::traverse::Operation;
  return operation == Operation::min || operation == Operation::multiply ? 0xffffffff : 0;
}

std::uint32_t grey_of(std::uint32_t colour_number) {
  const std::uint32_t code = 64 + static_cast<std::uint32_t>(mixed(colour_number) % 128);
  return code * 0x010101u | 0xff000000u;
}

std::uint64_t differing(const BlendFrame& a, const BlendFrame& b) {
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument("differing: frames of two sizes");
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < a.pixels.size(); ++k)
    count += a.pixels[k].payload != b.pixels[k].payload || a.pixels[k].accepted != b.pixels[k].accepted;
  return count;
}

std::uint64_t spoiled_as_met(const BlendFrame& frame) {
  return static_cast<std::uint64_t>(
      std::count_if(frame.pixels.begin(), frame.pixels.end(),
                    [](const BlendPixel& pixel) { return pixel.payload != pixel.as_met; }));
}

}  // namespace mmverify::render
