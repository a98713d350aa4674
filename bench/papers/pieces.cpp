#include "bench/papers/pieces.hpp"

#include <cstddef>
#include <cstdint>

namespace mmverify::bench::papers {
namespace {

constexpr std::uint8_t half = 128;  ///< the least code of alpha >= 1/2
constexpr std::uint32_t none = ~std::uint32_t{0};

/// The part of each texel, and the sizes of the parts.
struct Parts {
  std::vector<std::uint32_t> of;
  std::vector<std::size_t> sizes;
};

/// Gives the part that holds texel `first` its number.
void fill(const AlphaTexture& texture, std::size_t first, Parts& parts) {
  const auto number = static_cast<std::uint32_t>(parts.sizes.size());
  const auto width = static_cast<std::size_t>(texture.width),
             height = static_cast<std::size_t>(texture.height);
  std::size_t& size = parts.sizes.emplace_back(0);
  std::vector<std::size_t> open{first};
  parts.of[first] = number;
  while (!open.empty()) {
    const std::size_t at = open.back(), x = at % width, y = at / width;
    open.pop_back();
    ++size;
    for (std::size_t row = y == 0 ? 0 : y - 1; row < height && row <= y + 1; ++row)
      for (std::size_t column = x == 0 ? 0 : x - 1; column < width && column <= x + 1; ++column) {
        const std::size_t next = column + width * row;
        if (parts.of[next] != none || texture.alpha[next] < half) continue;
        parts.of[next] = number;
        open.push_back(next);
      }
  }
}

}  // namespace

std::vector<AlphaTexture> pieces(const AlphaTexture& texture, double least) {
  Parts parts{.of = std::vector<std::uint32_t>(texture.alpha.size(), none), .sizes = {}};
  double opaque = 0;
  for (std::size_t at = 0; at < texture.alpha.size(); ++at) {
    if (texture.alpha[at] < half) continue;
    ++opaque;
    if (parts.of[at] == none) fill(texture, at, parts);
  }
  std::vector<AlphaTexture> all;
  for (std::uint32_t number = 0; number < parts.sizes.size(); ++number) {
    if (static_cast<double>(parts.sizes[number]) < least * opaque) continue;
    AlphaTexture& one = all.emplace_back(texture);
    for (std::size_t at = 0; at < one.alpha.size(); ++at)
      if (parts.of[at] != none && parts.of[at] != number) one.alpha[at] = 0;
  }
  return all;
}

}  // namespace mmverify::bench::papers
