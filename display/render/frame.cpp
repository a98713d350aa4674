#include "display/render/frame.hpp"

#include <bit>
#include <stdexcept>

namespace mmverify::render {
Counts& Counts::operator+=(const Counts& other) {
  rays += other.rays;
  shadow_rays += other.shadow_rays;
  ambient_rays += other.ambient_rays;
  candidates += other.candidates;
  ignored += other.ignored;
  opaque += other.opaque;
  shader += other.shader;
  planned += other.planned;
  met += other.met;
  fetches += other.fetches;
  return *this;
}

bool same(const Pixel& a, const Pixel& b) {
  return a.primary == b.primary && a.lit == b.lit && a.open == b.open;
}

std::uint64_t differing(const Frame& a, const Frame& b) {
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument("differing: frames of two sizes");
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < a.pixels.size(); ++k) count += !same(a.pixels[k], b.pixels[k]);
  return count;
}

std::uint64_t digest(const Frame& frame) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](std::uint32_t word) {
    for (unsigned k = 0; k < 4; ++k) hash = (hash ^ (word >> (8 * k) & 255)) * 0x100000001b3u;
  };
  for (const Pixel& pixel : frame.pixels) {
    add(std::bit_cast<std::uint32_t>(pixel.primary.t));
    add(pixel.primary.instance);
    add(pixel.primary.geometry);
    add(pixel.primary.triangle);
    add(pixel.lit);
    if (frame.ambient == 0) continue;
    add(static_cast<std::uint32_t>(pixel.open));
    add(static_cast<std::uint32_t>(pixel.open >> 32));
  }
  return hash;
}

}  // namespace mmverify::render
