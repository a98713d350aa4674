#include "bench/tree/textures.hpp"

#include <algorithm>
#include <cmath>

#include "impl/index/index.hpp"

namespace mmverify::bench {
namespace {

using impl::tree::Format;
using impl::tree::Level;

struct Half {
  const AlphaTexture& texture;
  bool second;

  bool opaque(double u, double v) const {
    if (second) u = 1 - u, v = 1 - v;
    const auto texel = [](double x, int size) {
      return std::clamp(static_cast<int>(std::floor(x * size)), 0, size - 1);
    };
    const auto row =
        static_cast<std::size_t>(texel(v, texture.height)) * static_cast<std::size_t>(texture.width);
    return texture.alpha[row + static_cast<std::size_t>(texel(u, texture.width))] >= 128;
  }
};

std::vector<std::uint8_t> map_of(const Half& half, Level level, Format bits) {
  const auto b = static_cast<std::uint32_t>(bits);
  std::vector<std::uint8_t> map(static_cast<std::size_t>(((std::uint64_t{b} << (2 * level)) + 7) / 8));
  const double side = std::ldexp(1.0, -static_cast<int>(level));
  for (std::uint64_t k = 0; k < std::uint64_t{1} << (2 * level); ++k) {
    const auto corners = impl::index::corners(static_cast<std::uint32_t>(k), level);
    double u = 0, v = 0;
    for (const auto& corner : corners) u += corner.i * side / 3, v += corner.j * side / 3;
    const bool opaque = half.opaque(u, v);
    bool agree = true;
    if (b == 2)
      for (const auto& corner : corners)
        agree = agree && half.opaque(corner.i * side, corner.j * side) == opaque;
    const std::uint32_t state = (opaque ? 1u : 0u) + (agree ? 0u : 2u);
    map[k * b / 8] = static_cast<std::uint8_t>(map[k * b / 8] | state << (k * b % 8));
  }
  return map;
}

}  // namespace

std::vector<std::vector<std::uint8_t>> texture_maps(const std::vector<AlphaTexture>& textures, Level level,
                                                    Format bits) {
  std::vector<std::vector<std::uint8_t>> maps;
  for (const AlphaTexture& texture : textures)
    for (const bool second : {false, true}) maps.push_back(map_of({texture, second}, level, bits));
  return maps;
}

}  // namespace mmverify::bench
