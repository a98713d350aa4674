// Color and Attribute Micromaps, figure 5, as a header that compiles: blocks of values at micro-triangles and at
// micro-vertices, read at a hit's barycentrics.  The figure imagines an extension (GL_EXT_attribute_micromap); this is the
// same over storage buffers, and says what the figure leaves open: how a triangle finds its map, ties, orders, levels of
// detail, decimated edges.
//
//   figure 5                                                          here
//   layout(binding=0, triangleMicromapEXT) buffer utri                MM_TRIANGLE_MICROMAP(0, 0, 1, vec4, color)
//   { vec4 color; } uTriAttributes;
//   layout(binding=1, vertexMicromapEXT) buffer uvtx                  MM_VERTEX_MICROMAP(0, 2, 3, vec3, normal)
//   { vec3 normal; } uVtxAttributes;
//   uTriAttributes.color                                              color(gl_PrimitiveID, barycentrics)
//   uVtxAttributes.normal                                             normal(gl_PrimitiveID, barycentrics)
//   -                                                                 color_lod(gl_PrimitiveID, barycentrics, lod)
//
// Both macros take a descriptor set, the bindings of the values and of the records, a type and a name.  A record says where
// a base triangle's map is; triangles may share one.
#ifndef MMVERIFY_SHADERS_ATTRIBUTE_API
#define MMVERIFY_SHADERS_ATTRIBUTE_API

#include "shaders/attribute.glsl"

/// A record's two words:
///   x  the map's first value, counted in values
///   y  bits 0..4 level n, up to 16
///      bits 5..6 order, MM_FACES_... or MM_VERTICES_...
///      bits 7..9 edges whose neighbour has level n-1 (of vertices): 1 w-u, 2 u-v, 4 v-w
///      bit 10    the levels 0..n-1 lie before level n, coarsest first (of faces; mips)
uint mm_record_level(uvec2 record) { return record.y & 31u; }
uint mm_record_order(uvec2 record) { return record.y >> 5 & 3u; }
uint mm_record_edges(uvec2 record) { return record.y >> 7 & 7u; }
bool mm_record_has_mips(uvec2 record) { return (record.y >> 10 & 1u) != 0u; }

/// The place of the value of the face at (u, v) at level m; without mips, at level n.
/// A point on an edge belongs to the face that Vulkan's rule for opacity micromaps gives, whatever the order.
uint mm_face_value(uvec2 record, vec2 uv, uint m) {
  uint n = mm_record_level(record), level = mm_record_has_mips(record) ? min(m, n) : n;
  uint before = mm_record_has_mips(record) ? ((1u << 2u * level) - 1u) / 3u : 0u;
  return record.x + before + mm_face_index(level, mm_record_order(record), mm_face_of_point(level, mm_point(level, uv.x, uv.y)));
}

/// The place of a vertex of level n - up among those of level n: it is at every 2^up th place, so that mips
/// of vertices take no memory.
uint mm_vertex_value(uvec2 record, uvec2 place, uint up) {
  return record.x + mm_vertex_index(mm_record_level(record), mm_record_order(record), place.x << up, place.y << up);
}

/// Whether a vertex lies between two of an edge whose neighbour has one level less: its value is then their mean, so that both
/// sides show the same.  Coarser levels of detail agree anyway.
bool mm_is_between(uvec2 record, uvec2 place, MM_OUT(uvec2) a, MM_OUT(uvec2) b) {
  uint N = mm_side(mm_record_level(record)), edges = mm_record_edges(record);
  bool odd_i = N > 1u && (place.x & 1u) != 0u, odd_j = N > 1u && (place.y & 1u) != 0u;
  a = b = place;
  if ((edges & 1u) != 0u && place.y == 0u && odd_i) {
    a.x -= 1u;
    b.x += 1u;
  } else if ((edges & 2u) != 0u && place.x + place.y == N && odd_j) {
    a += uvec2(1u, ~0u);  // ~0 is -1
    b += uvec2(~0u, 1u);
  } else if ((edges & 4u) != 0u && place.x == 0u && odd_j) {
    a.y -= 1u;
    b.y += 1u;
  } else {
    return false;
  }
  return true;
}

/// Level of detail of a hit: how the triangle's area compares with the cone's, by the triangle's corners.
MmLod mm_lod_of_triangle(uvec2 record, float cone_area, vec3 p0, vec3 p1, vec3 p2) {
  return mm_lod(mm_record_level(record), cone_area, 0.5f * length(cross(p1 - p0, p2 - p0)));
}

