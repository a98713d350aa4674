// A scene's frame by every method at every level, held against the frame that the texture alone decides.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/scene/forms.hpp"
#include "render/scene/world_of.hpp"
#include "render/tracer.hpp"

namespace mmverify::render {

/// Of one method at one level.
struct MethodFigures {
  Method method = Method::texture;
  std::optional<unsigned> level = {};  ///< none where the method's maps have their own, or there are none
  Counts counts = {};
  std::uint64_t bytes = 0;              ///< of maps, records and indices; of texture: of its texels
  std::uint64_t differing = 0;          ///< pixels
  double seconds = 0, cpu_seconds = 0;  ///< of a frame: the least of the repetitions, each by itself
  double times_texture = 0;  ///< cpu_seconds, the least of the texture's frames of the same rounds being 1
  /// The share of placed area where maps of this level call no shader: what is predicted without a ray.
  std::optional<double> predicted = {};
  std::optional<double> even = {};  ///< the share that even rays met: see Tracer::even_rays()
};

/// Of hits that blend, by one method at one level.
struct BlendFigures {
  Method method = Method::texture;
  std::optional<unsigned> level = {};
  BlendedBy by = BlendedBy::shader;
  Counts counts = {};           ///< opaque: blended by a fixed function
  std::uint64_t differing = 0;  ///< pixels whose payload or accepted hit is not the texture's
  std::uint64_t spoiled =
      0;  ///< pixels whose payload would be another one, were hits blended as they are met
  double seconds = 0, cpu_seconds = 0;
  double saved = 0;          ///< the share of any-hit calls, of those that the texture alone makes
  double times_texture = 0;  ///< cpu_seconds, the least of the texture's of the same rounds being 1
};

struct CompareOptions {
  unsigned first = 6, last = 6;
  std::vector<Method> wanted = {};  ///< besides texture, which comes first
  TraceOptions trace = {};
  unsigned repeats = 1;  ///< rounds: the texture and all forms of a level, one after the other
  std::uint64_t even_rays = 200000, seed = 1;
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< bytes that all maps of a level may take
  /// Told what is being done, and how many rays or micro-triangles are done, from any thread; what they throw ends it.
  std::function<void(const std::string& what, std::uint64_t of)> begins = {};
  std::function<void(std::uint64_t)> done = {};
  /// Told of each frame.
  std::function<void(const MethodFigures&, const Frame&)> frame = {};
  /// Frames of hits that blend as well; of whom blends, the rows say.
  std::optional<Blending> blending = {};
  std::function<void(const BlendFigures&, const BlendFrame&)> blend_frame = {};

  /// Of these, what forms of maps go by.
  FormsOptions forms() const {
    return {.first = first,
            .last = last,
            .wanted = wanted,
            .memory = memory,
            .threads = trace.threads,
            .begins = begins,
            .done = done};
  }
};

struct Compared {
  std::vector<MethodFigures> methods;
  std::vector<BlendFigures>
      blends;  ///< by method, the shader before fixed functions; the texture has the shader
  std::optional<unsigned> first_left_out;  ///< the level whose maps would take more than the memory
  std::uint64_t wanted_bytes = 0;          ///< that it would
};

/// Domain: world and plan of this scene; levels up to scene::finest_level.
/// Errors: as of Tracer and scene::bake(); what the functions of the options throw.
Compared compare(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                 const Tracer& tracer, const Camera& camera, const CompareOptions& options);

}  // namespace mmverify::render
