// One value of packed maps: a walk down the levels, with a triple at each.
#include <algorithm>

#include "impl/attribute/compress/bits.hpp"
#include "impl/attribute/compress/residuals.hpp"
#include "impl/attribute/order.hpp"

namespace mmverify::impl::attribute {
namespace {

using detail::bits_from;
using Numbers = std::array<std::int32_t, 4>;  ///< one a channel

/// A map's residuals, read on demand.
class TripleReader {
 public:
  TripleReader(const PackedShape& shape, const detail::PackedLayout& layout,
               std::span<const std::uint8_t> bytes, std::uint32_t map) noexcept
      : shape_(shape), layout_(layout), bytes_(bytes), map_(map) {}

  /// Goes to triple k of level m.
  void seek(std::uint32_t m, std::uint32_t k) noexcept {
    const std::uint64_t of_map = layout_.lengths.size();
    const std::uint64_t block = map_ * of_map + layout_.block_of(m, k);
    std::uint64_t at = block / detail::blocks_of_start * detail::blocks_of_start;
    std::uint64_t bit = detail::word_from(bytes_, layout_.starts_at + at / detail::blocks_of_start * 4);
    for (; at < block; ++at) {
      std::uint32_t widths = 0;
      for (std::uint32_t c = 0; c < shape_.channels; ++c) widths += width_of(at, c);
      bit += std::uint64_t{3} * length_of(at) * widths;
    }
    bit += 8 * layout_.bits_at;
    for (std::uint32_t c = 0; c < shape_.channels; ++c) {
      widths_[c] = width_of(block, c);
      bits_[c] = bit + std::uint64_t{3} * layout_.place_of(m, k) * widths_[c];
      bit += std::uint64_t{3} * length_of(block) * widths_[c];
    }
  }

  /// Residual e of the triple, of channel c.
  std::int32_t residual(std::uint32_t c, std::uint32_t e) const noexcept {
    return detail::unfolded(bits_from(bytes_, bits_[c] + std::uint64_t{e} * widths_[c], widths_[c]));
  }

  std::int32_t root(std::uint32_t r, std::uint32_t c) const noexcept {
    return bytes_[(std::size_t{map_} * layout_.roots + r) * shape_.channels + c];
  }

 private:
  std::uint32_t width_of(std::uint64_t block, std::uint32_t c) const noexcept {
    return detail::half_from(bytes_, layout_.widths_at, block * shape_.channels + c);
  }
  std::uint32_t length_of(std::uint64_t block) const noexcept {
    return layout_.lengths[static_cast<std::size_t>(block % layout_.lengths.size())];
  }

  const PackedShape& shape_;
  const detail::PackedLayout& layout_;
  std::span<const std::uint8_t> bytes_;
  std::uint32_t map_;
  std::array<std::uint32_t, 4> widths_{};
  std::array<std::uint64_t, 4> bits_{};
};

Numbers face_numbers(const PackedShape& shape, TripleReader& reader, std::uint32_t level,
                     std::uint32_t index) noexcept {
  Numbers numbers{};
  for (std::uint32_t c = 0; c < shape.channels; ++c) numbers[c] = reader.root(0, c);
  for (std::uint32_t m = 1; m <= level; ++m) {
    reader.seek(m, index >> 2 * (level - m) >> 2);
    const std::uint32_t child = index >> 2 * (level - m) & 3;
    for (std::uint32_t c = 0; c < shape.channels; ++c)
      numbers[c] = detail::children_of(numbers[c], reader.residual(c, 0), reader.residual(c, 1),
                                       reader.residual(c, 2))[child];
  }
  return numbers;
}

/// A vertex and its numbers.
struct VertexNumbers {
  Vertex at;
  Numbers numbers;
};

Numbers vertex_numbers(const PackedShape& shape, const detail::PackedLayout& layout, TripleReader& reader,
                       std::uint32_t level, std::uint32_t index) noexcept {
  std::array<VertexNumbers, 3> corners{VertexNumbers{{0, 0}, {}}, VertexNumbers{{1, 0}, {}},
                                       VertexNumbers{{0, 1}, {}}};
  for (std::uint32_t r = 0; r < 3; ++r)
    for (std::uint32_t c = 0; c < shape.channels; ++c) corners[r].numbers[c] = reader.root(r, c);
  if (index < 3) return corners[index].numbers;
  const Vertex goal = vertex_at(VertexOrder::bird, index, level);
  for (std::uint32_t m = 1; m <= level; ++m) {
    for (VertexNumbers& k : corners) k.at = {2 * k.at.i, 2 * k.at.j};
    const auto middle = [&](const VertexNumbers& p, const VertexNumbers& q) {
      VertexNumbers half{{(p.at.i + q.at.i) / 2, (p.at.j + q.at.j) / 2}, {}};
      const std::uint32_t number = bird_index(half.at.i, half.at.j, m) - 3;
      reader.seek(m, number / 3 - layout.first_triple[m]);
      for (std::uint32_t c = 0; c < shape.channels; ++c)
        half.numbers[c] = detail::between(p.numbers[c], q.numbers[c]) + reader.residual(c, number % 3);
      return half;
    };
    const auto& [base, along_u, along_v] = corners;
    const std::array<VertexNumbers, 3> middles{middle(base, along_u), middle(along_u, along_v),
                                               middle(along_v, base)};
    const std::uint32_t up = level - m;
    for (const VertexNumbers& k : middles)
      if (k.at.i << up == goal.i && k.at.j << up == goal.j) return k.numbers;
    // Goes to the child that contains the goal; a and b are the goal's steps from the base's corner, at the final
    // level.
    const bool upright = along_u.at.i > base.at.i;
    const auto steps = [upright](std::uint32_t from, std::uint32_t to) {
      return upright ? to - from : from - to;
    };
    const std::uint32_t a = steps(base.at.i << up, goal.i), b = steps(base.at.j << up, goal.j);
    const std::uint32_t half = std::uint32_t{1} << up;
    if (a >= half)
      corners = {middles[0], along_u, middles[1]};
    else if (b >= half)
      corners = {middles[2], middles[1], along_v};
    else if (a + b <= half)
      corners = {base, middles[0], middles[2]};
    else
      corners = {middles[1], middles[2], middles[0]};
  }
  return {};  // no vertex of the level
}

}  // namespace

std::array<std::uint8_t, 4> PackedMaps::value(std::uint32_t map, std::uint32_t level,
                                              std::uint32_t index) const noexcept {
  std::array<std::uint8_t, 4> codes{};
  if (map >= shape_.maps || level > shape_.level || index >= values_of_map(shape_.at, level)) return codes;
  TripleReader reader(shape_, *layout_, bytes_, map);
  const Numbers numbers = shape_.at == MapAt::faces ? face_numbers(shape_, reader, level, index)
                                                    : vertex_numbers(shape_, *layout_, reader, level, index);
  for (std::size_t c = 0; c < shape_.channels; ++c)
    codes[c] = static_cast<std::uint8_t>(std::min(255, (2 * shape_.error[c] + 1) * numbers[c]));
  return codes;
}

}  // namespace mmverify::impl::attribute
