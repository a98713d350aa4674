#include "impl/attribute/compress/layout.hpp"

#include <algorithm>

#include "impl/attribute/order.hpp"

namespace mmverify::impl::attribute {
namespace detail {

std::vector<TripleCorners> triple_corners(std::uint32_t level) {
  std::vector<TripleCorners> all;
  if (level == 0) return all;
  all.reserve((vertex_count(level) - 3) / 3);
  for (std::uint32_t m = 1; m <= level; ++m)
    for (std::uint32_t x = vertex_count(m - 1); x < vertex_count(m); x += 3) {
      // The first vertex of a triple lies on the edge w-v: i even, j odd.
      const Vertex first = bird_vertex(x, m);
      const std::uint32_t a = first.i / 2, b = first.j / 2;
      all.push_back({bird_index(a, b, m - 1), bird_index(a + 1, b, m - 1), bird_index(a, b + 1, m - 1)});
    }
  return all;
}

PackedLayout::PackedLayout(const PackedShape& shape) {
  plain_bytes(shape);
  const std::uint32_t n = shape.level;
  roots = shape.at == MapAt::faces ? 1 : 3;
  values = static_cast<std::uint32_t>(values_of_map(shape.at, n));
  residuals = values - roots;
  for (std::uint32_t m = 1; m <= n + 1 && m <= max_packed_level + 1; ++m)
    first_triple[m] = (static_cast<std::uint32_t>(values_of_map(shape.at, m - 1)) - roots) / 3;
  for (std::uint32_t m = 1; m <= n; ++m) {
    const std::uint32_t triples = first_triple[m + 1] - first_triple[m];
    if (m == 2) {
      lengths.front() = static_cast<std::uint8_t>(lengths.front() + triples);
      continue;
    }
    first_block[m] = static_cast<std::uint32_t>(lengths.size());
    for (std::uint32_t k = 0; k < triples; k += triples_of_block)
      lengths.push_back(static_cast<std::uint8_t>(std::min(triples - k, triples_of_block)));
  }
  blocks = std::uint64_t{shape.maps} * lengths.size();
  starts_at = std::uint64_t{shape.maps} * roots * shape.channels;
  widths_at = starts_at + (blocks + blocks_of_start - 1) / blocks_of_start * 4;
  bits_at = widths_at + (blocks * shape.channels + 1) / 2;
}

void PackedLayout::add_corners(const PackedShape& shape) {
  if (shape.at == MapAt::vertices && shape.maps != 0) corners = triple_corners(shape.level);
}

}  // namespace detail

std::uint64_t values_of_map(MapAt at, std::uint32_t level) noexcept {
  return at == MapAt::faces ? std::uint64_t{1} << (2 * level) : vertex_count(level);
}

std::uint64_t plain_bytes(const PackedShape& shape) {
  const auto refuse = [](const std::string& what) {
    throw std::invalid_argument("attribute::PackedShape: " + what);
  };
  if (shape.at != MapAt::faces && shape.at != MapAt::vertices) refuse("neither faces nor vertices");
  if (shape.level > max_packed_level) refuse("level " + std::to_string(shape.level) + "; 0 to 12 would do");
  if (shape.channels < 1 || shape.channels > 4)
    refuse(std::to_string(shape.channels) + " channels; 1 to 4 would do");
  for (std::uint32_t c = 0; c < 4; ++c)
    if (shape.error[c] > (c < shape.channels ? max_packed_error : 0))
      refuse("error " + std::to_string(shape.error[c]) + " of channel " + std::to_string(c) +
             "; 0 to 127 would do, of no channel 0");
  const std::uint64_t of_map = values_of_map(shape.at, shape.level) * shape.channels;
  if (shape.maps > (std::uint64_t{1} << 31) / of_map)
    refuse(std::to_string(shape.maps) + " maps; up to 2^31 codes would do");
  return shape.maps * of_map;
}

BadPacked::BadPacked(std::uint64_t byte, const std::string& found, const std::string& would_do)
    : std::runtime_error("byte " + std::to_string(byte) + ": " + found + "; " + would_do + " would do"),
      byte_(byte),
      found_(found),
      would_do_(would_do) {}

}  // namespace mmverify::impl::attribute
