#include "impl/bake/texture/bits.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/bake/texture/bits.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Compiled once for each target.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sets bit x of bytes if row[x] >= least.  Domain: least is a Texel.
template <class Texel>
HWY_INLINE void compare(const Texel* row, std::size_t width, Texel least, std::uint8_t* bytes) {
#if HWY_TARGET == HWY_SCALAR
  std::memset(bytes, 0, (width + 7) / 8);
  for (std::size_t x = 0; x < width; ++x)
    bytes[x / 8] = static_cast<std::uint8_t>(bytes[x / 8] | (row[x] >= least) << (x % 8));
#else
  const hn::ScalableTag<Texel> d;
  const std::size_t lanes = hn::Lanes(d);
  static_assert(hn::MaxLanes(hn::ScalableTag<Texel>()) >= 8);
  // A texel is at least the limit if it is the greater of the two; not all targets compare unsigned numbers otherwise.
  const auto marked = [&d, limit = hn::Set(d, least)](const Texel* from) HWY_ATTR {
    const auto texels = hn::LoadU(d, from);
    return hn::Eq(hn::Max(texels, limit), texels);
  };
  std::size_t x = 0;
  for (; x + lanes <= width; x += lanes) hn::StoreMaskBits(d, marked(row + x), bytes + x / 8);
  if (x == width) return;
  std::array<Texel, hn::MaxLanes(hn::ScalableTag<Texel>())> last{};
  std::copy(row + x, row + width, last.begin());
  hn::StoreMaskBits(d, marked(last.data()), bytes + x / 8);
#endif
}

void AtLeast8(const std::uint8_t* row, std::size_t width, std::uint8_t least, std::uint8_t* bytes) {
  compare(row, width, least, bytes);
}
void AtLeast16(const std::uint16_t* row, std::size_t width, std::uint16_t least, std::uint8_t* bytes) {
  compare(row, width, least, bytes);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::bake::detail {

HWY_EXPORT(AtLeast8);
HWY_EXPORT(AtLeast16);

template <class Texel>
void at_least(const Texel* row, std::size_t width, std::int32_t least, std::uint8_t* bytes) {
  const std::size_t size = (width + 7) / 8;
  if (least > std::numeric_limits<Texel>::max()) {
    std::memset(bytes, 0, size);
    return;
  }
  const auto limit = static_cast<Texel>(std::max(least, 0));
  if constexpr (sizeof(Texel) == 1)
    HWY_DYNAMIC_DISPATCH(AtLeast8)(row, width, limit, bytes);
  else
    HWY_DYNAMIC_DISPATCH(AtLeast16)(row, width, limit, bytes);
  if (width % 8 != 0) bytes[size - 1] = static_cast<std::uint8_t>(bytes[size - 1] & ((1u << width % 8) - 1));
}
template void at_least<std::uint8_t>(const std::uint8_t*, std::size_t, std::int32_t, std::uint8_t*);
template void at_least<std::uint16_t>(const std::uint16_t*, std::size_t, std::int32_t, std::uint8_t*);

}  // namespace mmverify::impl::bake::detail
#endif
