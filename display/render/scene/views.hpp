// A frame's pictures, shaded by a scene's textures, or by attribute micromaps in their place.
#pragma once

#include <functional>
#include <memory>

#include "display/render/attribute/cones.hpp"
#include "display/render/camera.hpp"
#include "display/render/frame.hpp"
#include "display/render/picture.hpp"
#include "display/render/scene/world_of.hpp"
#include "scene/read/attributes.hpp"
#include "scene/read/shading.hpp"

namespace mmverify::render {

/// The source of a surface's attributes.
enum class ShownFrom : std::uint8_t {
  textures,  ///< the texture by its sampler's filter, mip level 0
  faces,     ///< the value of the micro-triangle
  vertices,  ///< interpolated between three micro-vertices
};

/// lit: a sun that casts shadows and two lamps that do not, by reflected(), and a little light from
/// everywhere.
/// unlit: base colour times occlusion.
/// normals: the unit normal n in the scene's own space, as the code of (n + 1)/2 in each channel.
/// Source: Color and Attribute Micromaps, 5.2.
enum class Shading : std::uint8_t { lit, unlit, normals };

/// The level at which maps are read.
enum class Detail : std::uint8_t {
  finest,  ///< the maps' own
  cones,  ///< two of their mips, by the cone of each ray.  Source: Color and Attribute Micromaps, 4.4.2 and figure 8
};

struct ViewOptions {
  std::uint32_t rays = 1;  ///< along each side of a pixel, which shows their mean light
  Shading shading = Shading::lit;
  Point sun{0.4f, 1, 0.3f};  ///< the direction to the sun, as the frame was traced
  unsigned threads = 0;
  std::function<void()> stop = {};  ///< called before each triangle, from any thread; may throw
};

/// The pictures of one frame.  Colours, metal and roughness, normals and occlusion come from textures or
/// maps, to which the material's factors are applied.  A triangle without a texture, or beyond
/// scene::within_reach(), shows its factors alone.
/// A triangle's maps are baked if pixels show it, and then dropped: a level takes the memory of one map a
/// thread.
class Views {
 public:
  /// Domain: a frame of this world by this camera, sides multiples of options.rays; attributes and shading of
  /// its file.  All but `camera` and `options`, which are copied, outlive the object.
  Views(const scene::Scene& scene, const SceneWorld& world, const scene::AttributeScene& attributes,
        const std::vector<scene::PrimitiveShading>& shading, const Frame& frame, const Camera& camera,
        const ViewOptions& options);
  ~Views();
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;

  /// The picture, the same for any number of threads.  Domain: level up to scene::finest_attribute_level; any
  /// for textures.
  Picture picture(ShownFrom from, unsigned level = 0, Detail detail = Detail::finest) const;

  /// The levels that a hit's cone asks of maps of level `finest`.  The cone begins as a point at the camera, and a ray's
  /// share of the picture is its width.  Domain: the number of a pixel of the frame, which is hit.
  DetailLevel detail(std::uint32_t pixel, unsigned finest) const;

  /// A value for each pixel: 1 if one of its rays met a triangle with a texture.
  const std::vector<std::uint8_t>& textured() const;
  /// The number of triangles with a texture that rays met.
  std::uint64_t triangles() const;

 private:
  class Shader;
  std::unique_ptr<Shader> shader_;
};

}  // namespace mmverify::render
