// Colours of a world's triangles as attribute micromaps, read by the very text of subjects/shaders/attribute_api.glsl.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display/render/attribute/glsl.hpp"
#include "display/render/barycentrics.hpp"

namespace mmverify::render {

/// The elements of a triangle for which a map has values: micro-triangles or micro-vertices.
enum class ColoursOf : std::uint8_t { faces, vertices };

/// The colour maps of a world, all of one kind and one level.  A colour is r | g << 8 | b << 16 | a << 24.
class ColourMaps {
 public:
  /// Maps of faces follow the curve; maps of vertices are in the order W-minor.
  /// Errors: std::invalid_argument for a level above 10.
  ColourMaps(ColoursOf of, unsigned level, std::size_t geometries);

  /// Adds a map with the values of 4^n faces or V(n) vertices, n = level, and returns its number.
  /// Errors: std::invalid_argument for another number of values.
  std::uint32_t add(std::span<const std::uint32_t> values);
  /// Assigns a map, by number, to each triangle of a geometry.  Domain: numbers that add() returned.
  void give(std::uint32_t geometry, std::vector<std::uint32_t> maps);

  /// Whether a geometry's triangles have maps.
  bool has(std::uint32_t geometry) const { return !maps_[geometry].empty(); }

  /// The colour at a hit.  Maps of faces give the value of the hit's micro-triangle, by Vulkan's rule for
  /// ties.  Maps of vertices interpolate and round each channel half up.
  /// Domain: a geometry with maps, a triangle of it, a point of the triangle.
  std::uint32_t at(std::uint32_t geometry, std::uint32_t triangle, const Barycentrics& b) const;

  /// The interpolated colour before at() rounds it, channels 0 to 1.  Domain: that of at(), maps of vertices.
  glsl::vec4 interpolated(std::uint32_t geometry, std::uint32_t triangle, const Barycentrics& b) const;

  ColoursOf of() const { return of_; }
  unsigned level() const { return level_; }
  /// The size of the values and records on a device: 4 bytes a face, 16 a vertex, 8 a record.
  std::uint64_t bytes() const;

  // The contents of the buffers of attribute_api.glsl: values of faces or of vertices, and a record a
  // triangle.
  const std::vector<std::uint32_t>& face_values() const { return faces_; }
  const std::vector<glsl::vec4>& vertex_values() const { return vertices_; }
  const std::vector<glsl::uvec2>& records(std::uint32_t geometry) const { return maps_[geometry]; }

 private:
  ColoursOf of_;
  unsigned level_;
  std::vector<std::uint32_t> faces_;
  std::vector<glsl::vec4> vertices_;
  std::vector<glsl::uvec2> made_;               ///< by number
  std::vector<std::vector<glsl::uvec2>> maps_;  ///< by geometry, then triangle
};

}  // namespace mmverify::render
