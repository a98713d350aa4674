#version 460
// A closest-hit shader that reads a colour at micro-triangles and a normal at micro-vertices: figure 5 of Color and
// Attribute Micromaps, written down.
//   glslangValidator -Isubjects -V --target-env vulkan1.2 -o figure_5.spv subjects/shaders/examples/figure_5.rchit
#extension GL_EXT_ray_tracing : require
#extension GL_GOOGLE_include_directive : require
#include "shaders/attribute_api.glsl"

MM_TRIANGLE_MICROMAP(0, 0, 1, vec4, color)
MM_VERTEX_MICROMAP(0, 2, 3, vec3, normal)
// Positions, which GL_EXT_ray_tracing_position_fetch would bring: three a triangle.
layout(std430, set = 0, binding = 4) readonly buffer positions_block { vec4 positions[]; };

hitAttributeEXT vec2 barycentrics;
struct Payload {
  vec4 color;
  vec3 normal;
  float cone_width, cone_spread;
};
layout(location = 0) rayPayloadInEXT Payload payload;

void main() {
  uint triangle = uint(gl_PrimitiveID);
  vec3 p0 = positions[3u * triangle].xyz, p1 = positions[3u * triangle + 1u].xyz, p2 = positions[3u * triangle + 2u].xyz;
  float facing = dot(normalize(cross(p1 - p0, p2 - p0)), normalize(gl_ObjectRayDirectionEXT));
  float cone = mm_cone_area(payload.cone_width, payload.cone_spread, gl_HitTEXT, facing);
  payload.color = color_lod(triangle, barycentrics, mm_lod_of_triangle(color_records[triangle], cone, p0, p1, p2));
  payload.normal = normalize(normal(triangle, barycentrics));
}
