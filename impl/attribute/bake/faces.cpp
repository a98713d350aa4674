// Bound.  Corners within 8 u E move a triangle's integral by 8 u E m (h + h' + h'') at most, m the greatest texel and h
// those of edge-inl.hpp, whose bound adds; with K pieces an edge together m u E (8 + 18 + K)(h + h' + h''), here with
// twice as much.  The area is within its own bound.
#include "impl/attribute/bake/faces.hpp"

#include <cmath>
#include <stdexcept>

#include "impl/attribute/bake/exact.hpp"
#include "impl/attribute/bake/strips.hpp"

namespace mmverify::impl::attribute::detail {
namespace {

constexpr std::int64_t most_texels = std::int64_t{1} << 24, small_box = std::int64_t{1} << 16,
                       longest = std::int64_t{1} << 15;

/// Of each channel; none where floats cannot tell anything.
template <class Channel>
std::optional<std::array<double, 4>> bound_of(const Source<Channel>& source, const Frame& frame) {
  const auto size = [](const Point& p) { return std::fabs(p.x) + std::fabs(p.y); };
  const Point slant{frame.down.x - frame.across.x, frame.down.y - frame.across.y};
  const double longest_edge = std::max({size(frame.across), size(frame.down), size(slant)}) + frame.position,
               around = size(frame.across) + size(frame.down) + size(slant) + 4 * frame.position;
  const double area = std::fabs(frame.area), off = frame.area_off;
  if (!(area > 4 * off)) return std::nullopt;
  std::array<double, 4> bound;
  for (std::size_t k = 0; k < 4; ++k) {
    const double m = source.coding().full(k);
    const double sum_off = m * half_ulp * frame.extent * (64 + 2 * longest_edge) * around;
    bound[k] = (2 * sum_off + m * off) / (area - off) + 8 * half_ulp * m;
    if (!(bound[k] < source.coding().most_off(k))) return std::nullopt;
  }
  return bound;
}

index::Corners corners_of(const Face& f) {
  if (f.upper != 0)
    return {index::Vertex{f.iu + 1, f.iv + 1}, index::Vertex{f.iu, f.iv + 1}, index::Vertex{f.iu + 1, f.iv}};
  return {index::Vertex{f.iu, f.iv}, index::Vertex{f.iu + 1, f.iv}, index::Vertex{f.iu, f.iv + 1}};
}

/// The index of a face, by its centroid, which is no tie.
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
  const auto bound = bound_of(source, frame);
  if (!bound) {
    for (std::uint32_t k = 0; k < out.size(); ++k) out[k] = exact.face(index::corners(k, level));
    counts.exact = out.size();
    return counts;
  }
  thread_local std::vector<Sum> room;
  const RowSums<Sum> sums = box.width * box.height > small_box && in_picture
                                ? source.template sums_from<Sum>(*in_picture)
                                : source.sums(box, room);
  std::vector<Face> unsure;
  bake_strips(StripJob<Channel, Sum>{source, frame, sums, 1u << level, 2 / frame.area, *bound}, out.data(),
              unsure);
  for (const Face& face : unsure) out[index_of(face, level)] = exact.face(corners_of(face));
  counts.exact = unsure.size();
  return counts;
}

}  // namespace

template <class Channel>
AttributeCounts bake_faces(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level,
                           std::span<RgbaOf<Channel>> out) {
  // 255 x 2^15 < 2^24: floats hold every sum of codes.
  if constexpr (sizeof(Channel) == 1)
    if (source.sampling().meaning != Meaning::srgb) return bake_with<float>(source, uv, level, out);
  return bake_with<double>(source, uv, level, out);
}
template AttributeCounts bake_faces(const Source<std::uint8_t>&, const BaseTriangle&, std::uint32_t,
                                    std::span<Rgba>);
template AttributeCounts bake_faces(const Source<std::uint16_t>&, const BaseTriangle&, std::uint32_t,
                                    std::span<Rgba16>);

}  // namespace mmverify::impl::attribute::detail
