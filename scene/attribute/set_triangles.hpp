// The triangles of an attribute set of a scene, and bakers of their maps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "scene/attribute/baker.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::scene {

/// A triangle in one attribute set.
struct MapOfTriangle {
  std::size_t texture = 0;  ///< number in AttributeScene::textures
  UvTriangle uvs;
};

/// For each triangle, the number of the first triangle that has the same texture and the same bits of UVs, which
/// may be itself.  Both have the same maps of every kind and level.
std::vector<std::size_t> first_of_same_uvs(std::span<const MapOfTriangle> triangles);

/// All triangles of a set that are within_reach(), in the scene's order.
class SetTriangles {
 public:
  /// The scene must outlive the object.  stop: called before each triangle is baked, from any thread; may throw.
  SetTriangles(const AttributeScene& scene, AttributeSet set, Averaging averaging,
               std::function<void()> stop = {});

  AttributeSet set() const { return set_; }
  std::uint8_t channels() const { return channels_; }
  const CodeMeaning& meaning() const { return meaning_; }
  const AttributeScene& scene() const { return scene_; }

  const std::vector<MapOfTriangle>& all() const { return all_; }
  /// first_of_same_uvs() of all().
  std::size_t same(std::size_t triangle) const { return same_[triangle]; }
  /// Vertices of all(), primitive by primitive.
  const std::vector<std::vector<Triangle>>& primitives() const { return primitives_; }
  std::uint64_t left_out() const { return left_out_; }  ///< triangles not within_reach()
  /// Numbers of the images that the set's textures read, ascending.
  std::vector<std::size_t> images() const;

  const ColourImage& image_of(std::size_t triangle) const {
    return scene_.images[scene_.textures[all_[triangle].texture].image];
  }
  const Sampler& sampler_of(std::size_t triangle) const {
    return scene_.textures[all_[triangle].texture].sampler;
  }
  /// Bakes the map of a triangle of all().  Domain: as of MapBaker::bake().
  void bake(std::size_t triangle, MapKind kind, unsigned level, std::vector<MapValue>& map) const;

 private:
  const AttributeScene& scene_;
  AttributeSet set_;
  std::uint8_t channels_;
  CodeMeaning meaning_;
  std::function<void()> stop_;
  std::map<std::size_t, MapBaker> bakers_;  ///< by number of a texture of the scene
  std::vector<MapOfTriangle> all_;
  std::vector<std::size_t> same_;
  std::vector<std::vector<Triangle>> primitives_;
  std::uint64_t left_out_ = 0;
};

}  // namespace mmverify::scene
