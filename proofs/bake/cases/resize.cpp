#include "proofs/bake/cases/resize.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace mmverify::proofs::bake {
namespace {

double largest(Texel texel) { return texel == Texel::unorm8 ? 255 : 65535; }

}  // namespace

std::uint32_t converted(Texel from, Texel to, std::uint32_t bits) {
  if (from == to) return bits;
  const double value = from == Texel::float32 ? std::bit_cast<float>(bits) : bits / largest(from);
  if (to == Texel::float32) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * largest(to)));
}

std::optional<Case> resized(Case one, std::uint32_t width, std::uint32_t height, std::uint32_t mips,
                            Texel texel) {
  if (width > one.width || height > one.height || mips > one.mips) return std::nullopt;
  if (width == one.width && height == one.height && mips == one.mips && texel == one.texel) return one;
  std::vector<std::uint32_t> alpha;
  std::size_t from = 0;
  for (std::uint32_t k = 0; k < mips; ++k) {
    const std::uint32_t columns = std::max(1u, one.width >> k), rows = std::max(1u, one.height >> k);
    for (std::uint32_t j = 0; j < std::max(1u, height >> k); ++j)
      for (std::uint32_t i = 0; i < std::max(1u, width >> k); ++i)
        alpha.push_back(converted(one.texel, texel, one.alpha[from + i + std::size_t{j} * columns]));
    from += std::size_t{columns} * rows;
  }
  one.alpha = std::move(alpha);
  one.border = converted(one.texel, texel, one.border);
  one.width = width;
  one.height = height;
  one.mips = mips;
  one.texel = texel;
  return one;
}

}  // namespace mmverify::proofs::bake
