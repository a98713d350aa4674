// A scene seen from cameras of a random path, by every form of its micromaps and by the texture alone.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "display/render/scene/forms.hpp"
#include "display/render/tracer.hpp"

namespace mmverify::render {

/// A camera of the path, and its frame by the texture alone.
struct CameraView {
  std::uint64_t number = 0;
  unsigned tries = 1;  ///< places tried until a ray met a triangle that gets a micromap
  Camera camera;
  Frame frame;
};

/// Camera `number` looks at a random point of a triangle that gets a micromap; each placed triangle is
/// equally likely.  The direction is random.  The distance is from half the diagonal of the box around all
/// surfaces down to a 64th of it.  If no ray meets such a triangle, the camera tries another place, up to
/// `most_tries`.
/// Domain: a world with such a triangle; cameras count from 1.
/// Errors: as of Tracer::frame.
CameraView seen_on_path(const World& world, const Tracer& tracer, const TraceOptions& trace,
                        std::uint64_t seed, std::uint64_t number);
inline constexpr unsigned most_tries = 64;

/// The first pixel that differs from the texture's frame, in the order of cameras, rows and columns.
struct PixelOf {
  std::uint64_t camera;
  std::uint32_t x, y;
};

/// A figure over the cameras of a path, each of the same weight.
struct Spread {
  double mean = 0, least = 0, most = 0;
  double deviation = 0;  ///< the root of the mean square of the distance from the mean
};
/// Domain: any values; all 0 without one.
Spread spread_of(std::span<const double> values);

/// The frames of one form along a path, compared with the texture's.
struct PathRow {
  Method method = Method::texture;
  std::optional<unsigned> level = {};
  std::uint64_t frames = 0, pixels = 0, differing = 0;
  Counts counts = {};
  std::optional<PixelOf> first = {};
  std::vector<double> calls_a_ray = {};    ///< by camera: any-hit calls over rays of all kinds
  std::vector<double> times_texture = {};  ///< by camera: processor time over that of the texture's frame
};
PathRow held_against(const std::vector<CameraView>& path, const Tracer& tracer, const TraceOptions& trace,
                     const Opacity& opacity);

struct Path {
  std::vector<CameraView> cameras;
  std::vector<PathRow> rows;  ///< the square maps' rows, then level by level
  LeftOut left_out;
};

/// Law traverse.same_image on a scene: each pixel has the t, triangle, instance and light of the texture alone.
/// Domain: as of each_forms(); a plan with triangles; at least one camera.
/// Errors: as of each_forms() and Tracer::frame.
Path along_path(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                const Tracer& tracer, const FormsOptions& forms, const TraceOptions& trace,
                std::uint64_t seed, std::uint64_t cameras);

}  // namespace mmverify::render
