// A scene seen from cameras of a random path, by every form of its micromaps and by the texture alone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/scene/forms.hpp"
#include "render/tracer.hpp"

namespace mmverify::render {

/// A camera of the path, and its frame by the texture alone.
struct Seen {
  std::uint64_t number = 0;
  unsigned tries = 1;  ///< places that were tried until a ray met a triangle that gets a micromap
  Camera camera;
  Frame frame;
};

/// Camera `number` looks at a point of a triangle that gets a micromap, each placed one as likely as any other, from any
/// direction, and from half of the scene's diagonal down to a 64th of it.  Where something hides all such triangles, it
/// tries another place, up to `most_tries`.
/// Domain: a world with such a triangle; cameras count from 1.
/// Errors: as of Tracer::frame.
Seen seen_on_path(const World& world, const Tracer& tracer, const TraceOptions& trace, std::uint64_t seed,
                  std::uint64_t number);
inline constexpr unsigned most_tries = 64;

/// The first pixel that is not the texture's, by camera, row and column.
struct PixelOf {
  std::uint64_t camera;
  std::uint32_t x, y;
};

/// One form's frames along a path, held against the texture's.
struct PathRow {
  Method method = Method::texture;
  std::optional<unsigned> level = {};
  std::uint64_t frames = 0, pixels = 0, differing = 0;
  Counts counts = {};
  std::optional<PixelOf> first = {};
};
PathRow held_against(const std::vector<Seen>& path, const Tracer& tracer, const TraceOptions& trace,
                     const Opacity& opacity);

struct Path {
  std::vector<Seen> cameras;
  std::vector<PathRow> rows;  ///< square maps', then level by level
  LeftOut left_out;
};

/// Law traverse.same_image on a scene: t, triangle, instance and light of each pixel are those of the texture alone.
/// Domain: as of each_forms(); a plan with triangles; at least one camera.
/// Errors: as of each_forms() and Tracer::frame.
Path along_path(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                const Tracer& tracer, const FormsOptions& forms, const TraceOptions& trace,
                std::uint64_t seed, std::uint64_t cameras);

}  // namespace mmverify::render
