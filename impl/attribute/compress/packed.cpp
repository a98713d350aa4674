// Bytes to maps, and the check of bytes.
#include <algorithm>
#include <bit>
#include <utility>

#include "impl/attribute/compress/bits.hpp"
#include "impl/attribute/compress/residuals.hpp"

namespace mmverify::impl::attribute {
namespace {

std::string count_of(std::uint64_t x) { return std::to_string(x); }

/// Throws BadPacked for lengths, starts, widths and unused bits that pack() does not write.
void check_parts(const PackedShape& shape, const detail::PackedLayout& layout,
                 std::span<const std::uint8_t> bytes) {
  const std::uint32_t C = shape.channels;
  if (bytes.size() < layout.bits_at)
    throw BadPacked(bytes.size(), "the end of the input", count_of(layout.bits_at) + " bytes and more");
  for (std::uint64_t k = 0; k < layout.starts_at; ++k)
    if (const std::uint32_t last = detail::last_number(shape.error[k % C]);
        bytes[static_cast<std::size_t>(k)] > last)
      throw BadPacked(k, "root " + count_of(bytes[static_cast<std::size_t>(k)]), "0 to " + count_of(last));
  std::uint64_t bits = 0;
  for (std::uint64_t block = 0; block < layout.blocks; ++block) {
    if (block % detail::blocks_of_start == 0) {
      const std::uint64_t at = layout.starts_at + block / detail::blocks_of_start * 4;
      if (detail::word_from(bytes, at) != bits)
        throw BadPacked(at, "start " + count_of(detail::word_from(bytes, at)), count_of(bits));
    }
    std::uint32_t widths = 0;
    for (std::uint64_t half = block * C; half < (block + 1) * C; ++half) {
      const std::uint32_t width = detail::half_from(bytes, layout.widths_at, half);
      if (width > detail::widest)
        throw BadPacked(layout.widths_at + half / 2, "width " + count_of(width),
                        "0 to " + count_of(detail::widest));
      widths += width;
    }
    bits +=
        std::uint64_t{3} * layout.lengths[static_cast<std::size_t>(block % layout.lengths.size())] * widths;
  }
  if (layout.blocks * C % 2 != 0 && detail::half_from(bytes, layout.widths_at, layout.blocks * C) != 0)
    throw BadPacked(layout.bits_at - 1, "a width of no block", "0");
  const std::uint64_t size = layout.bits_at + (bits + 7) / 8;
  if (bytes.size() != size)
    throw BadPacked(std::min<std::uint64_t>(bytes.size(), size),
                    bytes.size() < size ? "the end of the input" : "bytes after the end",
                    count_of(size) + " bytes");
  if (bits % 8 != 0 && bytes.back() >> bits % 8 != 0)
    throw BadPacked(size - 1, "an unused bit that is set", "0");
}

/// Reads the blocks of maps one after the other.
class BlockReader {
 public:
  BlockReader(const PackedShape& shape, const detail::PackedLayout& layout,
              std::span<const std::uint8_t> bytes)
      : shape_(shape),
        layout_(layout),
        bytes_(bytes),
        residuals_(std::size_t{layout.residuals} * shape.channels) {}

  /// Goes to the first block of a map.
  void seek(std::uint32_t map) noexcept {
    block_ = std::uint64_t{map} * layout_.lengths.size();
    bit_ = 0;
    if (layout_.lengths.empty()) return;
    std::uint64_t block = block_ / detail::blocks_of_start * detail::blocks_of_start;
    bit_ = detail::word_from(bytes_, layout_.starts_at + block / detail::blocks_of_start * 4);
    for (; block < block_; ++block)
      for (std::uint32_t c = 0; c < shape_.channels; ++c)
        bit_ += std::uint64_t{3} * layout_.lengths[static_cast<std::size_t>(block % layout_.lengths.size())] *
                detail::half_from(bytes_, layout_.widths_at, block * shape_.channels + c);
  }

  /// Reads the next map's residuals, and calls told(channel, width, least width, bit behind it) for each block and
  /// channel.
  template <class Told>
  void next(Told told) {
    std::size_t first = 0;
    for (const std::uint8_t length : layout_.lengths) {
      for (std::uint32_t c = 0; c < shape_.channels; ++c) {
        const std::uint32_t width =
            detail::half_from(bytes_, layout_.widths_at, block_ * shape_.channels + c);
        std::uint32_t any = 0;
        std::int32_t* const out = residuals_.data() + std::size_t{c} * layout_.residuals + first;
        for (std::size_t k = 0; k < 3 * std::size_t{length}; ++k, bit_ += width) {
          const std::uint32_t x = detail::bits_from(bytes_, 8 * layout_.bits_at + bit_, width);
          any |= x;
          out[k] = detail::unfolded(x);
        }
        told(c, width, static_cast<std::uint32_t>(std::bit_width(any)), bit_);
      }
      first += 3 * std::size_t{length};
      ++block_;
    }
  }