/// The storage of values and records: storage buffers, unless MM_MICROMAP_BLOCKS is defined before the
/// include.
#ifndef MM_MICROMAP_BLOCKS
#define MM_MICROMAP_BLOCKS(SET, VALUES, RECORDS, TYPE, NAME)                                                            \
  layout(std430, set = SET, binding = VALUES) readonly buffer NAME##_values_block { TYPE NAME##_values[]; };            \
  layout(std430, set = SET, binding = RECORDS) readonly buffer NAME##_records_block { uvec2 NAME##_records[]; };
#endif

/// Values at micro-triangles.  NAME(primitive, uv): the finest level's.  NAME_lod: between two levels, for types that mix.
#define MM_TRIANGLE_MICROMAP_PLAIN(SET, VALUES, RECORDS, TYPE, NAME)                                                    \
  MM_MICROMAP_BLOCKS(SET, VALUES, RECORDS, TYPE, NAME)                                                                  \
  TYPE NAME(uint primitive, vec2 uv) {                                                                                  \
    uvec2 record = NAME##_records[primitive];                                                                           \
    return NAME##_values[mm_face_value(record, uv, mm_record_level(record))];                                           \
  }
#define MM_TRIANGLE_MICROMAP(SET, VALUES, RECORDS, TYPE, NAME)                                                          \
  MM_TRIANGLE_MICROMAP_PLAIN(SET, VALUES, RECORDS, TYPE, NAME)                                                          \
  TYPE NAME##_lod(uint primitive, vec2 uv, MmLod lod) {                                                                 \
    uvec2 record = NAME##_records[primitive];                                                                           \
    TYPE coarse = NAME##_values[mm_face_value(record, uv, lod.level)];                                                  \
    if (lod.blend == 0.0f) return coarse;                                                                               \
    return (1.0f - lod.blend) * coarse + lod.blend * NAME##_values[mm_face_value(record, uv, lod.level + 1u)];          \
  }

/// Values at micro-vertices, interpolated: float, vec2, vec3 (which std430 lays out as four floats) or vec4.
#define MM_VERTEX_MICROMAP(SET, VALUES, RECORDS, TYPE, NAME)                                                            \
  MM_MICROMAP_BLOCKS(SET, VALUES, RECORDS, TYPE, NAME)                                                                  \
  TYPE NAME##_at_vertex(uvec2 record, uvec2 place, uint up) {                                                           \
    uvec2 a, b;                                                                                                         \
    if (up == 0u && mm_is_between(record, place, a, b))                                                                 \
      return 0.5f * (NAME##_values[mm_vertex_value(record, a, 0u)] + NAME##_values[mm_vertex_value(record, b, 0u)]);    \
    return NAME##_values[mm_vertex_value(record, place, up)];                                                           \
  }                                                                                                                     \
  TYPE NAME##_at_level(uint primitive, vec2 uv, uint level) {                                                           \
    uvec2 record = NAME##_records[primitive], base, along_u, along_v;                                                   \
    uint n = mm_record_level(record), m = min(level, n);                                                                \
    MmHit hit = mm_hit(m, uv.x, uv.y);                                                                                  \
    mm_corners(hit.face, base, along_u, along_v);                                                                       \
    MM_PRECISE TYPE mixed = hit.weights.x * NAME##_at_vertex(record, base, n - m) +                                     \
                            hit.weights.y * NAME##_at_vertex(record, along_u, n - m) +                                  \
                            hit.weights.z * NAME##_at_vertex(record, along_v, n - m);                                   \
    return mixed;                                                                                                       \
  }                                                                                                                     \
  TYPE NAME(uint primitive, vec2 uv) {                                                                                  \
    return NAME##_at_level(primitive, uv, mm_record_level(NAME##_records[primitive]));                                  \
  }                                                                                                                     \
  TYPE NAME##_lod(uint primitive, vec2 uv, MmLod lod) {                                                                 \
    TYPE coarse = NAME##_at_level(primitive, uv, lod.level);                                                            \
    if (lod.blend == 0.0f) return coarse;                                                                               \
    return (1.0f - lod.blend) * coarse + lod.blend * NAME##_at_level(primitive, uv, lod.level + 1u);                    \
  }

#endif
