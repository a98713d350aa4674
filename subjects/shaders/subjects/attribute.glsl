// Attribute maps: orders, triplets, weights, decimated edges, mips.
#include "shaders/attribute.glsl"

uint vertex_index(uint level, uint order, uint i, uint j) { return mm_vertex_index(level, order, i, j); }
uvec2 vertex_place(uint level, uint order, uint index) { return mm_vertex_place(level, order, index); }

uint face_index(uint level, uint order, uint iu, uint iv, uint upper) {
  return mm_face_index(level, order, MmFace(iu, iv, upper));
}
uvec3 face_place(uint level, uint order, uint index) {
  MmFace f = mm_face_at(level, order, index);
  return uvec3(f.iu, f.iv, f.upper);
}

uvec3 triplet(uint level, uint vertex_order, uint face_order, uint face) {
  return mm_triplet(level, vertex_order, mm_face_at(level, face_order, face));
}
uint face_of(uint level, uint vertex_order, uint face_order, uint a, uint b, uint c) {
  return mm_face_index(level, face_order, mm_face_of(level, vertex_order, uvec3(a, b, c)));
}

uvec3 triplet_at(uint level, uint order, float u, float v) { return mm_triplet(level, order, mm_hit(level, u, v).face); }
vec3 weights(uint level, float u, float v) { return mm_hit(level, u, v).weights; }

uvec2 decimate(uint level, uint flags, uint i, uint j) { return mm_decimate(level, flags, i, j); }
uint face_mip(uint rounding, uint a, uint b, uint c, uint d) { return mm_face_mip(rounding, a, b, c, d); }
