#include "impl/bake/judge/samples.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/bake/judge/samples.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Compiled once for each target.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {
namespace samples {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Numbers = hn::Rebind<std::int32_t, Doubles>;
using Double = hn::Vec<Doubles>;
using Number = hn::Vec<Numbers>;

/// The bits of a mask of doubles.
template <class Mask>
HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(Doubles(), mask, bytes.data());
  return bytes[0];
}

template <class Texel>
HWY_INLINE FourSamples take(const FourWindow& in, const FourPlaces& places) {
  const Doubles d;
  const Numbers n;
  constexpr int bits = 8 * sizeof(Texel);
  const auto set = [d](double x) HWY_ATTR { return hn::Set(d, x); };
  const auto number = [d](Number x) HWY_ATTR { return hn::PromoteTo(d, x); };
  const Number mask = hn::Set(n, (1 << bits) - 1);
  FourSamples found;
  for (std::size_t k = 0; k < FourPlaces::count; k += hn::Lanes(d)) {
    const Double x = hn::Load(d, places.x.data() + k), y = hn::Load(d, places.y.data() + k), i = hn::Floor(x),
                 j = hn::Floor(y), fx = hn::Sub(x, i), fy = hn::Sub(y, j);
    const Number column = hn::DemoteTo(n, hn::Sub(i, set(in.left))),
                 row = hn::DemoteTo(n, hn::Sub(j, set(in.top))),
                 of_window = hn::Add(hn::Mul(row, hn::Set(n, in.pitch)), column);
    // Room beyond the last place may name a texel anywhere: it takes the first.
    const Number at = hn::IfThenElseZero(hn::FirstN(n, FourPlaces::count - k), of_window);
    const auto word = [&](Number where) HWY_ATTR {
      return hn::GatherOffset(n, static_cast<const std::int32_t*>(in.texels),
                              sizeof(Texel) == 1 ? where : hn::ShiftLeft<1>(where));
    };
    const Number top = word(at), under = word(hn::Add(at, hn::Set(n, in.pitch)));
    const Number a = hn::And(top, mask), b = hn::And(hn::ShiftRight<bits>(top), mask),
                 c = hn::And(under, mask), e = hn::And(hn::ShiftRight<bits>(under), mask);
    const Double above = hn::MulAdd(fx, number(hn::Sub(b, a)), number(a)),
                 below = hn::MulAdd(fx, number(hn::Sub(e, c)), number(c)),
                 g = hn::Sub(hn::MulAdd(fy, hn::Sub(below, above), above), set(in.threshold)),
                 lean = hn::Sub(g, set(in.lean));
    hn::Store(g, d, found.g.data() + k);
    found.below |= bits_of(hn::Lt(g, set(-in.bound))) << k;
    found.opaque |= bits_of(hn::Gt(g, set(in.bound - in.gap))) << k;
    found.leans |= bits_of(hn::Gt(hn::Abs(lean), set(in.bound))) << k;
    found.leans_to_opaque |= bits_of(hn::Gt(lean, hn::Zero(d))) << k;
  }
  return found;
}

}  // namespace samples

FourSamples Four8(const FourWindow& window, const FourPlaces& places) {
  return samples::take<std::uint8_t>(window, places);
}
FourSamples Four16(const FourWindow& window, const FourPlaces& places) {
  return samples::take<std::uint16_t>(window, places);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::bake::detail {

HWY_EXPORT(Four8);
HWY_EXPORT(Four16);

template <>
FourSamples sampled<std::uint8_t>(const FourWindow& window, const FourPlaces& places) {
  return HWY_DYNAMIC_DISPATCH(Four8)(window, places);
}
template <>
FourSamples sampled<std::uint16_t>(const FourWindow& window, const FourPlaces& places) {
  return HWY_DYNAMIC_DISPATCH(Four16)(window, places);
}

}  // namespace mmverify::impl::bake::detail
#endif
