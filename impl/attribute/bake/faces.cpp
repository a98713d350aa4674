// A strip of micro-triangles at a time, between two lines of constant v: of each micro-edge there the integral once.
//   lower (iu, iv):  along(iu, iv) + slant(iu) - up(iu)
//   upper (iu, iv):  up(iu + 1) - along(iu, iv + 1) - slant(iu)
// along from (iu, iv) to (iu+1, iv), slant from (iu+1, iv) to (iu, iv+1), up from (iu, iv) to (iu, iv+1).
//
// Bound.  Corners within 8 u E move a triangle's integral by 8 u E m (h + h' + h'') at most, m the greatest texel and h
// those of edge.hpp, whose bound adds; with K pieces an edge together m u E (8 + 18 + K)(h + h' + h''), here with twice
// as much.  The area is within its own bound.
#include "impl/attribute/bake/faces.hpp"

#include <cmath>
#include <stdexcept>

#include "impl/attribute/bake/edge.hpp"
#include "impl/attribute/bake/exact.hpp"

namespace mmverify::impl::attribute::detail {
namespace {

constexpr std::int64_t most_texels = std::int64_t{1} << 24, small_box = std::int64_t{1} << 16,
                       longest = std::int64_t{1} << 15;

/// Index on the curve of the micro-triangle of grid square (iu, iv).  Source: impl/index/index.hpp, from_barycentrics.
std::uint32_t on_curve(std::uint32_t iu, std::uint32_t iv, std::uint32_t upper) noexcept {
  const std::uint32_t b0 = iu ^ (iu + iv + upper), t = (iu ^ iv) & b0;
  return index::detail::interleaved(b0, ((index::detail::xor_from_above(t) ^ iu) & ~b0) | t);
}

/// Half a row of lines that the strips above and below it share.
template <class Sum>
class Strips {
 public:
  Strips(const Source& source, const Frame& frame, const RowSums<Sum>& sums, std::uint32_t level)
      : source_(source), frame_(frame), sums_(sums), side_(std::uint32_t{1} << level) {
    const auto size = [](const Point& p) { return std::fabs(p.x) + std::fabs(p.y); };
    const Point slant{frame.down.x - frame.across.x, frame.down.y - frame.across.y};
    const double longest_edge =
                     std::max({size(frame.across), size(frame.down), size(slant)}) + frame.position,
                 around = size(frame.across) + size(frame.down) + size(slant) + 4 * frame.position;
    const double area = std::fabs(frame.area), off = frame.area_off;
    for (std::size_t k = 0; k < 4; ++k) {
      const double m = source.curves()[k]->full;
      const double sum_off = m * half_ulp * frame.extent * (64 + 2 * longest_edge) * around;
      bound_[k] = (2 * sum_off + m * off) / (area - off) + 8 * half_ulp * m;
    }
    scale_ = 2 / frame.area;
    known_ = area > 4 * off;
    for (std::size_t k = 0; k < 4; ++k) known_ = known_ && bound_[k] < 0.125 * source.curves()[k]->full / 255;
  }

  /// Whether floats can tell anything.
  bool known() const { return known_; }

  /// Calls put(iu, iv, upper, codes, sure).
  template <class Put>
  void bake(Put put) const {
    std::vector<Four> along(side_ + 1), next(side_ + 1);
    std::vector<Point> low(side_ + 1), high(side_ + 1);
    for (std::uint32_t i = 0; i <= side_; ++i) low[i] = frame_.at(i, 0);
    for (std::uint32_t i = 0; i < side_; ++i) along[i] = edge_integral(sums_, low[i], low[i + 1]);
    for (std::uint32_t iv = 0; iv < side_; ++iv) {
      const std::uint32_t count = side_ - iv;  // lower ones
      for (std::uint32_t i = 0; i < count; ++i) high[i] = frame_.at(i, iv + 1);
      Four up = edge_integral(sums_, low[0], high[0]);
      for (std::uint32_t iu = 0; iu < count; ++iu) {
        const Four slant = edge_integral(sums_, low[iu + 1], high[iu]);
        Four sum;
        for (std::size_t k = 0; k < 4; ++k) sum[k] = along[iu][k] + slant[k] - up[k];
        give(iu, iv, 0, sum, put);
        if (iu + 1 == count) break;
        next[iu] = edge_integral(sums_, high[iu], high[iu + 1]);
        up = edge_integral(sums_, low[iu + 1], high[iu + 1]);
        for (std::size_t k = 0; k < 4; ++k) sum[k] = up[k] - next[iu][k] - slant[k];
        give(iu, iv, 1, sum, put);
      }
      std::swap(along, next);
      std::swap(low, high);
    }
  }

 private:
  template <class Put>
  void give(std::uint32_t iu, std::uint32_t iv, std::uint32_t upper, const Four& sum, Put& put) const {
    Four mean;
    for (std::size_t k = 0; k < 4; ++k) mean[k] = sum[k] * scale_;
    bool sure = true;
    const Rgba codes = encoded(mean, bound_, source_.sampling().meaning, source_.curves(), sure);
    put(iu, iv, upper, codes, sure);
  }

  const Source& source_;
  const Frame& frame_;
  RowSums<Sum> sums_;
  std::uint32_t side_;
  Four bound_;
  double scale_;
  bool known_;
};

index::Corners corners_of(std::uint32_t iu, std::uint32_t iv, std::uint32_t upper) {
  if (upper != 0)
    return {index::Vertex{iu + 1, iv + 1}, index::Vertex{iu, iv + 1}, index::Vertex{iu + 1, iv}};
  return {index::Vertex{iu, iv}, index::Vertex{iu + 1, iv}, index::Vertex{iu, iv + 1}};
}

template <class Sum>
AttributeCounts bake_with(const Source& source, const BaseTriangle& uv, std::uint32_t level,
                          std::span<Rgba> out) {
  const Frame frame(source, uv, level);
  const TexelBox box = frame.box();
  if (box.width > longest || box.height > longest)
    throw std::invalid_argument("attribute: a triangle over more than 2^15 texels along an axis");
  const auto in_picture = source.in_picture(box);
  if (box.width * box.height > most_texels && !in_picture)
    throw std::invalid_argument("attribute: a triangle over more than 2^24 texels");
  const Exact exact(source, uv, level);
  AttributeCounts counts;
  counts.values = out.size();
  thread_local std::vector<Sum> room;
  const RowSums<Sum> sums = box.width * box.height > small_box && in_picture
                                ? source.sums_from<Sum>(*in_picture)
                                : source.sums(box, room);
  const Strips<Sum> strips(source, frame, sums, level);
  if (!strips.known()) {
    for (std::uint32_t k = 0; k < out.size(); ++k) out[k] = exact.face(index::corners(k, level));
    counts.exact = out.size();
    return counts;
  }
  strips.bake([&](std::uint32_t iu, std::uint32_t iv, std::uint32_t upper, const Rgba& codes, bool sure) {
    Rgba& to = out[on_curve(iu, iv, upper)];
    if (sure) {
      to = codes;
      return;
    }
    ++counts.exact;
    to = exact.face(corners_of(iu, iv, upper));
  });
  return counts;
}

}  // namespace

AttributeCounts bake_faces(const Source& source, const BaseTriangle& uv, std::uint32_t level,
                           std::span<Rgba> out) {
  // 255 x 2^15 < 2^24: floats hold every sum of codes.
  if (source.sampling().meaning == Meaning::srgb) return bake_with<double>(source, uv, level, out);
  return bake_with<float>(source, uv, level, out);
}

}  // namespace mmverify::impl::attribute::detail
