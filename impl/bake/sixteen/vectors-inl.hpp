// Vectors, cells and places of a node of sixteen (impl/bake/sixteen/sixteen.cpp).  Compiled once for each target.
#include <hwy/highway.h>

#include "impl/bake/sixteen/lanes.hpp"
#include "impl/bake/sixteen/sixteen.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_BAKE_SIXTEEN_VECTORS_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_BAKE_SIXTEEN_VECTORS_INL_HPP_
#undef MMVERIFY_IMPL_BAKE_SIXTEEN_VECTORS_INL_HPP_
#else
#define MMVERIFY_IMPL_BAKE_SIXTEEN_VECTORS_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using Float = hn::Vec<F>;
using Mask = hn::Mask<F>;
using Int = hn::Vec<I>;
using Table = SixteenLanes::Floats;

/// The number of vectors that sixteen numbers take.
constexpr std::size_t parts = 16 / hn::MaxLanes(F());
using Floats = std::array<Float, parts>;
using Ints = std::array<Int, parts>;

// ---------------------------------------------------------------------------------------------------------------------
// Vectors
// ---------------------------------------------------------------------------------------------------------------------

// Large functions are not inlined under sanitizers, where a compiler would take minutes over all of them in one.
#undef MMVERIFY_LARGE
#define MMVERIFY_LARGE HWY_INLINE
#ifdef __has_feature
#if __has_feature(address_sanitizer)
#undef MMVERIFY_LARGE
#define MMVERIFY_LARGE inline HWY_NOINLINE
#endif
#endif

HWY_INLINE Float set(float x) { return hn::Set(F(), x); }
HWY_INLINE Int set(std::int32_t x) { return hn::Set(I(), x); }

/// The nearest whole number, the even one of two equally near, from the low bits of a float so large that it has no
/// others.  A conversion would also handle numbers that are too large.  Domain: |x| < 2^22.
constexpr float whole_only = 0x1.8p23f;               // check-magic: 0x1.8p23f == 2 ** 23 + 2 ** 22
constexpr std::int32_t whole_only_bits = 0x4b400000;  // check-magic: 0x4b400000 == bits32(0x1.8p23)
HWY_INLINE Int nearest(Float x) {
  return hn::Sub(hn::BitCast(I(), hn::Add(x, set(whole_only))), set(whole_only_bits));
}
/// floor; of a whole number, or one within a rounding of it, perhaps the number below or above.  That is harmless:
/// results here have a margin, or are a cell's coordinate, where 0 and 1 of neighbours are one place.
HWY_INLINE Int floored(Float x) { return nearest(hn::Sub(x, set(0.5f))); }

/// table[at].  Domain: at in [0, 16).
template <class D, class Value>
HWY_INLINE hn::Vec<D> among(D d, const Value* table, Int at) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::TableLookupLanes(hn::LoadU(d, table), hn::IndicesFromVec(d, at));
#else
  return hn::GatherIndex(d, table, at);
#endif
}
/// rows[at].  Domain: at in [0, 32).
HWY_INLINE Int among_rows(const std::uint32_t* rows, Int at) {
  const auto* const table = reinterpret_cast<const std::int32_t*>(rows);
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return Int{_mm512_permutex2var_epi32(hn::LoadU(I(), table).raw, at.raw, hn::LoadU(I(), table + 16).raw)};
#else
  return hn::GatherIndex(I(), table, at);
#endif
}

/// A table lookup of edges by their directions.
class Directions {
 public:
  HWY_INLINE explicit Directions(Int of)
#if HWY_TARGET == HWY_SCALAR
      : of_(of){}
#else
      : of_(hn::IndicesFromVec(F(), of)) {
  }
#endif
        HWY_INLINE Float
        operator()(const SixteenShape::OfEdges& table) const {
#if HWY_TARGET == HWY_SCALAR
    return hn::GatherIndex(F(), table.data(), of_);
#else
    return hn::TableLookupLanes(hn::LoadDup128(F(), table.data()), of_);
#endif
  }

 private:
#if HWY_TARGET == HWY_SCALAR
  Int of_;
#else
  decltype(hn::IndicesFromVec(F(), Int())) of_;
#endif
};

HWY_INLINE std::uint32_t bits_of(Mask mask, std::size_t k) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return std::uint32_t{mask.raw} << k;
#else
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(F(), mask, bytes.data());
  return (bytes[0] | std::uint32_t{bytes[1]} << 8) << k;
