// Faces of a base triangle.  docs/ATTRIBUTE_BOUNDS.md derives the bounds.
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

/// The lengths L and H, the area A and its error, from which all faces' bounds are computed.
struct Edges {
  double longest = 0, around = 0, area = 0, off = 0;

  explicit Edges(const Frame& frame) : area(std::fabs(frame.area)), off(frame.area_off) {
    const auto size = [](const Point& p) { return std::fabs(p.x) + std::fabs(p.y); };
    const Point slant{frame.down.x - frame.across.x, frame.down.y - frame.across.y};
    longest = std::max({size(frame.across), size(frame.down), size(slant)}) + frame.position;
    around = size(frame.across) + size(frame.down) + size(slant) + 4 * frame.position;
  }
  /// Whether the area is large enough for any bound: docs/ATTRIBUTE_BOUNDS.md, "The area".
  bool tell() const { return area > 4 * off; }
};

/// The bound of every face's mean, for each channel; none if whole numbers have to decide all of them.
/// reach: W of the page, the texels that a sum of a row counts, and E at least.
template <class Channel>
std::optional<std::array<double, 4>> bound_of(const Source<Channel>& source, const Frame& frame,
                                              const Edges& edges, double reach) {
  if (!edges.tell()) return std::nullopt;
  constexpr bool floats = std::is_same_v<Channel, float>;
  const std::array<double, 4> greatest = source.greatest_in(frame.box());
  std::array<double, 4> bound;
  for (std::size_t k = 0; k < 4; ++k) {
    const double m = greatest[k];
    // docs/ATTRIBUTE_BOUNDS.md, "A face" and "A face of floats": twice m u E (31 + L) H, and room.
    const double sum_off = m * half_ulp * reach * ((floats ? 80 : 64) + 2 * edges.longest) * edges.around;
    bound[k] = (2 * sum_off + m * edges.off) / (edges.area - edges.off) + 8 * half_ulp * m;
    if constexpr (!floats)
      if (!(bound[k] < source.coding().most_off(k))) return std::nullopt;
  }
  return bound;
}

/// The bound of a face computed by itself: docs/ATTRIBUTE_BOUNDS.md, "A face of floats by itself".
/// Domain: edges.tell().
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
  // Floats use the box's own sums: sums from the picture's edge on would be less exact.
  const bool by_picture = !std::is_same_v<Channel, float> && box.width * box.height > small_box && in_picture;
  const double reach =
      by_picture ? std::max(frame.extent, static_cast<double>(in_picture->x + box.width)) : frame.extent;
  const auto bound = bound_of(source, frame, edges, reach);
  if (!bound) {
    for (std::uint32_t k = 0; k < out.size(); ++k) out[k] = exact.face(index::corners(k, level));
    counts.exact = out.size();
    return counts;
  }
  thread_local std::vector<Sum> room;
  const RowSums<Sum> sums = [&] {
    if constexpr (!std::is_same_v<Channel, float>)
      if (by_picture) return source.template sums_from<Sum>(*in_picture);
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
