// Bound.  Positions are within 8 u E of the true ones (frame.hpp), and the bilinear number changes by m a texel along
// each axis at most: 16 u E m.  Weights and sums of four numbers up to m add 8 u m.  Nearest: the texel is sure where
// the position is not that near a texel's edge.
#include "impl/attribute/bake/vertices.hpp"

#include <cmath>

#include "impl/attribute/bake/exact.hpp"
#include "impl/attribute/bake/frame.hpp"

namespace mmverify::impl::attribute::detail {
namespace {

class Row {
 public:
  Row(const Source& source, const Frame& frame)
      : source_(source), frame_(frame), in_picture_(source.in_picture(frame.box())) {
    for (std::size_t k = 0; k < 4; ++k)
      bound_[k] = source.curves()[k]->full * (2 * frame.position + 8 * half_ulp);
  }

  Rgba bilinear(const Point& p, bool& sure) const noexcept {
    const double x = p.x - 0.5, y = p.y - 0.5;  // 1/2 and more: of cells
    const auto i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
    const double f = x - static_cast<double>(i), h = y - static_cast<double>(j);
    const std::array<const std::uint8_t*, 4> texels = cell(i, j);
    const std::array<double, 4> weight{(1 - f) * (1 - h), f * (1 - h), (1 - f) * h, f * h};
    std::array<double, 4> value{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t t = 0; t < 4; ++t) value[k] += weight[t] * number(texels[t], k);
    return encoded(value, bound_, source_.sampling().meaning, source_.curves(), sure);
  }

  Rgba nearest(const Point& p, bool& sure) const noexcept {
    const auto i = static_cast<std::int64_t>(p.x), j = static_cast<std::int64_t>(p.y);
    const double f = p.x - static_cast<double>(i), h = p.y - static_cast<double>(j), near = frame_.position;
    if (f < near || f > 1 - near || h < near || h > 1 - near) sure = false;
    const std::uint8_t* const texel =
        source_.bytes(source_.column(frame_.left + i), source_.row(frame_.top + j));
    return encoded({number(texel, 0), number(texel, 1), number(texel, 2), number(texel, 3)}, bound_,
                   source_.sampling().meaning, source_.curves(), sure);
  }

 private:
  double number(const std::uint8_t* texel, std::size_t k) const noexcept {
    return source_.curves()[k]->value[texel[k]];
  }

  std::array<const std::uint8_t*, 4> cell(std::int64_t i, std::int64_t j) const noexcept {
    if (in_picture_) {
      const std::uint8_t* const first = source_.bytes(in_picture_->x + i, in_picture_->y + j);
      const std::size_t line = 4 * source_.texture().pitch;
      return {first, first + 4, first + line, first + line + 4};
    }
    const std::int64_t x = source_.column(frame_.left + i), right = source_.column(frame_.left + i + 1),
                       y = source_.row(frame_.top + j), below = source_.row(frame_.top + j + 1);
    return {source_.bytes(x, y), source_.bytes(right, y), source_.bytes(x, below),
            source_.bytes(right, below)};
  }

  const Source& source_;
  const Frame& frame_;
  std::optional<Source::InPicture> in_picture_;
  std::array<double, 4> bound_;
};

}  // namespace

AttributeCounts bake_vertices(const Source& source, const BaseTriangle& uv, std::uint32_t level,
                              std::span<Rgba> out) {
  const Frame frame(source, uv, level);
  const Row row(source, frame);
  const Exact exact(source, uv, level);
  AttributeCounts counts;
  counts.values = out.size();
  const bool nearest = source.sampling().filter == Filter::nearest;
  const std::uint32_t side = std::uint32_t{1} << level;
  Rgba* to = out.data();
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

}  // namespace mmverify::impl::attribute::detail
