#include "scene/bake/surface_baker.hpp"

#include <span>
#include <variant>

#include "scene/bake/wrap.hpp"

namespace mmverify::scene {
SurfaceInputs surface_inputs(const Scene& scene, const Surface& surface, float margin) {
  const Image& image = scene.images.at(surface.image);
  const impl::bake::Texels texels = std::visit(
      [&image]<class Texel>(const std::vector<Texel>& alpha) -> impl::bake::Texels {
        return impl::bake::TexelView<Texel>{alpha.data(), image.width, image.height, image.width};
      },
      image.alpha);
  impl::bake::Sampling sampling;
  sampling.u = wrap_of(surface.sampler.wrap_u);
  sampling.v = wrap_of(surface.sampler.wrap_v);
  if (filter_of(surface.sampler) == Filter::nearest) sampling.filter = impl::bake::Filter::nearest;
  sampling.factors = {surface.base_color_alpha, surface.vertex_alpha};
  sampling.margin = margin;
  const impl::bake::AlphaMode mode = surface.mode == AlphaMode::mask
                                         ? impl::bake::AlphaMode(impl::bake::Mask{surface.cutoff})
                                         : impl::bake::AlphaMode(impl::bake::Blend{});
  return {texels, sampling, mode};
}

impl::bake::TriangleBaker surface_baker(const Scene& scene, const Surface& surface, float margin) {
  const SurfaceInputs inputs = surface_inputs(scene, surface, margin);
  return impl::bake::TriangleBaker(std::span(&inputs.texels, 1), inputs.mode, inputs.sampling);
}

}  // namespace mmverify::scene
