// What rays meet: triangles in meshes, meshes placed, surfaces that decide their alpha.  Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/surface.hpp"

namespace mmverify::render {

using Point = std::array<float, 3>;

/// Triangles of one surface.
struct Geometry {
  std::vector<Point> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<impl::bake::TexturePoint> uvs;  ///< by vertex; of a surface alone
  std::optional<std::uint32_t> surface;       ///< of World::surfaces; none: opaque, and no filter is called
  bool planned = true;                        ///< whether its triangles are among those that get micromaps
  std::uint32_t colour = 0;                   ///< a number that its colour in a picture is made of

  impl::bake::BaseTriangle uv_of(std::size_t triangle) const {
    const auto& t = triangles[triangle];
    return {uvs[t[0]], uvs[t[1]], uvs[t[2]]};
  }
};

/// x' = linear x + translation, column by column.
struct Instance {
  std::uint32_t mesh = 0;  ///< of World::meshes
  std::array<float, 12> transform{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
};

struct World {
  std::vector<Surface> surfaces;
  std::vector<Geometry> geometries;
  std::vector<std::vector<std::uint32_t>> meshes;  ///< geometries
  std::vector<Instance> instances;
};

/// The smallest box, axes along the scene's, around what is placed.
struct Box {
  Point low{}, high{};
  bool empty = true;
  void add(const Point& p);
};
/// Of geometries with a surface alone, or of all.
Box box_of(const World& world, bool with_surface_only);

Point placed(const Instance& instance, const Point& p);

/// Whether rays can be taken into the instance's own space in binary32: its determinant is not near 0, neither by itself
/// nor beside the lengths of its columns, and no point up to `reach` from the origin goes too far.
bool has_inverse(const Instance& instance, float reach);

}  // namespace mmverify::render
