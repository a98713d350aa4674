// Vertices of a base triangle.  docs/ATTRIBUTE_BOUNDS.md, "A vertex", derives the bounds.
#include "impl/attribute/bake/vertices.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "impl/attribute/bake/exact.hpp"
#include "impl/attribute/bake/frame.hpp"

namespace mmverify::impl::attribute::detail {
namespace {

template <class Channel>
class Row {
 public:
  Row(const Source<Channel>& source, const Frame& frame)
      : source_(source), frame_(frame), in_picture_(source.in_picture(frame.box())) {
    if constexpr (!floats)
      for (std::size_t k = 0; k < 4; ++k)
        // m (16 u E + 8 u)
        bound_[k] = source_.coding().full(k) * (2 * frame.position + 8 * half_ulp);
  }

  RgbaOf<Channel> bilinear(const Point& p, bool& sure) const noexcept {
    const double x = p.x - 0.5, y = p.y - 0.5;  // in cells, 1/2 and more
    const auto i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
    const double f = x - static_cast<double>(i), h = y - static_cast<double>(j);
    const std::array<const Channel*, 4> texels = cell(i, j);
    const std::array<double, 4> weight{(1 - f) * (1 - h), f * (1 - h), (1 - f) * h, f * h};
    const Channel *const a = texels[0], *const b = texels[1], *const c = texels[2], *const d = texels[3];
    std::array<double, 4> mean;
    for (std::size_t k = 0; k < 4; ++k) {
      mean[k] = weight[0] * value(a, k);
      if constexpr (floats) mean[k] += 0.0;  // -0 is 0
      mean[k] = mean[k] + weight[1] * value(b, k) + weight[2] * value(c, k) + weight[3] * value(d, k);
    }
    if constexpr (floats) {
      const double near = frame_.position;
      const bool inside = f > near && f < 1 - near && h > near && h < 1 - near;
      return source_.coding().encoded(mean, inside ? bound_by(texels) : bound_around(i, j), sure);
    }
    return source_.coding().encoded(mean, bound_, sure);
  }

  RgbaOf<Channel> nearest(const Point& p, bool& sure) const noexcept {
    const auto i = static_cast<std::int64_t>(p.x), j = static_cast<std::int64_t>(p.y);
    const double f = p.x - static_cast<double>(i), h = p.y - static_cast<double>(j), near = frame_.position;
    // Nearer to the texel's edge, the true place may lie in the next texel.
    if (f < near || f > 1 - near || h < near || h > 1 - near) sure = false;
    const Channel* const texel = source_.texel(source_.column(frame_.left + i), source_.row(frame_.top + j));
    return source_.coding().encoded({value(texel, 0), value(texel, 1), value(texel, 2), value(texel, 3)},
                                    bound_, sure);
  }

 private:
  static constexpr bool floats = std::is_same_v<Channel, float>;

  /// The bound from the greatest |value| of some texels.
  template <std::size_t count>
  std::array<double, 4> bound_by(const std::array<const Channel*, count>& texels) const noexcept {
    std::array<double, 4> bound{};
    for (std::size_t k = 0; k < 4; ++k) {
      for (const Channel* const texel : texels) bound[k] = std::max(bound[k], std::fabs(value(texel, k)));
      bound[k] *= 4 * frame_.position + 12 * half_ulp;  // m (32 u E + 12 u)
    }
    return bound;
  }
  /// The bound from the texels of a cell and of the eight cells around it.
  std::array<double, 4> bound_around(std::int64_t i, std::int64_t j) const noexcept {
    std::array<const Channel*, 16> texels;
    for (std::size_t t = 0; t < 4; ++t) {
      const std::int64_t x = i - 1 + 2 * static_cast<std::int64_t>(t % 2),
                         y = j - 1 + 2 * static_cast<std::int64_t>(t / 2);
      const auto four = cell(x, y);
      std::copy(four.begin(), four.end(), texels.begin() + static_cast<std::ptrdiff_t>(4 * t));
    }
    return bound_by(texels);
  }

  double value(const Channel* texel, std::size_t k) const noexcept {
    return source_.coding().value(texel[k], k);
  }

  std::array<const Channel*, 4> cell(std::int64_t i, std::int64_t j) const noexcept {
    if (in_picture_) {
      const Channel* const first = source_.texel(in_picture_->x + i, in_picture_->y + j);
      const std::size_t line = 4 * source_.texture().pitch;
      return {first, first + 4, first + line, first + line + 4};
    }
    const std::int64_t x = source_.column(frame_.left + i), right = source_.column(frame_.left + i + 1),
                       y = source_.row(frame_.top + j), below = source_.row(frame_.top + j + 1);
    return {source_.texel(x, y), source_.texel(right, y), source_.texel(x, below),
            source_.texel(right, below)};
  }

  const Source<Channel>& source_;
  const Frame& frame_;
  std::optional<typename Source<Channel>::InPicture> in_picture_;
  std::array<double, 4> bound_{};  ///< for codes
};

}  // namespace

template <class Channel>
AttributeCounts bake_vertices(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level,
                              std::span<RgbaOf<Channel>> out) {
  const Frame frame(source, uv, level);
  const Row<Channel> row(source, frame);
  const Exact<Channel> exact(source, uv, level);
  AttributeCounts counts;
  counts.values = out.size();
  const bool nearest = source.sampling().filter == Filter::nearest;
  const std::uint32_t side = std::uint32_t{1} << level;
  RgbaOf<Channel>* to = out.data();
  for (std::uint32_t r = 0; r <= side; ++r)
    for (std::uint32_t j = 0; j <= r; ++j, ++to) {
      bool sure = true;
      const Point p = frame.at(r - j, j);
      *to = nearest ? row.nearest(p, sure) : row.bilinear(p, sure);
      if (sure) continue;
      ++counts.exact;
      *to = exact.vertex({r - j, j});
    }
  return counts;
}

template AttributeCounts bake_vertices(const Source<std::uint8_t>&, const BaseTriangle&, std::uint32_t,
                                       std::span<Rgba>);
template AttributeCounts bake_vertices(const Source<std::uint16_t>&, const BaseTriangle&, std::uint32_t,
                                       std::span<Rgba16>);
template AttributeCounts bake_vertices(const Source<float>&, const BaseTriangle&, std::uint32_t,
                                       std::span<RgbaFloat>);

}  // namespace mmverify::impl::attribute::detail
