#include "impl/scene/surface_baker.hpp"

#include <span>
#include <variant>

namespace mmverify::impl::scene {
namespace {

bake::Wrap wrap(Wrap w) {
  switch (w) {
    case Wrap::repeat:
      return bake::Wrap::repeat;
    case Wrap::mirrored_repeat:
      return bake::Wrap::mirrored_repeat;
    case Wrap::clamp_to_edge:
      break;
  }
  return bake::Wrap::clamp_to_edge;
}

}  // namespace

bake::TriangleBaker surface_baker(const Scene& scene, const Surface& surface, float margin) {
  const Image& image = scene.images.at(surface.image);
  const bake::Texels texels = std::visit(
      [&image]<class Texel>(const std::vector<Texel>& alpha) -> bake::Texels {
        return bake::TexelView<Texel>{alpha.data(), image.width, image.height, image.width};
      },
      image.alpha);
  bake::Sampling sampling;
  sampling.u = wrap(surface.sampler.wrap_u);
  sampling.v = wrap(surface.sampler.wrap_v);
  if (filter_of(surface.sampler) == Filter::nearest) sampling.filter = bake::Filter::nearest;
  sampling.factors = {surface.base_color_alpha, surface.vertex_alpha};
  sampling.margin = margin;
  const bake::AlphaMode mode = surface.mode == AlphaMode::mask ? bake::AlphaMode(bake::Mask{surface.cutoff})
                                                               : bake::AlphaMode(bake::Blend{});
  return bake::TriangleBaker(std::span(&texels, 1), mode, sampling);
}

}  // namespace mmverify::impl::scene
