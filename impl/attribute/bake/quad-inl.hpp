// Four binary64 numbers, one a channel: a vector on targets whose vectors have room for four, else an array.
#include <bit>
#include <cstddef>
#include <cstdint>

#include "impl/attribute/bake/floats.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_ATTRIBUTE_BAKE_QUAD_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_ATTRIBUTE_BAKE_QUAD_INL_HPP_
#undef MMVERIFY_IMPL_ATTRIBUTE_BAKE_QUAD_INL_HPP_
#else
#define MMVERIFY_IMPL_ATTRIBUTE_BAKE_QUAD_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute::detail {
namespace HWY_NAMESPACE {

#if !HWY_HAVE_SCALABLE && HWY_MAX_BYTES >= 32

namespace hn = hwy::HWY_NAMESPACE;

struct Quad {
  using Tag = hn::FixedTag<double, 4>;
  hn::Vec<Tag> v;

  static HWY_INLINE Quad zero() { return {hn::Zero(Tag())}; }
  static HWY_INLINE Quad of(const double* p) { return {hn::LoadU(Tag(), p)}; }
  static HWY_INLINE Quad of(const float* p) {
    return {hn::PromoteTo(Tag(), hn::LoadU(hn::FixedTag<float, 4>(), p))};
  }
  HWY_INLINE void store(double* p) const { hn::StoreU(v, Tag(), p); }

  friend HWY_INLINE Quad operator+(Quad a, Quad b) { return {hn::Add(a.v, b.v)}; }
  friend HWY_INLINE Quad operator-(Quad a, Quad b) { return {hn::Sub(a.v, b.v)}; }
  friend HWY_INLINE Quad operator*(double a, Quad b) { return {hn::Mul(hn::Set(Tag(), a), b.v)}; }
  /// this + a b
  HWY_INLINE Quad plus(double a, Quad b) const { return {hn::MulAdd(hn::Set(Tag(), a), b.v, v)}; }
};

/// The codes of linear means: linear_code of each.
template <class Channel>
HWY_INLINE RgbaOf<Channel> linear_codes(Quad mean, Quad bound, bool& sure) {
  const Quad::Tag d;
  const hn::FixedTag<std::int32_t, 4> di;
  const hn::FixedTag<Channel, 4> db;
  const auto up = hn::Add(mean.v, hn::Set(d, 0.5));
  const auto whole = hn::DemoteTo(di, up);  // up >= 1/4
  const auto rest = hn::Sub(up, hn::PromoteTo(d, whole));
  sure = hn::AllTrue(d, hn::And(hn::Ge(rest, bound.v), hn::Le(rest, hn::Sub(hn::Set(d, 1.0), bound.v))));
  RgbaOf<Channel> codes;
  hn::StoreU(hn::DemoteTo(db, whole), db, codes.data());
  return codes;
}

/// The numbers of binary32 that means are rounded to: Coding<float>::encoded.
HWY_INLINE RgbaFloat float_codes(Quad mean, Quad bound, bool& sure) {
  const Quad::Tag d;
  const hn::FixedTag<float, 4> df;
  const hn::FixedTag<std::uint32_t, 4> du;
  const auto no_minus = hn::Add(mean.v, hn::Zero(d));
  const auto low = hn::DemoteTo(df, hn::Sub(no_minus, bound.v)),
             high = hn::DemoteTo(df, hn::Add(no_minus, bound.v));
  sure = hn::AllTrue(du, hn::Eq(hn::BitCast(du, low), hn::BitCast(du, high)));
  RgbaFloat numbers;
  hn::StoreU(low, df, numbers.data());
  return numbers;
}

/// The codes of means on the sRGB curve, alpha linear: Curve::code of each.
HWY_INLINE Rgba srgb_codes(Quad mean, Quad bound, const Curve& curve, bool& sure) {
  const Quad::Tag d;
  const hn::FixedTag<std::uint64_t, 4> dw;
  const hn::FixedTag<std::int32_t, 4> di;
  const hn::FixedTag<std::uint8_t, 4> db;
  const hn::FixedTag<std::uint32_t, 1> one;
  const auto inside = hn::Min(hn::Max(mean.v, hn::Set(d, Curve::first_number)), hn::Set(d, curve.full));
  const auto place =
      hn::Sub(hn::ShiftRight<Curve::bits_below>(hn::BitCast(dw, inside)), hn::Set(dw, Curve::first_bits));
  const auto entry =
      hn::GatherIndex(dw, curve.middles.data(), hn::BitCast(hn::FixedTag<std::int64_t, 4>(), place));
  const auto codes_below = hn::And(entry, hn::Set(dw, Curve::code_mask));
  const auto middle = hn::BitCast(d, hn::Xor(entry, codes_below));
  const auto reached = hn::VecFromMask(dw, hn::RebindMask(dw, hn::Ge(mean.v, middle)));  // all ones is -1
  const auto up = hn::Add(mean.v, hn::Set(d, 0.5));
  const auto whole = hn::DemoteTo(di, up);
  const auto rest = hn::Sub(up, hn::PromoteTo(d, whole));
  const auto colours = hn::FirstN(d, 3);
  const auto off = hn::IfThenElse(colours, hn::Abs(hn::Sub(mean.v, middle)),
                                  hn::Min(rest, hn::Sub(hn::Set(d, 1.0), rest)));
  sure = hn::AllTrue(d, hn::Ge(off, bound.v));
  const auto rgb = hn::TruncateTo(db, hn::Sub(codes_below, reached)), line = hn::DemoteTo(db, whole);
  const std::uint32_t both =
      (hn::GetLane(hn::BitCast(one, rgb)) & 0xffffff) | (hn::GetLane(hn::BitCast(one, line)) & 0xff000000);
  return std::bit_cast<Rgba>(both);
}

#else

struct Quad {
  double v[4];

  static HWY_INLINE Quad zero() { return {}; }
  template <class Sum>
  static HWY_INLINE Quad of(const Sum* p) {
    return {{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]),
             static_cast<double>(p[3])}};
  }
  HWY_INLINE void store(double* p) const { std::copy(v, v + 4, p); }

  friend HWY_INLINE Quad operator+(const Quad& a, const Quad& b) {
    return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
  }
  friend HWY_INLINE Quad operator-(const Quad& a, const Quad& b) {
    return {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2], a.v[3] - b.v[3]}};
  }
  friend HWY_INLINE Quad operator*(double a, const Quad& b) {
    return {{a * b.v[0], a * b.v[1], a * b.v[2], a * b.v[3]}};
  }
  HWY_INLINE Quad plus(double a, const Quad& b) const { return *this + a * b; }
};

template <class Channel>
HWY_INLINE RgbaOf<Channel> linear_codes(const Quad& mean, const Quad& bound, bool& sure) {
  RgbaOf<Channel> codes;
  for (std::size_t k = 0; k < 4; ++k) codes[k] = linear_code<Channel>(mean.v[k], bound.v[k], sure);
  return codes;
}

HWY_INLINE RgbaFloat float_codes(const Quad& mean, const Quad& bound, bool& sure) {
  return Coding<float>::encoded(std::to_array(mean.v), std::to_array(bound.v), sure);
}

HWY_INLINE Rgba srgb_codes(const Quad& mean, const Quad& bound, const Curve& curve, bool& sure) {
  Rgba codes;
  for (std::size_t k = 0; k < 3; ++k) codes[k] = curve.code(mean.v[k], bound.v[k], sure);
  codes[3] = Curve::linear().code(mean.v[3], bound.v[3], sure);
  return codes;
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute::detail
HWY_AFTER_NAMESPACE();

#endif
