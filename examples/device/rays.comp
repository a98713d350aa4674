// One point of one triangle a thread: what a ray query meets there, as it is and with unknown states forced to two.
#version 460
#extension GL_EXT_ray_query : require
#extension GL_EXT_opacity_micromap : require
#extension GL_EXT_spirv_intrinsics : require

layout(local_size_x = 64) in;

// OpCopyObject, whose use declares the capability RayTracingOpacityMicromapEXT: glslang declared it for pipelines alone
// until 2026.
spirv_instruction(extensions = ["SPV_EXT_opacity_micromap"], capabilities = [5381], id = 83) uint declared(uint flags);

layout(set = 0, binding = 0) uniform accelerationStructureEXT scene;

// u and v of the point, and the triangle's number.
layout(std430, set = 0, binding = 1) readonly buffer Rays { uvec4 rays[]; };

// The two outcomes, and the bits of u and v where the first one is a hit.
layout(std430, set = 0, binding = 2) writeonly buffer Hits { uvec4 hits[]; };

layout(push_constant) uniform Constants { uint count; };

// `asked`: the triangle is a candidate that the shader has to decide.  `both`: it is a candidate and a hit, which no state is.
const uint missed = 0, opaque = 1, asked = 2, both = 3;

uint outcome(vec2 at, float z, uint flags, out vec2 barycentrics) {
  rayQueryEXT query;
  rayQueryInitializeEXT(query, scene, flags, 0xff, vec3(at, z - 0.5), 0.0, vec3(0, 0, 1), 1.0);
  bool candidate = false;
  while (rayQueryProceedEXT(query)) candidate = true;  // it is never confirmed
  barycentrics = vec2(0);
  if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT) {
    barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, true);
    return candidate ? both : opaque;
  }
  return candidate ? asked : missed;
}

void main() {
  const uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  const vec2 at = uintBitsToFloat(rays[k].xy);
  const float z = float(rays[k].z);
  vec2 where, unused;
  const uint plain = outcome(at, z, gl_RayFlagsNoneEXT, where);
  const uint forced = outcome(at, z, declared(gl_RayFlagsForceOpacityMicromap2StateEXT), unused);
  hits[k] = uvec4(plain, forced, floatBitsToUint(where));
}
