// Micro-triangles strip by strip, between two lines of constant v.  Each micro-edge there is integrated once.
//   lower (iu, iv):  along(iu, iv) + slant(iu) - up(iu)
//   upper (iu, iv):  up(iu + 1) - along(iu, iv + 1) - slant(iu)
// along runs from (iu, iv) to (iu+1, iv), slant from (iu+1, iv) to (iu, iv+1), up from (iu, iv) to (iu, iv+1).
#include "impl/attribute/bake/strips.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/attribute/bake/strips.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "impl/attribute/bake/edge-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute::detail {
namespace HWY_NAMESPACE {

/// The curve index of the micro-triangle in grid square (iu, iv).  Source: impl/index/index.hpp, from_barycentrics.
HWY_INLINE std::uint32_t on_curve(const Face& f) {
  const std::uint32_t b0 = f.iu ^ (f.iu + f.iv + f.upper), t = (f.iu ^ f.iv) & b0;
  return index::detail::interleaved(b0, ((index::detail::xor_from_above(t) ^ f.iu) & ~b0) | t);
}

/// A float face from its own texels alone, for a box whose larger texels lie far off.
inline RgbaFloat near_face(const StripJob<float, double>& job, const Face& face, bool& sure) {
  const index::Corners corners = corners_of(face);
  std::array<Point, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = job.frame.at(corners[k].i, corners[k].j);
  // The box runs from the first texel that the corners may reach to the last.
  const double off = job.frame.position;
  const auto first = [&](double a, double b, double c) {
    return static_cast<std::int64_t>(std::min({a, b, c}) - off);
  };
  const auto after = [&](double a, double b, double c) {
    return static_cast<std::int64_t>(std::max({a, b, c}) + off) + 1;
  };
  const std::int64_t left = first(p[0].x, p[1].x, p[2].x), top = first(p[0].y, p[1].y, p[2].y);
  const TexelBox box{job.frame.left + left, job.frame.top + top, after(p[0].x, p[1].x, p[2].x) - left,
                     after(p[0].y, p[1].y, p[2].y) - top};
  for (Point& q : p) q = {q.x - static_cast<double>(left), q.y - static_cast<double>(top)};  // exact
  thread_local std::vector<double> room;
  const RowSums<double> sums = job.source.sums(box, room);
  const std::array<double, 4> greatest = job.source.greatest_in(box);
  const double by = job.near.still + job.near.each * static_cast<double>(std::max(box.width, box.height));
  std::array<double, 4> bound;
  for (std::size_t k = 0; k < 4; ++k) bound[k] = greatest[k] * by;
  sure = true;
  const Quad integral =
      edge_integral(sums, p[0], p[1]) + edge_integral(sums, p[1], p[2]) + edge_integral(sums, p[2], p[0]);
  return float_codes(job.scale * integral, Quad::of(bound.data()), sure);
}

template <class Channel, class Sum>
void strips(const StripJob<Channel, Sum>& job, RgbaOf<Channel>* out, std::vector<Face>& unsure) {
  const std::uint32_t side = job.side;
  const Meaning meaning = job.source.sampling().meaning;
  const Curve& curve = Curve::srgb();
  const Quad bound = Quad::of(job.bound.data());
  const auto give = [&](const Face& face, const Quad& integral) HWY_ATTR {
    const Quad mean = job.scale * integral;
    bool sure = true;
    RgbaOf<Channel>& codes = out[on_curve(face)];
    if constexpr (std::is_same_v<Channel, float>) {
      codes = float_codes(mean, bound, sure);
      if (!sure) codes = near_face(job, face, sure);
    } else if (meaning == Meaning::linear) {
      codes = linear_codes<Channel>(mean, bound, sure);
    } else if (meaning == Meaning::srgb) {
      if constexpr (sizeof(Channel) == 1) codes = srgb_codes(mean, bound, curve, sure);
    } else {
      std::array<double, 4> means;
      mean.store(means.data());
      codes = job.source.coding().encoded(means, job.bound, sure);
    }
    if (!sure) unsure.push_back(face);
  };
  std::vector<double> along(4 * (side + 1)), next(4 * (side + 1));  // four numbers each
  std::vector<Point> low(side + 1), high(side + 1);
  for (std::uint32_t i = 0; i <= side; ++i) low[i] = job.frame.at(i, 0);
  for (std::uint32_t i = 0; i < side; ++i) edge_integral(job.sums, low[i], low[i + 1]).store(&along[4 * i]);
  for (std::uint32_t iv = 0; iv < side; ++iv) {
    const std::uint32_t count = side - iv;  // lower micro-triangles of the strip
    for (std::uint32_t i = 0; i < count; ++i) high[i] = job.frame.at(i, iv + 1);
    Quad up = edge_integral(job.sums, low[0], high[0]);
    for (std::uint32_t iu = 0; iu < count; ++iu) {
      const Quad slant = edge_integral(job.sums, low[iu + 1], high[iu]);
      give({iu, iv, 0}, Quad::of(&along[4 * iu]) + slant - up);
      if (iu + 1 == count) break;
      const Quad above = edge_integral(job.sums, high[iu], high[iu + 1]);
      above.store(&next[4 * iu]);
      up = edge_integral(job.sums, low[iu + 1], high[iu + 1]);
      give({iu, iv, 1}, up - above - slant);
    }
    std::swap(along, next);
    std::swap(low, high);
  }
}

void strips_8_floats(const StripJob<std::uint8_t, float>& job, Rgba* out, std::vector<Face>& unsure) {
  strips(job, out, unsure);
}
void strips_8_doubles(const StripJob<std::uint8_t, double>& job, Rgba* out, std::vector<Face>& unsure) {
  strips(job, out, unsure);
}
void strips_16(const StripJob<std::uint16_t, double>& job, Rgba16* out, std::vector<Face>& unsure) {
  strips(job, out, unsure);
}

void strips_of_floats(const StripJob<float, double>& job, RgbaFloat* out, std::vector<Face>& unsure) {
  strips(job, out, unsure);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::attribute::detail {

HWY_EXPORT(strips_8_floats);
HWY_EXPORT(strips_8_doubles);
HWY_EXPORT(strips_16);
HWY_EXPORT(strips_of_floats);

void bake_strips(const StripJob<std::uint8_t, float>& job, Rgba* out, std::vector<Face>& unsure) {
  HWY_DYNAMIC_DISPATCH(strips_8_floats)(job, out, unsure);
}
void bake_strips(const StripJob<std::uint8_t, double>& job, Rgba* out, std::vector<Face>& unsure) {
  HWY_DYNAMIC_DISPATCH(strips_8_doubles)(job, out, unsure);
}
void bake_strips(const StripJob<std::uint16_t, double>& job, Rgba16* out, std::vector<Face>& unsure) {
  HWY_DYNAMIC_DISPATCH(strips_16)(job, out, unsure);
}
void bake_strips(const StripJob<float, double>& job, RgbaFloat* out, std::vector<Face>& unsure) {
  HWY_DYNAMIC_DISPATCH(strips_of_floats)(job, out, unsure);
}

}  // namespace mmverify::impl::attribute::detail
#endif  // HWY_ONCE
