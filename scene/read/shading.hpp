// The inputs of shading besides positions and textures: normals of vertices, factors of materials.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace mmverify::scene {

struct PrimitiveShading {
  std::size_t mesh = 0, number = 0;       ///< meshes[mesh].primitives[number]
  std::vector<Position> normals = {};     ///< by vertex, as in the file; empty if it has none
  std::array<float, 3> colour{1, 1, 1};   ///< baseColorFactor, linear
  float metallic = 1, roughness = 1;      ///< metallicFactor, roughnessFactor
  float normal_scale = 1, occlusion = 1;  ///< normalTexture.scale, occlusionTexture.strength
};

/// The shading of the primitives that are drawn as triangles, in the file's order.  A primitive without a
/// material has glTF's default.
/// Errors: BadScene as of load(), for normals that are not one a vertex, and for factors that are no numbers
/// or outside 0 to 1 (normal_scale: beyond 10^6 in size).
/// Source: glTF 2.0, 3.9.2 and 3.9.3.
std::vector<PrimitiveShading> load_shading(const std::string& file);
std::vector<PrimitiveShading> load_shading(const std::string& name, std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
