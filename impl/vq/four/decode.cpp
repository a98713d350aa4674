#include <array>
#include <cstdint>
#include <cstring>

#include "impl/vq/four/layout.hpp"
#include "impl/vq/vq.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/vq/four/decode.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::vq {
namespace HWY_NAMESPACE {

// Writes a transformed vector: four rows of four states, 32 apart in the map.
HWY_INLINE void lay(const std::uint8_t* vector, const std::uint8_t* sources, std::uint8_t* to) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t k = 0; k < 16; ++k) to[32 * (k / 4) + k % 4] = vector[sources[k]];
#else
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::FixedTag<std::uint8_t, 16> bytes;
  HWY_ALIGN std::uint8_t rows[16];
  hn::Store(hn::TableLookupBytes(hn::LoadU(bytes, vector), hn::LoadU(bytes, sources)), bytes, rows);
  for (std::size_t y = 0; y < 4; ++y) std::memcpy(to + 32 * y, rows + 4 * y, 4);
#endif
}

void decode_block(const std::uint8_t* block, std::uint8_t* map) {
  const detail::Codebook vectors = detail::codebook(block);
  for (std::uint32_t k = 0; k < 64; ++k) {
    const std::uint32_t x = k % 8, y = k / 8, q = (x < 4 ? 0 : 1) + (y < 4 ? 2 : 0);
    const std::uint32_t index = block[k / 2] >> (4 * (k % 2)) & 15u;
    lay(vectors[index].data(), detail::sources<4>[detail::transform4(block, q)].data(),
        map + 4 * x + 128 * y);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::vq
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::vq {

HWY_EXPORT(decode_block);

State region(const Block4& block, std::uint32_t x, std::uint32_t y) noexcept {
  x &= 31;
  y &= 31;
  const std::uint32_t k = x / 4 + 8 * (y / 4), index = block[k / 2] >> (4 * (k % 2)) & 15u;
  const std::uint32_t q = (x < 16 ? 0 : 1) + (y < 16 ? 2 : 0);
  const std::uint32_t from = detail::sources<4>[detail::transform4(block.data(), q)][x % 4 + 4 * (y % 4)];
  const detail::Place4 place = detail::places4[index][from];
  const auto bit = [&block](std::uint32_t at) { return std::uint32_t{block[at / 8]} >> (at % 8) & 1; };
  const std::uint32_t checked = bit(place.checked), opaque = bit(place.palette);
  return static_cast<State>(detail::states_of[index][checked | opaque << 1]);
}

Map4 decode(const Block4& block) noexcept {
  std::array<std::uint8_t, 1024> states;
  HWY_DYNAMIC_DISPATCH(decode_block)(block.data(), states.data());
  Map4 map;
  std::memcpy(map.data(), states.data(), sizeof map);
  return map;
}

}  // namespace mmverify::impl::vq
#endif  // HWY_ONCE
