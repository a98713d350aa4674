// Maps to bytes, and the entropy of their residuals.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "impl/attribute/compress/bits.hpp"
#include "impl/attribute/compress/residuals.hpp"

namespace mmverify::impl::attribute {
namespace {

/// Calls take(map, channel, roots, residuals) for each channel of each map.
template <class Take>
void each_channel(const PackedShape& shape, detail::PackedLayout& layout, std::span<const std::uint8_t> codes,
                  Take take) {
  if (codes.size() != plain_bytes(shape))
    throw std::invalid_argument("attribute::pack: " + std::to_string(codes.size()) + " codes; " +
                                std::to_string(plain_bytes(shape)) + " would do");
  layout.add_corners(shape);
  std::vector<std::int32_t> numbers(layout.values), residuals(layout.residuals);
  const std::size_t C = shape.channels;
  for (std::uint32_t map = 0; map < shape.maps; ++map)
    for (std::uint32_t c = 0; c < C; ++c) {
      const std::uint8_t* const first = codes.data() + std::size_t{map} * layout.values * C + c;
      const std::int32_t error = shape.error[c], step = 2 * error + 1;
      for (std::size_t x = 0; x < layout.values; ++x) numbers[x] = (first[x * C] + error) / step;
      to_residuals(shape, layout, numbers, residuals);
      take(map, c, std::span<const std::int32_t>(numbers).first(layout.roots),
           std::span<const std::int32_t>(residuals));
    }
}

double bits_of_counts(const std::unordered_map<std::int32_t, std::uint64_t>& counts) {
  std::vector<std::uint64_t> sorted;  // sorted, so that the sum is the same everywhere
  std::uint64_t all = 0;
  for (const auto& [what, count] : counts) {
    sorted.push_back(count);
    all += count;
  }
  std::sort(sorted.begin(), sorted.end());
  double bits = 0;
  for (const std::uint64_t count : sorted)
    bits += static_cast<double>(count) * std::log2(static_cast<double>(all) / static_cast<double>(count));
  return bits;
}

}  // namespace

std::vector<std::uint8_t> pack(const PackedShape& shape, std::span<const std::uint8_t> codes) {
  detail::PackedLayout layout(shape);
  const std::size_t C = shape.channels;
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(layout.bits_at));
  detail::BitWriter bits;
  std::vector<std::vector<std::int32_t>> of_map(C);
  std::uint64_t block = 0;
  each_channel(
      shape, layout, codes, [&](std::uint32_t map, std::uint32_t channel, auto roots, auto residuals) {
        for (std::size_t r = 0; r < roots.size(); ++r)
          bytes[(map * roots.size() + r) * C + channel] = static_cast<std::uint8_t>(roots[r]);
        of_map[channel].assign(residuals.begin(), residuals.end());
        if (channel + 1 < C) return;
        std::size_t first = 0;
        for (const std::uint8_t length : layout.lengths) {
          if (block % detail::blocks_of_start == 0) {
            if (bits.bits() >> 32 != 0)
              throw std::invalid_argument("attribute::pack: residuals of 2^32 bits and more");
            for (std::uint64_t k = 0; k < 4; ++k)
              bytes[static_cast<std::size_t>(layout.starts_at + block / detail::blocks_of_start * 4 + k)] =
                  static_cast<std::uint8_t>(bits.bits() >> (8 * k));
          }
          const std::size_t end = first + 3 * std::size_t{length};
          for (std::size_t c = 0; c < C; ++c) {
            std::uint32_t any = 0;
            for (std::size_t k = first; k < end; ++k) any |= detail::folded(of_map[c][k]);
            const auto width = static_cast<std::uint32_t>(std::bit_width(any));
            const std::uint64_t half = block * C + c;
            std::uint8_t& two = bytes[static_cast<std::size_t>(layout.widths_at + half / 2)];
            two = static_cast<std::uint8_t>(two | width << (4 * (half % 2)));
            for (std::size_t k = first; k < end; ++k) bits.put(detail::folded(of_map[c][k]), width);
          }
          first = end;
          ++block;
        }
      });
  const auto& tail = bits.finished();
  bytes.insert(bytes.end(), tail.begin(), tail.end());
  return bytes;
}

double residual_entropy(const PackedShape& shape, std::span<const std::uint8_t> codes) {
  detail::PackedLayout layout(shape);
  std::array<std::unordered_map<std::int32_t, std::uint64_t>, 4> roots, residuals;
  each_channel(shape, layout, codes, [&](std::uint32_t, std::uint32_t c, auto of_roots, auto of_levels) {
    for (const std::int32_t r : of_roots) ++roots[c][r];
    for (const std::int32_t r : of_levels) ++residuals[c][r];
  });
  double bits = 0;
  for (std::size_t c = 0; c < 4; ++c) bits += bits_of_counts(roots[c]) + bits_of_counts(residuals[c]);
  return bits;
}

}  // namespace mmverify::impl::attribute
