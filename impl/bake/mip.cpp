#include "impl/bake/mip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "impl/bake/descent.hpp"
#include "impl/bake/exact/later.hpp"
#include "impl/bake/judge/bilinear.hpp"
#include "impl/bake/judge/nearest.hpp"
#include "impl/bake/texture/properties.hpp"

namespace mmverify::impl::bake::detail {
namespace {

template <class Texel>
constexpr std::int64_t full = std::numeric_limits<Texel>::max();
template <>
constexpr std::int64_t full<float> = 1;

template <class Texel>
const TexelView<Texel>& checked(const TexelView<Texel>& t) {
  if (t.width == 0 || t.width > 16384 || t.height == 0 || t.height > 16384)
    throw std::invalid_argument("bake: a texture has 1 to 16384 texels along each side");
  if (t.texels == nullptr) throw std::invalid_argument("bake: a texture without texels");
  if (t.pitch > PTRDIFF_MAX / sizeof(Texel) / t.height)
    throw std::invalid_argument("bake: a texture larger than memory can be");
  return t;
}

template <class Texel>
Texel border_of(float border) {
  if (!std::isfinite(border)) throw std::invalid_argument("bake: a border that is not finite");
  if constexpr (!std::is_same_v<Texel, float>) {
    if (!(border >= 0 && border <= static_cast<float>(full<Texel>)) || border != std::floor(border))
      throw std::invalid_argument("bake: a border that is no such texel");
  }
  return static_cast<Texel>(border);
}

template <class Texel>
class Mip final : public MipBaker {
 public:
  Mip(const TexelView<Texel>& texture, const AlphaMode& mode, const Sampling& s)
      : width_(texture.width),
        height_(texture.height),
        filter_(s.filter),
        margin_(s.margin),
        sides_(checked(texture), limits_of(mode, s.factors, full<Texel>), s.u, s.v,
               border_of<Texel>(s.border)) {}

  BakeCounts bake(const MovingTriangle& uv, std::uint32_t level, std::uint8_t* map,
                  const std::vector<Node>* only) const override {
    return filter_ == Filter::nearest ? baked<Nearest<Texel>>(uv, level, map, only)
                                      : baked<Bilinear<Texel>>(uv, level, map, only);
  }

  bool holds(const Box& b) const override {
    return b.x <= width_ && b.width <= width_ - b.x && b.y <= height_ && b.height <= height_ - b.y;
  }

  bool may_read(const UvBox& places, const Box& box) const override {
    // Corners of nodes are off by less than 2^-14 texel: 12 halvings of coordinates below 2^34 texels.
    constexpr double rounding = 0x1p-10;
    const bool linear = filter_ == Filter::bilinear;
    const double before = rounding + margin_ + (linear ? 0.5 : 0), after = before + (linear ? 0.5 : 0);
    return sides_.meets(floored(places.left * width_ - before), floored(places.right * width_ + after),
                        floored(places.top * height_ - before), floored(places.bottom * height_ + after),
                        box);
  }

 private:
  /// The dilation along an axis: margin + range x texels, rounded up.  Without a margin the product of 24 and 15 bits is
  /// exact.
  double dilation(float range, std::uint32_t texels) const {
    const double product = double{range} * texels, margin = margin_, sum = product + margin,
                 more = std::max(product, margin), less = std::min(product, margin);
    return less > sum - more ? std::nextafter(sum, HUGE_VAL) : sum;
  }

  template <class Judge>
  BakeCounts baked(const MovingTriangle& moving, std::uint32_t level, std::uint8_t* map,
                   const std::vector<Node>* only) const {
    const BaseTriangle& uv = moving.middle;
    const Dilation dilated{dilation(moving.across, width_), dilation(moving.down, height_)};
    Triangle p;
    double size = 1 + std::max(dilated.x, dilated.y);
    for (std::size_t k = 0; k < 3; ++k) {
      // The products are exact, in 24 + 15 bits.
      p[k] = {double{uv[k].u} * width_ - Judge::offset, double{uv[k].v} * height_ - Judge::offset};
      size = std::max({size, std::fabs(p[k].x) + dilated.x, std::fabs(p[k].y) + dilated.y});
    }
    // The rounding of the offset, of each level's middle and of the dilation: half a unit in the last place each.
    const double delta = (level + 11) * 0x1p-52 * size;
    const ExactLater exact(sides_, uv, width_, height_, level, filter_, dilated);
    const Judge judge(sides_, exact, p, static_cast<index::Level>(level), delta, dilated);
    Descent<Judge> descent(judge, map);
    if (only == nullptr)
      descent.part(p, level, {0, level});
    else
      for (const Node& one : *only) descent.part(p, level, one);
    return descent.counts;
  }

  std::uint32_t width_, height_;
  Filter filter_;
  float margin_;
  TexturePropertiesOf<Texel> sides_;
};

}  // namespace

std::unique_ptr<const MipBaker> mip_baker(const Texels& texels, const AlphaMode& mode,
                                          const Sampling& sampling) {
  return std::visit(
      [&]<class Texel>(const TexelView<Texel>& t) -> std::unique_ptr<const MipBaker> {
        return std::make_unique<Mip<Texel>>(t, mode, sampling);
      },
      texels);
}

}  // namespace mmverify::impl::bake::detail
