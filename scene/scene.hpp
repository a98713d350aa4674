// A scene as its micromaps need it: triangles, UVs, the inputs of alpha.  Plain data, without types of any
// reader.
//
// Coordinates are glTF's: u along a row of texels, v down from the first row.  Indices into the vectors of a
// Scene are those of the file, so that a message about `meshes[3]` leads to the file's mesh 3.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mmverify::scene {

using Position = std::array<float, 3>;
using Uv = std::array<float, 2>;
using Triangle = std::array<std::uint32_t, 3>;  ///< indices of a primitive's vertices, in glTF's order

enum class AlphaMode : std::uint8_t { opaque, mask, blend };
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };
/// glTF's name: "REPEAT".
const char* name_of(Wrap wrap) noexcept;
enum class Filter : std::uint8_t { nearest, linear };

/// The sampling of a texture.  A filter that the file leaves open stays open: a renderer may take either.
struct Sampler {
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  std::optional<Filter> magnification;
  std::optional<Filter> minification;  ///< within a mip level
  std::optional<Filter> between_mips;  ///< between two mip levels; none also if only level 0 is sampled
  bool operator==(const Sampler&) const = default;
};

/// The alpha of a picture, rows from the top: texel (x, y) is alpha[x + width y], of 255, of 65535, or as it is: finite.
/// It is not decoded (width 0) if no alpha-tested primitive needs it.  A picture without alpha has the
/// greatest alpha.
struct Image {
  std::string name;  ///< its URI or name; for messages
  std::uint32_t width = 0, height = 0;
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> alpha;

  bool decoded() const { return width != 0; }
  int bits() const { return 8 << alpha.index(); }
};

/// KHR_texture_transform, in float32 as in a renderer.
struct TextureTransform {
  Uv offset{0, 0}, scale{1, 1};
  float rotation = 0;  ///< radians, counter-clockwise in a picture whose v goes down
  bool operator==(const TextureTransform&) const = default;
};

/// The UV at which a texture is sampled:
///   u' = offset_u + cos(r) scale_u u + sin(r) scale_v v
///   v' = offset_v - sin(r) scale_u u + cos(r) scale_v v
/// in double precision, rounded to float32 once; exactly `uv` if the transform is the identity.
/// The sign of r is that of the extension's prose and of its worked example, "the lower left quadrant"; the
/// GLSL of its draft has the other.
/// Source: KHR_texture_transform, Overview and Example JSON.
Uv transformed(const TextureTransform& transform, const Uv& uv);

/// The texture transforms of an animation: offset, scale and rotation each take any value of their own range, ends
/// included.
struct TransformRange {
  TextureTransform least, greatest;
  bool operator==(const TransformRange&) const = default;
};

/// The smallest rectangle, least and greatest, that holds transformed() of a UV by every transform of the range: exactly
/// that without a rotation that moves, else with a hair more.
std::array<Uv, 2> transformed(const TransformRange& range, const Uv& uv);

struct BaseColorTexture {
  std::optional<std::size_t> image;  ///< none if the file names no image for it that is read here
  std::uint32_t uv_set = 0;          ///< TEXCOORD_n
  Sampler sampler;
  TextureTransform transform;
  std::string note = {};  ///< which of several images it is, in words
};

/// The part of a material that decides alpha = texture alpha x base_color_alpha x vertex alpha.  Numbers are
/// the file's, rounded to the nearest float32, as in renderers.
struct Material {
  std::string name;
  AlphaMode mode = AlphaMode::opaque;
  float cutoff = 0.5f;  ///< for mask: alpha >= cutoff is opaque
  float base_color_alpha = 1;
  std::optional<BaseColorTexture> texture;
  std::vector<std::string> animated;  ///< KHR_animation_pointer's targets that change this alpha or these UVs
  /// The transforms of its texture over all of the file's animations and without one, if these change nothing else.
  std::optional<TransformRange> moving = {};
  std::string unmoved = {};  ///< why not, of a material that an animation changes
  /// KHR_materials_pbrSpecularGlossiness replaces the texture by another.
  bool specular_glossiness = false;
};

/// KHR_materials_variants: the material in these variants.
struct VariantMaterial {
  std::size_t material = 0;
  std::vector<std::string> variants;
};

/// The alpha of COLOR_0 over the vertices that the triangles use.
struct VertexAlpha {
  float least = 1, greatest = 1;
  std::vector<float> of_vertices = {};  ///< by vertex; empty if all that are used have the same
};

/// The UVs of vertices that move: each coordinate of each vertex stays within `travel` of its middle.
struct MovingUvs {
  std::vector<Uv> middles;
  Uv travel{};
};

struct Primitive {
  std::size_t mesh = 0, number = 0;  ///< meshes[mesh].primitives[number]
  std::optional<std::size_t> material;
  bool drawn_as_triangles = true;  ///< else points or lines, without triangles
  std::vector<Triangle> triangles;
  std::vector<Position> positions;
  std::vector<Uv> uvs;  ///< of the set that the base colour names, transformed; empty if it is missing
  std::optional<MovingUvs> moving_uvs = {};  ///< of a material that moves its texture
  std::optional<VertexAlpha> vertex_alpha;   ///< none without an alpha in COLOR_0
  std::vector<VariantMaterial> variants;
  bool morphs_uvs = false;  ///< a morph target moves the UVs or COLOR_0
};

/// The linear part of a node's transform to its scene's coordinates, column by column.
using Placement = std::array<double, 9>;

/// The effect of a mesh's uses on areas.
struct Placements {
  double similar = 0;  ///< the sum of the squared scales of uses that keep all angles
  struct Times {
    Placement linear;
    double times;
  };
  std::vector<Times> others;  ///< the other uses
};

/// An affine map: x' = linear x + translation.
struct Transform {
  Placement linear;
  std::array<double, 3> translation;
};

/// A use of a mesh: a node that places it, or an instance of the node.
struct MeshUse {
  std::size_t mesh = 0;
  Transform to_scene;
  std::optional<std::size_t> node =
      {};  ///< none in a file that places nothing, whose meshes are at the identity
};

struct Mesh {
  std::string name;
  std::uint64_t uses = 0;  ///< nodes that place it, each times its instances of EXT_mesh_gpu_instancing
  Placements placements = {};
};

struct Scene {
  std::string file;
  std::vector<Image> images;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Primitive> primitives;  ///< of all meshes, in the file's order
  std::vector<std::string> notes =
      {};  ///< sentences for the user: images taken for others, files passed over

  /// The material of a primitive; glTF's default if it names none.
  const Material& material_of(const Primitive& primitive) const;
};

/// The number of triangles of all primitives, each once, and each as often as its mesh is used.
struct TriangleCounts {
  std::uint64_t unique = 0, placed = 0;
};
TriangleCounts count_triangles(const Scene& scene);

}  // namespace mmverify::scene
