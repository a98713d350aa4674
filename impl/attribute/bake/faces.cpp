// The bound.  Corners within 8 u E move a triangle's integral by 8 u E m (h + h' + h'') at most, where m is the
// greatest texel and h as in edge-inl.hpp, whose bound is added.  With K pieces an edge the sum is m u E (8 + 18 + K)(h
// + h' + h''); here it is taken twice.  The area is within its own bound.
// Floats: m is the greatest |texel| of the box, whatever the signs.  Sums before a texel are within 1.01 u m E
// (source.cpp), so that F is within 10 u m E instead of 6: hence 80 instead of 64, of which 16 are for this.  A face
// that is not sure is tried once more by itself.  Its m is that of the texels under it and around, e the greater side
// of their box.  Its positions are as before and move the integral by 8 u E m a length; the rest is m u e (12 + 10 +
// K), and 4 more for three edges.  With twice as much of both:  m (16 u E + u e (60 + 2 h)) (h + h' + h'').
#include "impl/attribute/bake/faces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "impl/attribute/bake/exact.hpp"
#include "impl/attribute/bake/strips.hpp"

namespace mmverify::impl::attribute::detail {
namespace {

constexpr std::int64_t most_texels = std::int64_t{1} << 24, small_box = std::int64_t{1} << 16,
                       longest = std::int64_t{1} << 15;

/// The lengths and the area that all faces' bounds are computed from; tell() is false if floats cannot decide anything.
struct Edges {
  double longest = 0, around = 0, area = 0, off = 0;

  explicit Edges(const Frame& frame) : area(std::fabs(frame.area)), off(frame.area_off) {
    const auto size = [](const Point& p) { return std::fabs(p.x) + std::fabs(p.y); };
    const Point slant{frame.down.x - frame.across.x, frame.down.y - frame.across.y};
    longest = std::max({size(frame.across), size(frame.down), size(slant)}) + frame.position;
    around = size(frame.across) + size(frame.down) + size(slant) + 4 * frame.position;
  }
  bool tell() const { return area > 4 * off; }
};

template <class Channel>
std::optional<std::array<double, 4>> bound_of(const Source<Channel>& source, const Frame& frame,
                                              const Edges& edges) {
  if (!edges.tell()) return std::nullopt;
  constexpr bool floats = std::is_same_v<Channel, float>;
  const std::array<double, 4> greatest = source.greatest_in(frame.box());
  std::array<double, 4> bound;
  for (std::size_t k = 0; k < 4; ++k) {
    const double m = greatest[k];
    const double sum_off =
        m * half_ulp * frame.extent * ((floats ? 80 : 64) + 2 * edges.longest) * edges.around;
    bound[k] = (2 * sum_off + m * edges.off) / (edges.area - edges.off) + 8 * half_ulp * m;
    if constexpr (!floats)
      if (!(bound[k] < source.coding().most_off(k))) return std::nullopt;
  }
  return bound;
}

/// The bound of a face computed by itself.  Domain: edges.tell().
NearBound near_bound(const Frame& frame, const Edges& edges) {
  const double area = edges.area - edges.off;
  return {(32 * half_ulp * frame.extent * edges.around + edges.off) / area + 8 * half_ulp,
          2 * half_ulp * (60 + 2 * edges.longest) * edges.around / area};
}

/// The index of a face, by a point inside it.
std::uint32_t index_of(const Face& f, std::uint32_t level) {
  const auto third = [&](std::uint32_t k) {
    return (static_cast<float>(k) + (f.upper != 0 ? 0.625f : 0.25f)) / static_cast<float>(1u << level);
  };
  return index::from_barycentrics(third(f.iu), third(f.iv), level);
}

template <class Sum, class Channel>
AttributeCounts bake_with(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level,
                          std::span<RgbaOf<Channel>> out) {
  const Frame frame(source, uv, level);
  const TexelBox box = frame.box();
  if (box.width > longest || box.height > longest)
    throw std::invalid_argument("attribute: a triangle over more than 2^15 texels along an axis");
  const auto in_picture = source.in_picture(box);
  if (box.width * box.height > most_texels && !in_picture)
    throw std::invalid_argument("attribute: a triangle over more than 2^24 texels");
  AttributeCounts counts;
  counts.values = out.size();
  const Exact<Channel> exact(source, uv, level);
  const Edges edges(frame);
  const auto bound = bound_of(source, frame, edges);
  if (!bound) {
    for (std::uint32_t k = 0; k < out.size(); ++k) out[k] = exact.face(index::corners(k, level));
    counts.exact = out.size();
    return counts;
  }
  thread_local std::vector<Sum> room;
  const RowSums<Sum> sums = [&] {
    // Floats use the box's own sums: sums from the picture's edge on would be less exact.
    if constexpr (!std::is_same_v<Channel, float>)
      if (box.width * box.height > small_box && in_picture)
        return source.template sums_from<Sum>(*in_picture);
    return source.sums(box, room);
  }();
  std::vector<Face> unsure;
  bake_strips(StripJob<Channel, Sum>{source, frame, sums, 1u << level, 2 / frame.area, *bound,
                                     near_bound(frame, edges)},
              out.data(), unsure);
  for (const Face& face : unsure) out[index_of(face, level)] = exact.face(corners_of(face));
  counts.exact = unsure.size();
  return counts;
}

}  // namespace

template <class Channel>
AttributeCounts bake_faces(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level,
                           std::span<RgbaOf<Channel>> out) {
  // Floats are exact for every sum of codes: 255 x 2^15 < 2^24.
  if constexpr (sizeof(Channel) == 1)
    if (source.sampling().meaning != Meaning::srgb) return bake_with<float>(source, uv, level, out);
  return bake_with<double>(source, uv, level, out);
}
template AttributeCounts bake_faces(const Source<std::uint8_t>&, const BaseTriangle&, std::uint32_t,
                                    std::span<Rgba>);
template AttributeCounts bake_faces(const Source<std::uint16_t>&, const BaseTriangle&, std::uint32_t,
                                    std::span<Rgba16>);
template AttributeCounts bake_faces(const Source<float>&, const BaseTriangle&, std::uint32_t,
                                    std::span<RgbaFloat>);

}  // namespace mmverify::impl::attribute::detail
