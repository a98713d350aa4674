#include "impl/attribute/compress/residuals.hpp"

#include <cstddef>

namespace mmverify::impl::attribute::detail {
namespace {

void faces_to_residuals(std::uint32_t n, const PackedLayout& layout, std::span<std::int32_t> numbers,
                        std::span<std::int32_t> residuals) noexcept {
  for (std::uint32_t m = n; m > 0; --m) {
    std::int32_t* out = residuals.data() + 3 * std::size_t{layout.first_triple[m]};
    const std::size_t parents = std::size_t{1} << (2 * (m - 1));
    for (std::size_t k = 0; k < parents; ++k, out += 3) {
      const std::int32_t* const four = numbers.data() + 4 * k;
      const std::int32_t s = (four[0] + four[1]) >> 1, t = (four[2] + four[3]) >> 1;
      out[0] = four[0] - four[1];
      out[1] = four[2] - four[3];
      out[2] = s - t;
      numbers[k] = (s + t + 1) >> 1;
    }
  }
}

void faces_from_residuals(std::uint32_t n, const PackedLayout& layout,
                          std::span<const std::int32_t> residuals, std::span<std::int32_t> numbers) noexcept {
  for (std::uint32_t m = 1; m <= n; ++m) {
    const std::int32_t* const in = residuals.data() + 3 * std::size_t{layout.first_triple[m]};
    // The last parent comes first: children overwrite the places of later parents.
    for (std::size_t k = std::size_t{1} << (2 * (m - 1)); k-- > 0;) {
      const auto four = children_of(numbers[k], in[3 * k], in[3 * k + 1], in[3 * k + 2]);
      for (std::size_t c = 0; c < 4; ++c) numbers[4 * k + c] = four[c];
    }
  }
}

}  // namespace

void to_residuals(const PackedShape& shape, const PackedLayout& layout, std::span<std::int32_t> numbers,
                  std::span<std::int32_t> residuals) noexcept {
  if (shape.at == MapAt::faces) return faces_to_residuals(shape.level, layout, numbers, residuals);
  for (std::size_t t = 0; t < layout.corners.size(); ++t) {
    const auto& corners = layout.corners[t];
    const std::int32_t w = numbers[corners[0]], u = numbers[corners[1]], v = numbers[corners[2]];
    const std::array<std::int32_t, 3> said{between(w, v), between(u, v), between(w, u)};
    for (std::size_t e = 0; e < 3; ++e) residuals[3 * t + e] = numbers[3 + 3 * t + e] - said[e];
  }
}

void from_residuals(const PackedShape& shape, const PackedLayout& layout,
                    std::span<const std::int32_t> residuals, std::span<std::int32_t> numbers) noexcept {
  if (shape.at == MapAt::faces) return faces_from_residuals(shape.level, layout, residuals, numbers);
  for (std::size_t t = 0; t < layout.corners.size(); ++t) {
    const auto& corners = layout.corners[t];
    const std::int32_t w = numbers[corners[0]], u = numbers[corners[1]], v = numbers[corners[2]];
    const std::array<std::int32_t, 3> said{between(w, v), between(u, v), between(w, u)};
    for (std::size_t e = 0; e < 3; ++e) numbers[3 + 3 * t + e] = said[e] + residuals[3 * t + e];
  }
}

}  // namespace mmverify::impl::attribute::detail
