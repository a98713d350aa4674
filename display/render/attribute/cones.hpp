// Levels of detail by ray cones, by the very text of subjects/shaders/attribute_api.glsl.
#pragma once

#include <cstdint>

#include "display/render/attribute/glsl.hpp"

namespace mmverify::render {

/// Two levels of a chain of maps: level m has the weight 1 - blend, level m + 1 the weight blend.
struct DetailLevel {
  std::uint32_t level = 0;
  float blend = 0;  ///< in [0, 1); 0 at the last level
};

/// The angle of a pixel's cone at the middle of a picture: atan(2 h / rows), h the tangent of half the vertical angle.
/// Source: Akenine-Moeller et al., Texture Level of Detail Strategies for Real-Time Ray Tracing (2019).
float spread_of_pixel(float half, std::uint32_t rows);

/// mm_cone_area(0, spread, distance, facing): the area of the cone's footprint on a surface.
/// Domain: `facing`, the cosine between ray and normal, is not 0.
float cone_area(float spread, float distance, float facing);

/// mm_lod_of_triangle(): the levels of a map of level `finest` on the triangle.  Domain: level up to 16.
/// Law: attribute.lod_level and attribute.lod_blend, of the same text as a subject.
/// Test: the levels are the library's at every hit of a frame
DetailLevel detail_level(std::uint32_t finest, float area, const glsl::vec3& a, const glsl::vec3& b,
                         const glsl::vec3& c);

}  // namespace mmverify::render
