// vierkant's generate_omm_data as a subject: it is judged as a baker of a triangle, and of whole meshes.  It stores
// coordinates as binary16, so the adapter declines others, except in scenes, and meshes of uniform triangles alone, which
// get no maps.
#include <meshoptimizer.h>

#include <map>
#include <memory>
#include <variant>

#include "examples/adapters/mesh.hpp"
#include "examples/adapters/meshoptimizer/support.hpp"

// The parts of the engine and of Vulkan that the function reads, in short.
// clang-format off
struct Pixels {
  uint32_t wide, high;
  std::vector<uint8_t> bytes;
  uint32_t num_components() const { return 2; }
  uint32_t width() const { return wide; }
  uint32_t height() const { return high; }
  const void* data() const { return bytes.data(); }
};
struct Lod { uint32_t num_indices, base_index; };
struct Entry { std::vector<Lod> lods; uint32_t material_index, num_vertices, vertex_offset; };
struct Texture { int texture_id; };
enum { VK_OPACITY_MICROMAP_FORMAT_2_STATE_EXT = 1, VK_OPACITY_MICROMAP_FORMAT_4_STATE_EXT = 2 };
struct VkMicromapTriangleEXT { uint32_t dataOffset; uint16_t subdivisionLevel, format; };
namespace spdlog { inline void warn(const char*, uint32_t) {} }
namespace crocore { using ImagePtr = std::shared_ptr<Pixels>; }
namespace vierkant {
using TextureId = int; enum class BlendMode { Mask }; enum class TextureType { Color };
struct Material { BlendMode blend_mode; std::map<TextureType, Texture> texture_data; };
struct mesh_buffer_bundle_t { uint32_t vertex_stride; std::vector<Entry> entries; std::vector<uint8_t> vertex_buffer;
                              std::vector<uint32_t> index_buffer; };
struct model_assets_t { std::vector<Material> materials; std::map<int, std::variant<crocore::ImagePtr>> textures; };
#include "function.inc"
}
// clang-format on

/// The texture as two bytes a texel, of which the second is alpha.
static const crocore::ImagePtr& image_of(const mmverify_bake_case_t& c) {
  static thread_local crocore::ImagePtr image;
  if (same_texture_as_before(c)) return image;
  image = std::make_shared<Pixels>(Pixels{c.width, c.height, {}});
  image->bytes.resize(2 * size_t{c.width} * c.height);
  for (size_t i = 0; i < size_t{c.width} * c.height; ++i)
    image->bytes[2 * i + 1] = static_cast<const uint8_t*>(c.texels)[i];
  return image;
}

/// The maps of a mesh; none if it is declined.
static std::vector<vierkant::mesh_omm_data_t> maps_of(const mmverify_bake_case_t& c, const float* uvs,
                                                      uint32_t count, std::vector<uint32_t> indices) {
  std::vector<vierkant::packed_vertex_t> vertices(count);
  for (uint32_t i = 0; i < 2 * count; ++i) {
    uint16_t& half = i % 2 == 0 ? vertices[i / 2].texcoord_x : vertices[i / 2].texcoord_y;
    if (meshopt_dequantizeHalf(half = meshopt_quantizeHalf(uvs[i])) != uvs[i] && !bakes_scenes) return {};
  }
  const auto* bytes = reinterpret_cast<const uint8_t*>(vertices.data());
  const uint32_t stride = sizeof vertices[0], corners = uint32_t(indices.size());
  return vierkant::generate_omm_data(
      {{{vierkant::BlendMode::Mask, {{vierkant::TextureType::Color, {1}}}}}, {{1, image_of(c)}}},
      {stride, {{{{corners, 0}}, 0, count, 0}}, {bytes, bytes + size_t{stride} * count}, std::move(indices)},
      {int(c.level), 0, c.format == MMVERIFY_2_STATE ? 2 : 4});
}

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const auto made = maps_of(*c, c->uv, 3, {0, 1, 2});
  if (!made.empty()) std::memcpy(map, made[0].entry.data.data(), bytes_of(*c));
  return !made.empty();
}

/// It has one level for all triangles, or levels of its own choice.
static size_t bake_mesh(const mmverify_mesh_case_t* c, uint8_t* answer, size_t capacity) {
  if (c->levels != nullptr) return 0;
  const auto entries =
      maps_of(*c->surface, c->uvs, c->vertices, {c->indices, c->indices + size_t{3} * c->triangles});
  if (entries.empty()) return 0;
  MadeMesh made;
  for (const VkMicromapTriangleEXT& one : entries[0].entry.triangles)
    made.offsets.push_back(one.dataOffset), made.levels.push_back(one.subdivisionLevel);
  made.indices = entries[0].entry.indices;
  made.data = entries[0].entry.data;
  count_usage(*c, made);
  return mesh_answer(*c, made, answer, capacity);
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return mesh_subject("vierkant", bake, bake_mesh, rasterizer_supports);
}
