// vierkant's generate_omm_data as a subject: micromaps of a mesh of one triangle.  It stores coordinates as
// binary16, so the adapter declines others, except in scenes, and triangles of one state, which get no map.
#include <meshoptimizer.h>

#include <map>
#include <memory>
#include <variant>

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

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const int level = static_cast<int>(c->level), states = c->format == MMVERIFY_2_STATE ? 2 : 4;
  const auto image = std::make_shared<Pixels>(Pixels{c->width, c->height, {}});
  for (size_t i = 0; i < size_t{c->width} * c->height; ++i)
    image->bytes.insert(image->bytes.end(), {0, static_cast<const uint8_t*>(c->texels)[i]});
  vierkant::packed_vertex_t vertices[3] = {};
  for (int i = 0; i < 6; ++i) {
    uint16_t& half = i % 2 == 0 ? vertices[i / 2].texcoord_x : vertices[i / 2].texcoord_y;
    if (meshopt_dequantizeHalf(half = meshopt_quantizeHalf(c->uv[i])) != c->uv[i] && !bakes_scenes) return 0;
  }
  const auto* bytes = reinterpret_cast<const uint8_t*>(vertices);
  const auto made = vierkant::generate_omm_data(
      {{{vierkant::BlendMode::Mask, {{vierkant::TextureType::Color, {1}}}}}, {{1, image}}},
      {sizeof *vertices, {{{{3, 0}}, 0, 3, 0}}, {bytes, bytes + sizeof vertices}, {0, 1, 2}},
      {level, 0, states});
  if (!made.empty()) std::memcpy(map, made[0].entry.data.data(), bytes_of(*c));
  return !made.empty();
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return baker_subject("vierkant", bake, rasterizer_supports);
}
