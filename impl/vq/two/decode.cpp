#include "impl/vq/two/layout.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq {

State region(const Block2& block, std::uint32_t x, std::uint32_t y) noexcept {
  x &= 15;
  y &= 15;
  const std::uint32_t index = detail::index_of(block, x / 2 + 8 * (y / 2));
  const std::uint64_t word = detail::last_word(block);
  const std::uint32_t q = detail::quadrant(x, y);
  const std::uint32_t k = detail::sources<2>[detail::transform(word, q)][x % 2 + 2 * (y % 2)];
  const detail::Place2 place = detail::places2[q][index][k];
  const auto checked = static_cast<std::uint32_t>(word >> place.checked) & 1,
             opaque = static_cast<std::uint32_t>(word >> place.palette) & 1;
  return static_cast<State>(detail::states_of[index][checked | opaque << 1]);
}

Map2 decode(const Block2& block) noexcept {
  const std::uint64_t word = detail::last_word(block);
  // The eight vectors of each quadrant, transformed: two rows of two regions.
  std::array<std::array<std::array<State, 4>, 8>, 4> vectors{};
  for (std::uint32_t q = 0; q < 4; ++q) {
    const auto& from = detail::sources<2>[detail::transform(word, q)];
    for (std::uint32_t index = 0; index < 3; ++index) vectors[q][index].fill(static_cast<State>(index));
    for (std::uint32_t index = 3; index < 8; ++index)
      for (std::uint32_t k = 0; k < 4; ++k)
        vectors[q][index][k] = detail::picked(word >> detail::code_at(q, index), from[k]);
  }
  Map2 map;
  for (std::uint32_t k = 0; k < 64; ++k) {
    const std::uint32_t x = 2 * (k % 8), y = 2 * (k / 8);
    const auto& v = vectors[detail::quadrant(x, y)][detail::index_of(block, k)];
    std::memcpy(&map[x + 16 * y], &v[0], 2);
    std::memcpy(&map[x + 16 * (y + 1)], &v[2], 2);
  }
  return map;
}

}  // namespace mmverify::impl::vq
