#include "impl/bake/bake.hpp"

#include <stdexcept>

#include "impl/bake/square/map.hpp"
#include "impl/bake/square/sampler.hpp"

namespace mmverify::impl::bake {

std::optional<Box> opaque_box(const AlphaView& texture, Cutoff cutoff) {
  if (texture.width == 0 || texture.height == 0) return std::nullopt;
  const detail::Sampler sampler(texture, whole(texture), cutoff, 1);
  std::uint32_t left = texture.width, right = 0, top = texture.height, bottom = 0;
  for (std::uint32_t y = 0; y < texture.height; ++y) {
    const std::uint8_t* const row = sampler.row(y);
    const auto is_opaque = [&](std::uint32_t x) { return row[x] >= sampler.least_opaque; };
    std::uint32_t from = 0;
    while (from < texture.width && !is_opaque(from)) ++from;
    if (from == texture.width) continue;
    std::uint32_t to = texture.width;
    while (!is_opaque(to - 1)) --to;
    left = std::min(left, from);
    right = std::max(right, to);
    top = std::min(top, y);
    bottom = y + 1;
  }
  if (bottom == 0) return std::nullopt;
  return Box{left, top, right - left, bottom - top};
}

void detail::check(const AlphaView& texture, const Box& box, Cutoff cutoff, std::uint32_t side,
                   std::size_t states, std::size_t expected) {
  if (texture.width == 0 || texture.width > 16384 || texture.height == 0 || texture.height > 16384)
    throw std::invalid_argument("bake: a texture has 1 to 16384 texels along each side");
  if (cutoff.denominator == 0) throw std::invalid_argument("bake: a cutoff over 0");
  if (box.width == 0 || box.width > texture.width || box.x > texture.width - box.width || box.height == 0 ||
      box.height > texture.height || box.y > texture.height - box.height)
    throw std::invalid_argument("bake: the box is empty or not within the texture");
  if (side == 0 || side > max_side) throw std::invalid_argument("bake: a map has 1 to 256 regions a side");
  if (states != expected) throw std::invalid_argument("bake: room for another number of states");
}

}  // namespace mmverify::impl::bake
