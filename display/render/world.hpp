// The world that rays meet: triangles in meshes, placed meshes, and surfaces that decide their alpha.  Plain
// data.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "display/render/surface.hpp"

namespace mmverify::render {

using Point = std::array<float, 3>;

/// Triangles of one surface.
struct Geometry {
  std::vector<Point> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<impl::bake::TexturePoint> uvs;  ///< by vertex; none without a surface
  std::optional<std::uint32_t> surface;  ///< number in World::surfaces; none: opaque, and no filter is called
  bool planned = true;                   ///< whether its triangles are among those that get micromaps
  std::uint32_t colour = 0;              ///< a number from which a picture makes its colour

  impl::bake::BaseTriangle uv_of(std::size_t triangle) const {
    const auto& t = triangles[triangle];
    return {uvs[t[0]], uvs[t[1]], uvs[t[2]]};
  }
};

/// A placed mesh: x' = linear x + translation, column by column.
struct Instance {
  std::uint32_t mesh = 0;  ///< number in World::meshes
  std::array<float, 12> transform{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
};

struct World {
  std::vector<Surface> surfaces;
  std::vector<Geometry> geometries;
  std::vector<std::vector<std::uint32_t>> meshes;  ///< numbers of geometries
  std::vector<Instance> instances;
};

/// The smallest box, axes along the scene's, around added points.
struct Box {
  Point low{}, high{};
  bool empty = true;
  void add(const Point& p);
};
/// The box of all placed triangles, or of those with a surface alone.
Box box_of(const World& world, bool with_surface_only);

Point placed(const Instance& instance, const Point& p);

/// Whether rays can be taken into the instance's own space in binary32: its determinant is not near 0,
/// neither by itself nor relative to the lengths of its columns, and no point up to `reach` from the origin
/// goes too far.
bool has_inverse(const Instance& instance, float reach);

}  // namespace mmverify::render
