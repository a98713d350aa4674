// Rays through a world, by Embree, whose filter functions stand for any-hit shaders.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "render/blend.hpp"
#include "render/camera.hpp"
#include "render/frame.hpp"
#include "render/opacity.hpp"

namespace mmverify::render {

/// Whether Embree was there when this was built; without it a Tracer cannot be made.
bool has_embree();
/// "Embree 3.13.5", or why there is none and what would help.
std::string embree_text();

struct TraceOptions {
  std::uint32_t width = 640, height = 480;
  unsigned threads = 0;  ///< 0: as many as the machine has
  bool shadows = true;
  Point light{0.4f, 1, 0.3f};  ///< towards it; not of unit length
  /// Told of primary rays done, from any thread; what it throws ends the frame.
  std::function<void(std::uint64_t)> done = {};
};

/// A world with its bounding volumes, built once for all methods, so that they all meet the same candidates.
class Tracer {
 public:
  /// The world outlives it.
  /// Errors: std::runtime_error without Embree, and with Embree's words where it fails.
  explicit Tracer(const World& world);
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// A primary ray a pixel, and a shadow ray where that hits.  A candidate on a surface is asked for in `opacity`, whose
  /// state impl::traverse::decide turns into ignored, opaque or non-opaque; the last one, and each candidate without a
  /// micromap, is decided by the texture at the same barycentrics.  Null: the texture decides all.
  /// The same pixels and counts for any number of threads.
  /// Errors: std::invalid_argument for a side of 0 or above 16384; what `done` throws.
  Frame frame(const Camera& camera, const Opacity* opacity, const TraceOptions& options) const;

  /// One pixel of such a frame.  Domain: x and y below the frame's sides.
  Pixel pixel(const Camera& camera, const Opacity* opacity, const TraceOptions& options, std::uint32_t x,
              std::uint32_t y) const;

  /// Rays that meet all surfaces evenly over their area: lines of all directions, evenly through a ball around what is
  /// placed.  They pass through everything, and end on nothing: each candidate counts, and no texture is read.  By
  /// Cauchy and Crofton's formula a surface is met in proportion to its area, from wherever.
  /// The same for any number of threads.
  Counts even_rays(const Opacity& opacity, std::uint64_t rays, std::uint64_t seed,
                   unsigned threads = 0) const;

  /// A primary ray a pixel, whose hits on surfaces blend: each pixel's payload, of neutral() and all hits before the
  /// accepted one (impl::traverse::blended), and beside it what blending them as they are met would give.
  /// A candidate is asked for as in frame(), by the same chance; what a map says is opaque is blended by whom
  /// `blending` names.  Shadows are not traced.
  /// The same for any number of threads.  Errors: as of frame().
  BlendFrame blend_frame(const Camera& camera, const Opacity* opacity, const Blending& blending,
                         const TraceOptions& options) const;

  /// What one pixel's ray met.  Domain: that of pixel().
  BlendHits blend_hits(const Camera& camera, const Opacity* opacity, const Blending& blending,
                       const TraceOptions& options, std::uint32_t x, std::uint32_t y) const;

  /// One ray, with its candidates; `chance` of BLEND is made of the ray's number.
  Met first_hit(const Ray& ray, const Opacity* opacity, std::uint64_t number, Counts& counts) const;

 private:
  struct Built;
  std::unique_ptr<Built> built_;
};

}  // namespace mmverify::render
