// A baker of one surface of a plan.
#pragma once

#include "impl/bake/triangles.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::scene {

/// The inputs from which a surface's maps are baked.  The texels are the scene's.
struct SurfaceInputs {
  impl::bake::Texels texels;
  impl::bake::Sampling sampling;
  impl::bake::AlphaMode mode;
};
/// Domain: a surface of a plan of this scene.
SurfaceInputs surface_inputs(const Scene& scene, const Surface& surface, float margin = 0);

/// The baker of a surface.  Alpha is filtered as filter_of() says; mip levels below the first are the
/// renderer's own and are not baked.  Margin: in texels; see impl::bake::Sampling.
/// Domain: a surface of a plan of this scene, which outlives the baker.
/// Errors: std::invalid_argument as of impl::bake::TriangleBaker.
impl::bake::TriangleBaker surface_baker(const Scene& scene, const Surface& surface, float margin = 0);

}  // namespace mmverify::scene
