// A tracer of rays through a world, by Embree, whose filter functions stand for any-hit shaders.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "display/render/blend.hpp"
#include "display/render/camera.hpp"
#include "display/render/frame.hpp"
#include "display/render/opacity.hpp"

namespace mmverify::render {

/// Whether this was built with Embree's headers and its library is found; otherwise no Tracer can be made.
bool has_embree();
/// "Embree 3.13.5", or why Embree is missing and what would help.
std::string embree_text();

struct TraceOptions {
  std::uint32_t width = 640, height = 480;
  unsigned threads = 0;  ///< 0: as many as the machine has
  bool shadows = true;
  Point light{0.4f, 1, 0.3f};  ///< the direction to the light, of any length
  unsigned ambient = 0;        ///< rays of ambient occlusion from each hit, up to most_ambient
  std::uint64_t seed = 1;      ///< of their directions
  /// Counts finished primary rays, from any thread; an exception from it ends the frame.
  std::function<void(std::uint64_t)> done = {};
};

inline constexpr unsigned most_ambient = 64;

/// A world with its bounding volumes, built once for all methods, so that all methods meet the same
/// candidates.
class Tracer {
 public:
  /// The world outlives the tracer.
  /// Errors: std::runtime_error without Embree, and with Embree's error number if Embree fails.
  explicit Tracer(const World& world);
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// Traces a primary ray a pixel, and, if it hits, a shadow ray and `options.ambient` rays of ambient occlusion, whose
  /// directions about_normal() derives from seed, pixel and number alone.  For a candidate on a surface,
  /// impl::traverse::decide turns the state in `opacity` into ignored, opaque or non-opaque.  The texture
  /// decides non-opaque candidates, and candidates without a micromap, at the same barycentrics.  If
  /// `opacity` is null, the texture decides all.
  /// The pixels and counts do not depend on the number of threads.
  /// Errors: std::invalid_argument for a side of 0 or above 16384, or more than most_ambient rays; exceptions of `done`.
  Frame frame(const Camera& camera, const Opacity* opacity, const TraceOptions& options) const;

  /// One pixel of such a frame.  Domain: x and y below the frame's sides.
  Pixel pixel(const Camera& camera, const Opacity* opacity, const TraceOptions& options, std::uint32_t x,
              std::uint32_t y) const;

  /// Traces rays that meet all surfaces evenly over their area: lines of all directions, even through a ball
  /// around the placed surfaces.  A ray passes through everything: each candidate counts, and no texture is
  /// read.  By Cauchy and Crofton's formula, a surface is met in proportion to its area, wherever it is.
  /// The counts do not depend on the number of threads.
  Counts even_rays(const Opacity& opacity, std::uint64_t rays, std::uint64_t seed,
                   unsigned threads = 0) const;

  /// Traces a primary ray a pixel whose hits on surfaces blend.  A pixel's payload is neutral() blended with
  /// all hits before the accepted one (impl::traverse::blended); `as_met` blends the hits in the order met.
  /// Candidates are decided as in frame(), with the same chance; `blending.by` blends a hit that its map
  /// calls opaque.  Shadows are not traced.
  /// The frame does not depend on the number of threads.  Errors: as of frame().
  BlendFrame blend_frame(const Camera& camera, const Opacity* opacity, const Blending& blending,
                         const TraceOptions& options) const;

  /// The hits of one pixel's ray.  Domain: that of pixel().
  BlendHits blend_hits(const Camera& camera, const Opacity* opacity, const Blending& blending,
                       const TraceOptions& options, std::uint32_t x, std::uint32_t y) const;

  /// The closest accepted hit of one ray.  Its candidates are added to `counts`; the `chance` of BLEND
  /// derives from `number`.
  Met first_hit(const Ray& ray, const Opacity* opacity, std::uint64_t number, Counts& counts) const;

 private:
  struct EmbreeScene;
  std::unique_ptr<EmbreeScene> built_;
};

}  // namespace mmverify::render