  std::span<const std::int32_t> residuals(std::uint32_t c) const noexcept {
    return std::span(residuals_).subspan(std::size_t{c} * layout_.residuals, layout_.residuals);
  }

 private:
  const PackedShape& shape_;
  const detail::PackedLayout& layout_;
  std::span<const std::uint8_t> bytes_;
  std::vector<std::int32_t> residuals_;
  std::uint64_t block_ = 0, bit_ = 0;
};

/// Writes a map's roots, of one channel, to the front of `numbers`.
void roots_into(const PackedShape& shape, const detail::PackedLayout& layout,
                std::span<const std::uint8_t> bytes, std::uint32_t map, std::uint32_t c,
                std::span<std::int32_t> numbers) noexcept {
  for (std::size_t r = 0; r < layout.roots; ++r)
    numbers[r] = bytes[(std::size_t{map} * layout.roots + r) * shape.channels + c];
}

/// Throws BadPacked for a block wider than its residuals need, or for residuals that make no codes.
void check_values(const PackedShape& shape, const detail::PackedLayout& layout,
                  std::span<const std::uint8_t> bytes) {
  BlockReader reader(shape, layout, bytes);
  std::vector<std::int32_t> numbers(layout.values);
  std::uint64_t half = 0, begun = 0;
  for (std::uint32_t map = 0; map < shape.maps; ++map) {
    const std::uint64_t first_byte = layout.bits_at + begun / 8;
    reader.next([&](std::uint32_t, std::uint32_t width, std::uint32_t needed, std::uint64_t bit) {
      if (needed != width)
        throw BadPacked(layout.widths_at + half / 2, "width " + count_of(width), count_of(needed));
      ++half;
      begun = bit;
    });
    for (std::uint32_t c = 0; c < shape.channels; ++c) {
      roots_into(shape, layout, bytes, map, c, numbers);
      from_residuals(shape, layout, reader.residuals(c), numbers);
      const auto last = static_cast<std::int32_t>(detail::last_number(shape.error[c]));
      for (std::size_t x = 0; x < numbers.size(); ++x)
        if (numbers[x] < 0 || numbers[x] > last)
          throw BadPacked(first_byte,
                          "residuals that make " + std::to_string(numbers[x]) + " of value " + count_of(x) +
                              " of map " + count_of(map) + ", channel " + count_of(c),
                          "0 to " + count_of(static_cast<std::uint64_t>(last)));
    }
  }
}

}  // namespace

PackedMaps::PackedMaps(const PackedShape& shape, std::span<const std::uint8_t> bytes)
    : shape_(shape), bytes_(bytes) {
  auto layout = std::make_unique<detail::PackedLayout>(shape);
  check_parts(shape_, *layout, bytes_);
  layout->add_corners(shape);
  check_values(shape_, *layout, bytes_);
  layout_ = std::move(layout);
}
PackedMaps::~PackedMaps() = default;
PackedMaps::PackedMaps(PackedMaps&&) noexcept = default;
PackedMaps& PackedMaps::operator=(PackedMaps&&) noexcept = default;

void PackedMaps::map(std::uint32_t map, std::span<std::uint8_t> out) const {
  const detail::PackedLayout& layout = *layout_;
  const std::size_t C = shape_.channels;
  if (map >= shape_.maps || out.size() != layout.values * C)
    throw std::invalid_argument("attribute::PackedMaps: map " + count_of(map) + " into " +
                                count_of(out.size()) + " codes");
  BlockReader reader(shape_, layout, bytes_);
  reader.seek(map);
  reader.next([](std::uint32_t, std::uint32_t, std::uint32_t, std::uint64_t) {});
  std::vector<std::int32_t> numbers(layout.values);
  for (std::uint32_t c = 0; c < C; ++c) {
    roots_into(shape_, layout, bytes_, map, c, numbers);
    from_residuals(shape_, layout, reader.residuals(c), numbers);
    const std::int32_t step = 2 * shape_.error[c] + 1;
    for (std::size_t x = 0; x < layout.values; ++x)
      out[x * C + c] = static_cast<std::uint8_t>(std::min(255, step * numbers[x]));
  }
}

std::vector<std::uint8_t> PackedMaps::codes() const {
  const std::size_t of_map = std::size_t{layout_->values} * shape_.channels;
  std::vector<std::uint8_t> all(shape_.maps * of_map);
  for (std::uint32_t k = 0; k < shape_.maps; ++k) map(k, std::span(all).subspan(k * of_map, of_map));
  return all;
}

}  // namespace mmverify::impl::attribute
