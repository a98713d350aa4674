#include "display/render/attribute/colour_maps.hpp"

#include <cmath>
#include <stdexcept>

#include "display/render/attribute/cones.hpp"

// The shaders' own text.  A block of values is a pointer here, and a structure is made of its members in braces.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wparentheses"
#define MM_PRECISE
#define MM_OUT(TYPE) TYPE&
#define MM_MICROMAP_BLOCKS(SET, VALUES, RECORDS, TYPE, NAME) \
  const TYPE* NAME##_values;                                 \
  const uvec2* NAME##_records;
#define MmFace(...) \
  MmFace { __VA_ARGS__ }
#define MmLod(...) \
  MmLod { __VA_ARGS__ }
#define MmHit(...) \
  MmHit { __VA_ARGS__ }
namespace mmverify::render::glsl {
#include "subjects/shaders/attribute_api.glsl"

/// layout(binding = 0, triangleMicromapEXT) and layout(binding = 1, vertexMicromapEXT) of the paper's figure 5.
struct FaceColours {
  MM_TRIANGLE_MICROMAP_PLAIN(0, 0, 1, uint, colour)
};
struct VertexColours {
  MM_VERTEX_MICROMAP(0, 0, 1, vec4, colour)
};

}  // namespace mmverify::render::glsl
#undef MmHit
#undef MmLod
#undef MmFace
#pragma GCC diagnostic pop

namespace mmverify::render {

ColourMaps::ColourMaps(ColoursOf of, unsigned level, std::size_t geometries)
    : of_(of), level_(level), maps_(geometries) {
  if (level > 10) throw std::invalid_argument("ColourMaps: levels go up to 10");
}

std::uint32_t ColourMaps::add(std::span<const std::uint32_t> values) {
  const std::uint32_t faces = 1u << 2 * level_;
  const bool of_faces = of_ == ColoursOf::faces;
  if (values.size() != (of_faces ? faces : glsl::mm_vertex_count(level_)))
    throw std::invalid_argument("ColourMaps: not as many values as a map of the level has");
  const std::size_t first = of_faces ? faces_.size() : vertices_.size();
  if (first + values.size() > 0xffffffff) throw std::length_error("ColourMaps: more than 2^32 values");
  const glsl::uint order = of_faces ? glsl::MM_FACES_CURVE : glsl::MM_VERTICES_W_MINOR;
  made_.emplace_back(static_cast<std::uint32_t>(first), level_ | order << 5);
  const auto channel = [](std::uint32_t word, unsigned shift) {
    return static_cast<float>(word >> shift & 255) / 255.0f;
  };
  for (const std::uint32_t word : values)
    if (of_faces)
      faces_.push_back(word);
    else
      vertices_.emplace_back(channel(word, 0), channel(word, 8), channel(word, 16), channel(word, 24));
  return static_cast<std::uint32_t>(made_.size() - 1);
}

void ColourMaps::give(std::uint32_t geometry, std::vector<std::uint32_t> maps) {
  std::vector<glsl::uvec2>& records = maps_.at(geometry);
  records.clear();
  for (const std::uint32_t number : maps) records.push_back(made_.at(number));
}

glsl::vec4 ColourMaps::interpolated(std::uint32_t geometry, std::uint32_t triangle,
                                    const Barycentrics& b) const {
  return glsl::VertexColours{vertices_.data(), maps_[geometry].data()}.colour(triangle, {b.u, b.v});
}

std::uint32_t ColourMaps::at(std::uint32_t geometry, std::uint32_t triangle, const Barycentrics& b) const {
  if (of_ == ColoursOf::faces)
    return glsl::FaceColours{faces_.data(), maps_[geometry].data()}.colour(triangle, {b.u, b.v});
  const glsl::vec4 c = interpolated(geometry, triangle, b);
  const auto code = [](float x) { return static_cast<std::uint32_t>(glsl::clamp(x, 0, 1) * 255.0f + 0.5f); };
  return code(c.x) | code(c.y) << 8 | code(c.z) << 16 | code(c.w) << 24;
}

std::uint64_t ColourMaps::bytes() const {
  std::uint64_t records = 0;
  for (const auto& of_geometry : maps_) records += of_geometry.size();
  return 4 * faces_.size() + 16 * vertices_.size() + 8 * records;
}

float spread_of_pixel(float half, std::uint32_t rows) {
  return std::atan(2 * half / static_cast<float>(rows));
}

float cone_area(float spread, float distance, float facing) {
  return glsl::mm_cone_area(0, spread, distance, facing);
}

DetailLevel detail_level(std::uint32_t finest, float area, const glsl::vec3& a, const glsl::vec3& b,
                         const glsl::vec3& c) {
  const glsl::MmLod lod = glsl::mm_lod_of_triangle({0, finest}, area, a, b, c);
  return {lod.level, lod.blend};
}

}  // namespace mmverify::render
