// What a triangle's attributes are at a point, read of textures or of maps.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/attribute/shading.hpp"
#include "render/barycentrics.hpp"
#include "render/scene/views.hpp"
#include "scene/attribute/baker.hpp"

namespace mmverify::render {

/// A world's geometries with their textures, ready to be read or baked.
class TextureLooks {
 public:
  /// All outlive it.
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

/// One triangle of a geometry; its maps are baked when it is made.
class TriangleLooks {
 public:
  TriangleLooks(const TextureLooks& looks, std::uint32_t geometry, std::uint32_t triangle, ShownFrom from,
                unsigned level);

  /// With factors applied; the normal is that of the tangent space.
  Look at(const Barycentrics& point) const;

  /// In the mesh's own space, of any length: the triangle's normal, that between its vertices', and where the texture of
  /// normals goes right and up.  The last two are 0 where there is none, or its triangle has no area.
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
    std::vector<scene::MapValue> map;
  };
  scene::CodeMeaning::Mean mean_at(const Use& use, const Barycentrics& point) const;

  ShownFrom from_;
  unsigned level_;
  const scene::PrimitiveShading* shading_;
  std::vector<Use> uses_;
  Directions of_triangle_;
  std::optional<std::array<Vector, 3>> normals_;
};

}  // namespace mmverify::render
