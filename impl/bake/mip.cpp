#include "impl/bake/mip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "impl/bake/descent.hpp"
#include "impl/bake/exact/base.hpp"
#include "impl/bake/judge/bilinear.hpp"
#include "impl/bake/judge/inner_box.hpp"
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

  BakeCounts bake(const BaseTriangle& uv, std::uint32_t level, std::uint8_t* map) const override {
    return filter_ == Filter::nearest ? baked<Nearest<Texel>>(uv, level, map)
                                      : baked<Bilinear<Texel>>(uv, level, map);
  }

 private:
  template <class Judge>
  BakeCounts baked(const BaseTriangle& uv, std::uint32_t level, std::uint8_t* map) const {
    Triangle p;
    double size = 1 + double{margin_};
    for (std::size_t k = 0; k < 3; ++k) {
      // The products are exact, in 24 + 15 bits.
      p[k] = {double{uv[k].u} * width_ - Judge::offset, double{uv[k].v} * height_ - Judge::offset};
      size = std::max({size, std::fabs(p[k].x) + margin_, std::fabs(p[k].y) + margin_});
    }
    // The rounding of the offset, of each level's middle and of the margin: half a unit in the last place each.
    const double delta = (level + 11) * 0x1p-52 * size;
    InnerBox inner = inner_box(p);
    for (double* const side : {&inner.left, &inner.right, &inner.top, &inner.bottom})
      *side = std::ldexp(*side, -static_cast<int>(level));
    const ExactBase exact(sides_, uv, width_, height_, level, filter_, margin_);
    const Judge judge(sides_, exact, p, static_cast<index::Level>(level), inner, delta, margin_);
    Descent<Judge> descent(judge, map);
    if (level == 0)
      descent.single(p);
    else
      descent.node(p, false, level, 0);
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
