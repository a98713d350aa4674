// The span functions of impl/attribute/lookup.hpp, compiled once for each SIMD target and chosen at run time.
#include "impl/attribute/lookup.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <stdexcept>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/attribute/lookup.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "impl/attribute/bird-inl.hpp"
#include "impl/attribute/order-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute {
namespace HWY_NAMESPACE {

// The corners (i, j), (i1, j), (i, j2) of micro-triangles, and the weights there.
struct LocatedVecs {
  WordVec i, j, i1, j2;
  FloatVec w0, w1, w2;
};

// The steps are those of the scalar locate(), and exact for the same reasons.
HWY_INLINE LocatedVecs located(FloatVec u, FloatVec v, Level n) {
  const Floats d;
  const Ints di;
  const auto p = iv::locate(u, v, n);
  const auto last = hn::Set(di, (std::int32_t{1} << n) - 1), one = hn::Set(di, 1);
  const auto kv = hn::Min(p.iv, last), ku = hn::Min(p.iu, hn::Sub(last, kv));
  const auto up = hn::Sub(p.row, hn::Add(ku, kv));  // 0 or 1
  const auto side = hn::Set(d, static_cast<float>(std::int32_t{1} << n)), unit = hn::Set(d, 1.0f);
  const auto fu = hn::Sub(hn::Mul(iv::clamped(u), side), hn::ConvertTo(d, ku));
  const auto fv = hn::Sub(hn::Mul(iv::clamped(v), side), hn::ConvertTo(d, kv));
  const auto a = hn::Sub(unit, fv), kept = hn::Min(fu, a);
  const auto upper = hn::RebindMask(d, hn::Eq(up, one));
  const auto i = hn::Add(ku, up), j = hn::Add(kv, up), step = hn::Sub(one, hn::Add(up, up));
  return {as_words(i),
          as_words(j),
          as_words(hn::Add(i, step)),
          as_words(hn::Add(j, step)),
          hn::IfThenElse(upper, hn::Sub(fu, a), hn::Sub(a, kept)),
          hn::IfThenElse(upper, hn::Sub(unit, fu), kept),
          hn::IfThenElse(upper, a, fv)};
}

// Calls `run(u, v, to)` on the vectors of the spans, `vectors` of them at a time.  The rest goes through buffers, since
// a vector must not touch memory beyond the spans.
template <std::size_t vectors, std::size_t outs, class Out, class Run>
HWY_INLINE void each_point(const float* u, const float* v, const std::array<Out*, outs>& out,
                           std::size_t count, Run run) {
  const Floats d;
  constexpr std::size_t most = vectors * hn::MaxLanes(Floats());
  const std::size_t step = vectors * hn::Lanes(d);
  std::size_t k = 0;
  std::array<Out*, outs> to;
  for (; count - k >= step; k += step) {
    for (std::size_t a = 0; a < outs; ++a) to[a] = out[a] + k;
    run(u + k, v + k, to);
  }
  if (k == count) return;
  const std::size_t left = count - k;
  HWY_ALIGN float u_left[most] = {}, v_left[most] = {};
  HWY_ALIGN Out out_left[outs][most];
  std::memcpy(u_left, u + k, left * sizeof(float));
  std::memcpy(v_left, v + k, left * sizeof(float));
  for (std::size_t a = 0; a < outs; ++a) to[a] = out_left[a];
  run(u_left, v_left, to);
  for (std::size_t a = 0; a < outs; ++a) std::memcpy(out[a] + k, out_left[a], left * sizeof(Out));
}

// The indices of three corners.
struct TripletVecs {
  WordVec x0, x1, x2;
};

// Calls `use(k, located, triplet)` for the vectors at u[k] and v[k]; EachAlone takes one at a time, TwoAtOnce two.
template <class Index>
struct EachAlone {
  static constexpr std::size_t vectors = 1;
  template <class Use>
  static HWY_INLINE void run(const Index& index, const float* u, const float* v, Level n, Use use) {
    const Floats d;
    const LocatedVecs p = located(hn::LoadU(d, u), hn::LoadU(d, v), n);
    use(std::size_t{0}, p, TripletVecs{index(p.i, p.j), index(p.i1, p.j), index(p.i, p.j2)});
  }
};

#if HWY_TARGET != HWY_SCALAR
struct TwoAtOnce {
  static constexpr std::size_t vectors = 2;
  template <class Use>
  static HWY_INLINE void run(const BirdHalves& index, const float* u, const float* v, Level n, Use use) {
    const Floats d;
    const std::size_t next = hn::Lanes(d);
    const LocatedVecs p = located(hn::LoadU(d, u), hn::LoadU(d, v), n),
                      q = located(hn::LoadU(d, u + next), hn::LoadU(d, v + next), n);
    const auto i = paired(p.i, q.i), j = paired(p.j, q.j);
    const auto x0 = index(i, j), x1 = index(paired(p.i1, q.i1), j), x2 = index(i, paired(p.j2, q.j2));
    use(std::size_t{0}, p, TripletVecs{first_of(x0), first_of(x1), first_of(x2)});
    use(next, q, TripletVecs{second_of(x0), second_of(x1), second_of(x2)});
  }
};
#endif

template <class Index, class Each = EachAlone<Index>>
void triplets_of(const float* u, const float* v, std::uint32_t* x0, std::uint32_t* x1, std::uint32_t* x2,
                 std::size_t count, Level n) {
  const Words dw;
  const Index index(n);
  each_point<Each::vectors, 3, std::uint32_t>(
      u, v, {x0, x1, x2}, count, [&](const float* pu, const float* pv, const auto& to) HWY_ATTR {
        Each::run(index, pu, pv, n, [&](std::size_t k, const LocatedVecs&, const TripletVecs& x) HWY_ATTR {
          hn::StoreU(x.x0, dw, to[0] + k);
          hn::StoreU(x.x1, dw, to[1] + k);
          hn::StoreU(x.x2, dw, to[2] + k);
        });
      });
}

// Calls `run` with the Bird kernel for this level, and with EachAlone or TwoAtOnce.
template <class Run>
HWY_INLINE void with_bird([[maybe_unused]] Level n, Run run) {
#if HWY_TARGET != HWY_SCALAR
  if (n >= BirdHalves::least_level && n <= BirdHalves::last_level)
    return run.template operator()<BirdHalves, TwoAtOnce>();
#endif
  run.template operator()<BirdIndex, EachAlone<BirdIndex>>();
}

void run_triplets(VertexOrder order, const float* u, const float* v, std::uint32_t* x0, std::uint32_t* x1,
                  std::uint32_t* x2, std::size_t count, Level n) {
  switch (order) {
    case VertexOrder::w_minor: return triplets_of<WMinorIndex>(u, v, x0, x1, x2, count, n);
    case VertexOrder::u_major: return triplets_of<UMajorIndex>(u, v, x0, x1, x2, count, n);
    default:
      return with_bird(n, [&]<class Index, class Each>()
                              HWY_ATTR { triplets_of<Index, Each>(u, v, x0, x1, x2, count, n); });
  }
}

void run_weights(const float* u, const float* v, float* w0, float* w1, float* w2, std::size_t count,
                 Level n) {
  const Floats d;
  each_point<1, 3, float>(u, v, {w0, w1, w2}, count,
                          [&](const float* pu, const float* pv, const auto& to) HWY_ATTR {
                            const LocatedVecs p = located(hn::LoadU(d, pu), hn::LoadU(d, pv), n);
                            hn::StoreU(p.w0, d, to[0]);
                            hn::StoreU(p.w1, d, to[1]);
                            hn::StoreU(p.w2, d, to[2]);
                          });
}

template <int shift>
HWY_INLINE FloatVec channel(WordVec c) {
  const auto byte = shift == 24 ? hn::ShiftRight<24>(c) : hn::And(hn::ShiftRight<shift>(c), word(0xff));
  return hn::ConvertTo(Floats(), as_ints(byte));
}

// The sum in the order of mixed_rgba8: (w0 c0 + w1 c1) + (w2 c2 + 1/2), never fused.
template <int shift>
HWY_INLINE WordVec mixed_channel(const LocatedVecs& p, WordVec c0, WordVec c1, WordVec c2) {
  const auto sum = hn::Add(hn::Add(hn::Mul(p.w0, channel<shift>(c0)), hn::Mul(p.w1, channel<shift>(c1))),
                           hn::Add(hn::Mul(p.w2, channel<shift>(c2)), hn::Set(Floats(), 0.5f)));
  return hn::ShiftLeft<shift>(as_words(hn::ConvertTo(Ints(), sum)));
}

template <class Index, class Each = EachAlone<Index>>
void interpolate(const std::uint32_t* map, const float* u, const float* v, std::uint32_t* out,
                 std::size_t count, Level n) {
  const Words dw;
  const Index index(n);
  each_point<Each::vectors, 1, std::uint32_t>(
      u, v, {out}, count, [&](const float* pu, const float* pv, const auto& to) HWY_ATTR {
        Each::run(index, pu, pv, n, [&](std::size_t k, const LocatedVecs& p, const TripletVecs& x) HWY_ATTR {
          // The offsets are signed: below level 16 every index is below 2^31, and level 16 is looked up one by one.
          const auto c0 = hn::GatherIndex(dw, map, as_ints(x.x0));
          const auto c1 = hn::GatherIndex(dw, map, as_ints(x.x1));
          const auto c2 = hn::GatherIndex(dw, map, as_ints(x.x2));
          const auto low = hn::Or(mixed_channel<0>(p, c0, c1, c2), mixed_channel<8>(p, c0, c1, c2));
          const auto high = hn::Or(mixed_channel<16>(p, c0, c1, c2), mixed_channel<24>(p, c0, c1, c2));
          hn::StoreU(hn::Or(low, high), dw, to[0] + k);
        });
      });
}

void run_interpolate(VertexOrder order, const std::uint32_t* map, const float* u, const float* v,
                     std::uint32_t* out, std::size_t count, Level n) {
  switch (order) {
    case VertexOrder::w_minor: return interpolate<WMinorIndex>(map, u, v, out, count, n);
    case VertexOrder::u_major: return interpolate<UMajorIndex>(map, u, v, out, count, n);
    default:
      return with_bird(
          n, [&]<class Index, class Each>() HWY_ATTR { interpolate<Index, Each>(map, u, v, out, count, n); });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::attribute {
namespace {

HWY_EXPORT(run_triplets);
HWY_EXPORT(run_weights);
HWY_EXPORT(run_interpolate);

void require_one_length(const char* message, std::size_t length, std::initializer_list<std::size_t> others) {
  for (const std::size_t other : others)
    if (other != length) throw std::invalid_argument(message);
}

}  // namespace

void triplets(VertexOrder order, std::span<const float> u, std::span<const float> v, Level level,
              const TripletSpans& out) {
  require_one_length("attribute::triplets: u, v and the spans of out differ in length", u.size(),
                     {v.size(), out.x0.size(), out.x1.size(), out.x2.size()});
  HWY_DYNAMIC_DISPATCH(run_triplets)
  (order, u.data(), v.data(), out.x0.data(), out.x1.data(), out.x2.data(), u.size(),
   std::min(level, max_level));
}

void weights(std::span<const float> u, std::span<const float> v, Level level, const WeightSpans& out) {
  require_one_length("attribute::weights: u, v and the spans of out differ in length", u.size(),
                     {v.size(), out.w0.size(), out.w1.size(), out.w2.size()});
  HWY_DYNAMIC_DISPATCH(run_weights)
  (u.data(), v.data(), out.w0.data(), out.w1.data(), out.w2.data(), u.size(), std::min(level, max_level));
}

void interpolated_rgba8(VertexOrder order, std::span<const std::uint32_t> map, std::span<const float> u,
                        std::span<const float> v, Level level, std::span<std::uint32_t> out) {
  require_one_length("attribute::interpolated_rgba8: u, v and out differ in length", out.size(),
                     {u.size(), v.size()});
  if (map.size() != vertex_count(level))
    throw std::invalid_argument("attribute::interpolated_rgba8: the map has not V(level) values");
  if (level >= max_level) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = interpolated_rgba8(order, map, u[k], v[k], level);
    return;
  }
  HWY_DYNAMIC_DISPATCH(run_interpolate)(order, map.data(), u.data(), v.data(), out.data(), out.size(), level);
}

}  // namespace mmverify::impl::attribute
#endif  // HWY_ONCE
