// Hits that blend into a ray's payload instead of ending the ray.
#pragma once

#include <cstdint>
#include <vector>

#include "display/render/attribute/colour_maps.hpp"
#include "display/render/frame.hpp"
#include "impl/traverse/blend.hpp"

namespace mmverify::render {

/// The stage that blends a hit that its micromap calls opaque.
enum class BlendedBy : std::uint8_t {
  shader,  ///< the any-hit shader, as in Vulkan today: instances have FORCE_NO_OPAQUE, and only T calls no shader
  fixed,  ///< traversal, by a fixed function with the colour micromap's value: only unknown states call the shader
};

/// The rules of blending.  A ray goes through every triangle with a surface, and blends the triangle's colour
/// if the texture makes the hit opaque.  A triangle without a surface is accepted.
struct Blending {
  impl::traverse::Operation operation = impl::traverse::Operation::max;
  BlendedBy by = BlendedBy::fixed;
  const ColourMaps* colours =
      nullptr;  ///< must outlive this; a geometry without maps blends grey_of(its colour number)
};

/// The payload that blending starts from, which changes no value: 255 a channel for min and multiply, else 0.
std::uint32_t neutral(impl::traverse::Operation operation);

/// The grey that a geometry without maps blends.
std::uint32_t grey_of(std::uint32_t colour_number);

/// The hits along one ray that blend, and the hit that is accepted.
struct BlendHits {
  /// The blending hits in the order in which the ray met them, each once; then the accepted hit, if there is
  /// one.
  std::vector<impl::traverse::Hit> hits;
  Met accepted;
  Barycentrics at{0, 0};  ///< the accepted hit on its triangle
  ShaderCalls asked;
};

struct BlendPixel {
  Met accepted;
  Barycentrics at{0, 0};
  std::uint32_t payload = 0;  ///< the hits before the closest accepted hit, blended
  std::uint32_t as_met =
      0;  ///< all hits blended in the order met: also hits behind the accepted one that came first
  float shade = 0;
  ShaderCalls asked;
};

struct BlendFrame {
  std::uint32_t width = 0, height = 0;
  std::vector<BlendPixel> pixels;  ///< rows from the top
  Counts counts;                   ///< opaque: blended by a fixed function
  double seconds = 0, cpu_seconds = 0;
};

/// The number of pixels whose payload or accepted hit differs.  Domain: frames of one size, else
/// std::invalid_argument.
std::uint64_t differing(const BlendFrame& a, const BlendFrame& b);
/// The number of pixels whose payload would differ if hits were blended in the order met.
std::uint64_t spoiled_as_met(const BlendFrame& frame);

}  // namespace mmverify::render
