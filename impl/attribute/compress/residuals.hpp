// One channel of a map as residuals, and back, in place: spec/attribute/compress_residuals.hpp.  Internal to impl.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "impl/attribute/compress/layout.hpp"

namespace mmverify::impl::attribute::detail {

/// The children a, b, c, d of a parent and the residuals a-b, c-d, s-t.  Shifts of negative numbers round down.
constexpr std::array<std::int32_t, 4> children_of(std::int32_t parent, std::int32_t ab, std::int32_t cd,
                                                  std::int32_t st) noexcept {
  const std::int32_t t = parent - ((st + 1) >> 1), s = t + st, b = s - (ab >> 1), d = t - (cd >> 1);
  return {b + ab, b, d + cd, d};
}

/// The prediction of a vertex between p and q.
constexpr std::int32_t between(std::int32_t p, std::int32_t q) noexcept { return (p + q + 1) >> 1; }

/// Turns a map's numbers into residuals, by triples; roots stay at the front of `numbers`, the rest of which is lost.
void to_residuals(const PackedShape& shape, const PackedLayout& layout, std::span<std::int32_t> numbers,
                  std::span<std::int32_t> residuals) noexcept;

/// Turns residuals into numbers.  Domain: `numbers` has the roots at its front, and room for the map.
void from_residuals(const PackedShape& shape, const PackedLayout& layout,
                    std::span<const std::int32_t> residuals, std::span<std::int32_t> numbers) noexcept;

/// A residual as an unsigned number, small if the residual is: 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
constexpr std::uint32_t folded(std::int32_t r) noexcept {
  return static_cast<std::uint32_t>(r) << 1 ^ static_cast<std::uint32_t>(r >> 31);
}
constexpr std::int32_t unfolded(std::uint32_t x) noexcept {
  return static_cast<std::int32_t>(x >> 1) ^ -static_cast<std::int32_t>(x & 1);
}

}  // namespace mmverify::impl::attribute::detail
