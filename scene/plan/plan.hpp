// What of a scene is worth a micromap, and why the rest is not.  No file is read and no texel is looked at.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scene/plan/texel_triangle.hpp"
#include "scene/plan/uv_duplicates.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// Why a primitive gets no micromaps.
enum class LeftOut : std::uint8_t {
  no_triangles,
  not_placed,
  material_variants,
  animated,
  specular_glossiness,
  opaque,
  no_texture,
  no_image,
  no_uvs,
  morphed_uvs,
  vertex_alpha,
  two_filters,
  far_uvs,
};

/// How a texture is filtered where only one is asked of it: as it is magnified, else as it is minified;
/// linearly where the file leaves both open, as renderers do.
Filter filter_of(const Sampler& sampler);

/// The same for people.
std::string_view sentence(LeftOut why);

/// What decides alpha at a point, besides its UV:
///   alpha = texture alpha x base_color_alpha x vertex_alpha,  MASK: opaque where alpha >= cutoff
struct Surface {
  std::size_t image = 0;
  Sampler sampler;
  AlphaMode mode = AlphaMode::mask;
  float cutoff = 0.5f;  ///< of MASK; 0.5 and unused for BLEND
  float base_color_alpha = 1, vertex_alpha = 1;
  bool operator==(const Surface&) const = default;
};

/// One triangle to bake, which stands for all of its UV-duplicates on its surface.
struct PlannedTriangle {
  std::uint32_t surface = 0;  ///< of Plan::surfaces
  UvTriangle uvs;
  TexelTriangle texels;
  UvShape shape = UvShape::area;
  UsefulLevel level;
  std::uint64_t unique = 0, placed = 0;  ///< triangles that it stands for, itself included
};

/// One triangle of a primitive.
struct TriangleUse {
  std::uint32_t triangle = 0;  ///< of Plan::triangles
  VertexOrder order{0, 1, 2};  ///< its vertex k is vertex order[k] of that one
};

struct PlannedPrimitive {
  std::size_t primitive = 0;  ///< of Scene::primitives
  std::uint32_t surface = 0;
  std::vector<TriangleUse> triangles;  ///< one per triangle, in the primitive's order
};

struct LeftOutPrimitive {
  std::size_t primitive = 0;
  LeftOut why = LeftOut::opaque;
};

struct Plan {
  std::vector<Surface> surfaces;
  std::vector<PlannedTriangle> triangles;
  std::vector<PlannedPrimitive> primitives;
  std::vector<LeftOutPrimitive> left_out;
};

/// Of a plan's triangles.
struct PlanCounts {
  std::uint64_t unique = 0, placed = 0;  ///< that they stand for
  std::uint64_t reordered = 0;           ///< of those, with another order of vertices
  std::uint64_t lines = 0, points = 0;   ///< distinct ones whose UVs have no area
  std::uint64_t limited = 0;             ///< distinct ones whose highest useful level is above the limit
  unsigned limit = 0;                    ///< that limit, where there are any
};
PlanCounts counts(const Plan& plan);

/// Each primitive of the scene in either of the last two lists, in the scene's order.
/// `level_limit` is the device's (maxOpacity4StateSubdivisionLevel); finest_level holds besides.
/// Domain: a scene of load(), or one whose indices name something and whose UVs are finite.
/// Errors: std::invalid_argument where an image that is needed is not decoded.
Plan plan(const Scene& scene, unsigned level_limit = finest_level);

}  // namespace mmverify::scene
