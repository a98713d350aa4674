// The attributes of a triangle at a point, read from textures or from maps.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "display/render/attribute/cones.hpp"
#include "display/render/attribute/shading.hpp"
#include "display/render/barycentrics.hpp"
#include "display/render/scene/views.hpp"
#include "scene/attribute/baker.hpp"

namespace mmverify::render {

/// A world's geometries with their textures, ready to be read or baked.
class TextureLooks {
 public:
  /// Domain: the arguments outlive the object.
  TextureLooks(const scene::Scene& scene, const SceneWorld& world, const scene::AttributeScene& attributes,
               const std::vector<scene::PrimitiveShading>& shading);

  bool has_texture(std::uint32_t geometry) const { return of_[geometry].attributes != nullptr; }

 private:
  friend class TriangleLooks;
  struct OfGeometry {
    const scene::AttributePrimitive* attributes = nullptr;
    const scene::PrimitiveShading* shading = nullptr;
  };
  const World& world_;
  const scene::AttributeScene& attributes_;
  std::vector<OfGeometry> of_;
  std::vector<std::unique_ptr<scene::MapBaker>> bakers_;  ///< by texture
};

/// One triangle of a geometry.  The constructor bakes its maps.
class TriangleLooks {
 public:
  /// `with_mips`: the lower levels of its maps, too (scene::mip_of_map).
  TriangleLooks(const TextureLooks& looks, std::uint32_t geometry, std::uint32_t triangle, ShownFrom from,
                unsigned level, bool with_mips = false);

  /// The attributes at a point, times the material's factors; the normal is in tangent space.
  Look at(const Barycentrics& point) const { return at(point, {level_, 0}); }
  /// The same between two levels, in the quantities that are averaged.
  /// Domain: a level with maps.  Source: Color and Attribute Micromaps, 4.4.2, step 3.
  Look at(const Barycentrics& point, const DetailLevel& detail) const;

  /// Directions in the mesh's own space, of any length: the triangle's normal, the normal interpolated
  /// between its vertices, and the directions in which the normal texture goes right and up.  The last two
  /// are 0 if there is no such texture, or if the triangle has no area in it.
  struct Directions {
    Vector flat{}, normal{}, along{}, up{};
  };
  Directions directions(const Barycentrics& point) const;

 private:
  struct Use {
    const scene::AttributeTexture* texture;
    const scene::ColourImage* image;
    const scene::MapBaker* baker;
    scene::UvTriangle uvs;
    std::vector<std::vector<scene::MapValue>> maps;  ///< by level from first_level_ on; none of textures
  };
  scene::CodeMeaning::Mean mean_at(const Use& use, const Barycentrics& point, unsigned level) const;

  ShownFrom from_;
  unsigned level_, first_level_;
  const scene::PrimitiveShading* shading_;
  std::vector<Use> uses_;
  Directions of_triangle_;
  std::optional<std::array<Vector, 3>> normals_;
};

}  // namespace mmverify::render
