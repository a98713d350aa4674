// A scene's frame by every method at every level, compared with the frame of the texture alone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "display/render/scene/forms.hpp"
#include "display/render/scene/world_of.hpp"
#include "display/render/tracer.hpp"

namespace mmverify::render {

/// The figures of one method at one level.
struct MethodFigures {
  Method method = Method::texture;
  std::optional<unsigned> level = {};  ///< none if the method fixes its level, or has no maps
  Counts counts = {};
  std::uint64_t bytes = 0;          ///< maps, records and indices; for texture, its texels
  std::uint64_t differing = 0;      ///< pixels that differ from the texture's
  std::optional<double> flip = {};  ///< with 2 states: mean FLIP of the picture beside the texture's
  /// With 2 states, pixels that differ from the first form of the same maps.  None may.
  std::optional<std::uint64_t> apart = {};
  double seconds = 0, cpu_seconds = 0;  ///< a frame's least times over the rounds, each by itself
  double times_texture = 0;  ///< cpu_seconds over the least of the texture's frames in the same rounds
  /// The share of placed area where maps of this level call no shader, computed without a ray.
  std::optional<double> predicted = {};
  std::optional<double> even = {};  ///< the share that even rays measured: see Tracer::even_rays()
};

/// The figures of frames whose hits blend, by one method at one level.
struct BlendFigures {
  Method method = Method::texture;
  std::optional<unsigned> level = {};
  BlendedBy by = BlendedBy::shader;
  Counts counts = {};           ///< opaque: blended by a fixed function
  std::uint64_t differing = 0;  ///< pixels whose payload or accepted hit is not the texture's
  std::uint64_t spoiled = 0;    ///< pixels whose payload would differ if hits were blended in the order met
  double seconds = 0, cpu_seconds = 0;
  double saved = 0;          ///< the share of the texture's any-hit calls that are not made
  double times_texture = 0;  ///< cpu_seconds over the least of the texture's in the same rounds
};

struct CompareOptions {
  unsigned first = 6, last = 6;
  std::vector<Method> wanted = {};  ///< methods besides texture, which comes first
  TraceOptions trace = {};
  unsigned repeats = 1;  ///< rounds; each traces the texture and all forms of a level
  std::uint64_t even_rays = 200000, seed = 1;
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< bytes that all maps of a level may take
  unsigned states = 4;                  ///< 2: the methods' pictures are not the texture's; see FormsOptions
  const ColourMaps* colours = nullptr;  ///< of the pictures whose FLIP is taken
  /// Callbacks of progress, from any thread: `begins` names a task and the number of its rays or
  /// micro-triangles, and `done` counts them.  An exception from them ends the comparison.
  std::function<void(const std::string& what, std::uint64_t of)> begins = {};
  std::function<void(std::uint64_t)> done = {};
  /// Receives each frame.
  std::function<void(const MethodFigures&, const Frame&)> frame = {};
  /// If present, frames of hits that blend are traced as well, by each BlendedBy in turn.
  std::optional<Blending> blending = {};
  std::function<void(const BlendFigures&, const BlendFrame&)> blend_frame = {};

  /// The options for each_forms().
  FormsOptions forms() const {
    return {.first = first,
            .last = last,
            .wanted = wanted,
            .memory = memory,
            .threads = trace.threads,
            .states = states,
            .begins = begins,
            .done = done};
  }
};

struct Compared {
  std::vector<MethodFigures> methods;
  std::vector<BlendFigures> blends;        ///< by method, shader before fixed; the texture has shader alone
  std::optional<unsigned> first_left_out;  ///< the level whose maps would take more than the memory
  std::uint64_t wanted_bytes = 0;          ///< the bytes that they would take
};

/// Domain: world and plan of this scene; levels up to scene::finest_level.
/// Errors: as of Tracer and scene::bake(); exceptions of the callbacks.
Compared compare(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                 const Tracer& tracer, const Camera& camera, const CompareOptions& options);

}  // namespace mmverify::render