#endif
}
HWY_INLINE std::uint32_t zeros_of(Int x, std::size_t k) {
  return bits_of(hn::RebindMask(F(), hn::Eq(x, set(0))), k);
}

/// The bits that any lane has.
HWY_INLINE std::uint32_t any_of(Int x) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return static_cast<std::uint32_t>(_mm512_reduce_or_epi32(x.raw));
#else
  HWY_ALIGN std::array<std::int32_t, 16> lanes{};
  hn::StoreU(x, I(), lanes.data());
  std::int32_t any = 0;
  for (std::size_t n = 0; n < hn::MaxLanes(F()); ++n) any |= lanes[n];
  return static_cast<std::uint32_t>(any);
#endif
}

/// The mask whose lane l is bit k + l.
HWY_INLINE Mask mask_of(std::uint32_t bits, std::size_t k) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return Mask{static_cast<__mmask16>(bits >> k)};
#else
  const Int lanes = hn::Shr(set(static_cast<std::int32_t>(bits >> k)), hn::Iota(I(), 0));
  return hn::RebindMask(F(), hn::Eq(hn::And(lanes, set(1)), set(1)));
#endif
}
/// The lanes in which x has any of the bits.
HWY_INLINE Mask have_any(Int x, std::uint32_t bits) {
  return hn::RebindMask(F(), hn::Ne(hn::And(x, set(static_cast<std::int32_t>(bits))), set(0)));
}

/// The stored alpha of one cell, a + fx right + fy (below + fx twist).
struct Cell {
  Float a, right, below, twist;

  HWY_INLINE Float at(Float fx, Float fy) const {
    return hn::MulAdd(fy, hn::MulAdd(fx, twist, below), hn::MulAdd(fx, right, a));
  }
};
template <class Texel>
HWY_INLINE Cell cell(const SixteenInput& in, Int i, Int j) {
  constexpr int bits = 8 * sizeof(Texel);
  const Int mask = set((1 << bits) - 1), at = hn::Add(hn::Mul(j, set(in.pitch)), i);
  const auto word = [&](Int where) HWY_ATTR {
    return hn::GatherOffset(I(), static_cast<const std::int32_t*>(in.texels),
                            sizeof(Texel) == 1 ? where : hn::ShiftLeft<1>(where));
  };
  const auto first = [&](Int w) HWY_ATTR { return hn::And(w, mask); };
  const auto second = [&](Int w) HWY_ATTR { return hn::And(hn::ShiftRight<bits>(w), mask); };
  const Int top = word(at), under = word(hn::Add(at, set(in.pitch)));
  const Int a = first(top), right = hn::Sub(second(top), a), below = hn::Sub(first(under), a);
  const Int twist = hn::Sub(hn::Sub(second(under), first(under)), right);
  return {hn::ConvertTo(F(), a), hn::ConvertTo(F(), right), hn::ConvertTo(F(), below),
          hn::ConvertTo(F(), twist)};
}

/// The cell of a place, and its coordinates within the cell.
struct Located {
  Int i, j;
  Float x, y;

  HWY_INLINE Located(Float at_x, Float at_y)
      : i(floored(at_x)),
        j(floored(at_y)),
        x(hn::Sub(at_x, hn::ConvertTo(F(), i))),
        y(hn::Sub(at_y, hn::ConvertTo(F(), j))) {}
};

/// g at places.
template <class Texel>
HWY_INLINE Float sampled(const SixteenInput& in, const Located& at) {
  return hn::Sub(cell<Texel>(in, at.i, at.j).at(at.x, at.y), set(in.shape->threshold));
}
/// g at the wanted places; the other lanes read one common texel, which costs less.
template <class Texel>
HWY_INLINE Float sampled(const SixteenInput& in, Located at, Mask wanted) {
  const auto is_wanted = hn::RebindMask(I(), wanted);
  at.i = hn::IfThenElseZero(is_wanted, at.i);
  at.j = hn::IfThenElseZero(is_wanted, at.j);
  return sampled<Texel>(in, at);
}

/// The coordinate p0 + i p01 + j p02 along an axis.
HWY_INLINE Float place(const SixteenInput& in, std::size_t axis, Float i, Float j) {
  return hn::MulAdd(j, set(in.shape->p02[axis]), hn::MulAdd(i, set(in.shape->p01[axis]), set(in.p0[axis])));
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#endif
