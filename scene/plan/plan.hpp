// A plan of the triangles of a scene that get micromaps, and the reasons why others get none.  No file and no
// texel is read.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "impl/bake/level.hpp"
#include "scene/plan/texel_triangle.hpp"
#include "scene/plan/uv_duplicates.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// The reason why a primitive gets no micromaps.
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
  varying_alpha,
};

/// The one filter of a texture: that of magnification, else of minification; linear if the file names
/// neither, as renderers do.
Filter filter_of(const Sampler& sampler);

/// The reason as a sentence.
std::string_view sentence(LeftOut why);

/// The inputs that decide alpha at a point, besides its UV:
///   alpha = texture alpha x base_color_alpha x vertex_alpha,  MASK: opaque if alpha >= cutoff
struct Surface {
  std::size_t image = 0;
  Sampler sampler;
  AlphaMode mode = AlphaMode::mask;
  float cutoff = 0.5f;  ///< for MASK; 0.5 and unused for BLEND
  float base_color_alpha = 1;
  float vertex_alpha = 1;  ///< that of all vertices; 1 if it varies
  Uv travel{};             ///< each UV moves by up to this about its triangle's
  bool operator==(const Surface&) const = default;

  bool moves() const { return travel != Uv{}; }
};

/// One triangle to bake, which stands for all of its UV-duplicates on its surface.
struct PlannedTriangle {
  std::uint32_t surface = 0;  ///< number in Plan::surfaces
  UvTriangle uvs;
  CornerAlphas vertex_alpha = one_alpha;  ///< factors besides the surface's, linear between the corners
  TexelTriangle texels;
  UvShape shape = UvShape::area;
  impl::bake::UsefulLevel level;
  std::uint64_t unique = 0, placed = 0;  ///< triangles that it stands for, itself included

  /// Whether alpha is a product of two functions of the place, of which bounds alone are known.
  bool varies() const { return vertex_alpha != one_alpha; }
};

/// One triangle of a primitive.
struct TriangleUse {
  std::uint32_t triangle = 0;  ///< number in Plan::triangles
  VertexOrder order{0, 1, 2};  ///< its vertex k is vertex order[k] of the planned triangle
};

struct PlannedPrimitive {
  std::size_t primitive = 0;  ///< number in Scene::primitives
  std::uint32_t surface = 0;
  std::vector<TriangleUse> triangles;  ///< one a triangle, in the primitive's order
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

/// The alphas of a triangle's vertices, if the primitive's vary; else 1, and the surface has them.
CornerAlphas corner_alphas(const Primitive& primitive, const Triangle& triangle);

/// The counts of a plan's triangles.
struct PlanCounts {
  std::uint64_t unique = 0, placed = 0;  ///< triangles that the planned ones stand for
  std::uint64_t reordered = 0;           ///< triangles among these with another order of vertices
  std::uint64_t lines = 0, points = 0;   ///< distinct triangles whose UVs have no area
  std::uint64_t varying = 0;             ///< triangles whose vertex alpha varies
  std::uint64_t limited = 0;             ///< distinct triangles whose highest useful level is above the limit
  unsigned limit = 0;                    ///< that limit, if there are any
};
PlanCounts counts(const Plan& plan);
/// The triangles of the primitives that are left out for a reason.  Domain: a plan of this scene.
std::uint64_t triangles_left_out(const Scene& scene, const Plan& plan, LeftOut why);

/// The treatment of primitives whose vertex alpha varies: bounds of the product tell their states.
enum class VaryingAlpha : std::uint8_t { left_out, planned };

/// The treatment of primitives whose UVs an animation moves: maps that hold wherever they are.
enum class MovingTextures : std::uint8_t { left_out, planned };

/// The UVs of a primitive's planned triangles, by vertex: those of the file, or the middles of those that move.
const std::vector<Uv>& planned_uvs(const Primitive& primitive, const Surface& surface);

/// A plan has each primitive of the scene in one of its last two lists, in the scene's order.
/// `level_limit` is the device's (maxOpacity4StateSubdivisionLevel); finest_level holds besides.
/// Domain: a scene of load(), or one with valid indices and finite UVs.
/// Errors: std::invalid_argument if an image that is needed is not decoded.
Plan plan(const Scene& scene, unsigned level_limit = finest_level,
          VaryingAlpha varying = VaryingAlpha::left_out, MovingTextures moving = MovingTextures::left_out);

}  // namespace mmverify::scene
