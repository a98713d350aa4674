// A frame's pictures, shaded by a scene's textures and by attribute micromaps in their place.
#pragma once

#include <functional>
#include <memory>

#include "render/camera.hpp"
#include "render/frame.hpp"
#include "render/picture.hpp"
#include "render/scene/world_of.hpp"
#include "scene/read/attributes.hpp"
#include "scene/read/shading.hpp"

namespace mmverify::render {

/// Where a surface's attributes are read.
enum class ShownFrom : std::uint8_t {
  textures,  ///< bilinear, or as the sampler says; mip level 0
  faces,     ///< the value of the micro-triangle
  vertices,  ///< between three micro-vertices
};

/// lit: a sun that casts shadows and two lamps that do not, by reflected(), and a little light from everywhere.
/// unlit: base colour times occlusion.  Source: Color and Attribute Micromaps, 5.2.
enum class Shading : std::uint8_t { lit, unlit };

struct ViewOptions {
  std::uint32_t rays = 1;  ///< along each side of a pixel, whose means of light it has
  Shading shading = Shading::lit;
  Point sun{0.4f, 1, 0.3f};  ///< towards it, as the frame was traced
  unsigned threads = 0;
  std::function<void()> stop = {};  ///< asked before each triangle, from any thread; may throw
};

/// One frame, and what its hits show.  Colours, metal and roughness, normals and occlusion are read; factors are applied
/// after the texture or map.  A triangle without a texture, or beyond scene::within_reach(), shows its factors alone.
/// Maps are baked triangle by triangle as pixels show them, and dropped: a level takes the memory of one map a thread.
class Views {
 public:
  /// All but the options' functions outlive it.
  /// Domain: a frame of this world by this camera, sides multiples of options.rays; attributes and shading of its file.
  Views(const scene::Scene& scene, const SceneWorld& world, const scene::AttributeScene& attributes,
        const std::vector<scene::PrimitiveShading>& shading, const Frame& frame, const Camera& camera,
        const ViewOptions& options);
  ~Views();
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;

  /// The same for any number of threads.  Domain: level up to scene::finest_attribute_level; of textures any.
  Picture picture(ShownFrom from, unsigned level = 0) const;

  /// By pixel: 1 where one of its rays met a triangle with a texture.
  const std::vector<std::uint8_t>& textured() const;
  /// Triangles with a texture that rays met.
  std::uint64_t triangles() const;

 private:
  class Shader;
  std::unique_ptr<Shader> shader_;
};

}  // namespace mmverify::render
