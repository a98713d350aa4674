// Hits that blend into a ray's payload in the place of ending it.
#pragma once

#include <cstdint>
#include <vector>

#include "impl/traverse/blend.hpp"
#include "render/attribute/colour_maps.hpp"
#include "render/frame.hpp"

namespace mmverify::render {

/// Who blends what micromaps call opaque.
enum class BlendedBy : std::uint8_t {
  shader,  ///< the any-hit shader, as in Vulkan today: instances have FORCE_NO_OPAQUE, and only T calls no shader
  fixed,  ///< traversal, by a fixed function with the colour micromap's value: only unknown states call the shader
};

/// A ray goes through every triangle with a surface; where the texture makes it opaque, its colour is blended.  Triangles
/// without a surface are accepted.
struct Blending {
  impl::traverse::Operation operation = impl::traverse::Operation::max;
  BlendedBy by = BlendedBy::fixed;
  const ColourMaps* colours = nullptr;  ///< that outlive it; a geometry without maps blends its number's grey
};

/// What changes no value: 255 of min and multiply, else 0.
std::uint32_t neutral(impl::traverse::Operation operation);

/// A colour where a geometry has no maps.
std::uint32_t grey_of(std::uint32_t colour_number);

/// What a ray met that blends or is accepted.
struct BlendHits {
  /// Those that blend, in the order in which they were met, each once; then the accepted one, if there is one.
  std::vector<impl::traverse::Hit> hits;
  Met accepted;
  Barycentrics at{0, 0};  ///< of the accepted one on its triangle
  Asked asked;
};

struct BlendPixel {
  Met accepted;
  Barycentrics at{0, 0};
  std::uint32_t payload = 0;  ///< blended before the closest accepted hit
  std::uint32_t as_met =
      0;  ///< blended as hits were met: those behind the accepted one as well, if they came first
  float shade = 0;
  Asked asked;
};

struct BlendFrame {
  std::uint32_t width = 0, height = 0;
  std::vector<BlendPixel> pixels;  ///< rows from the top
  Counts counts;                   ///< opaque: blended by a fixed function
  double seconds = 0, cpu_seconds = 0;
};

/// Pixels whose payload or accepted hit is another one.  Domain: frames of one size, else std::invalid_argument.
std::uint64_t differing(const BlendFrame& a, const BlendFrame& b);
/// Pixels whose payload would be another one if hits were blended as they are met.
std::uint64_t spoiled_as_met(const BlendFrame& frame);

}  // namespace mmverify::render
