/* The interface between mmverify and an implementation under test.
 *
 * Build a shared library that exports one function, mmverify_subject_v1, and hand it over:
 *
 *     cc -O2 -shared -fPIC -o mine.so mine.c && mmverify prove --subject ./mine.so
 *
 * Every entry point is optional: if a pointer is null, the laws that need it are not_applicable. The
 * library is loaded into a process of its own; a crash, a hang, a write outside the buffers, exit() or an
 * exception ends that process alone and is reported with the case that caused it.
 *
 * Contract of every entry point (those of maps and codes have more to it, below):
 *   - count is 1 or more; arrays hold count elements (corners: 6 times count; places, triplets and weights 2 or
 *     3 times). Inputs are read-only.
 *   - the answer for an element depends on that element and the level alone: not on its place in the batch,
 *     the batch's size, earlier calls or the thread. Anything else is reported as non-deterministic.
 *   - calls come from several threads of one process at once, unless flags has MMVERIFY_SINGLE_THREADED.
 *   - the rounding and flush-to-zero modes are those of a fresh process, and every call restores them.
 *   - numbers lie at multiples of their size; maps, codes and blocks, which are bytes, at any address.
 *   - nothing is thrown across this border.
 *   - inputs and outputs are the caller's again after the call; another thread may write right beside an output
 *     during it. Inputs that hold the same numbers may be one array.
 *   - errno, the flags of past floating-point exceptions, the thread's locale and whatever lies on the stack may be
 *     anything; the signal mask stays as it is, and registers are left as the platform's ABI says.
 */
#ifndef MMVERIFY_SUBJECT_H
#define MMVERIFY_SUBJECT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this interface. It grows with every change that breaks older subjects. New entry points come at
 * the end of mmverify_subject_t, and `size` tells which of them a subject knows. */
#define MMVERIFY_SUBJECT_ABI 1u

/* flags */
#define MMVERIFY_SINGLE_THREADED 1u
#define MMVERIFY_TREE_STREAM 2u     /* codes of trees are the paper's two bit sequences; see tree_encode */
#define MMVERIFY_VQ_KEEPS 4u        /* vq2_encode and vq4_encode keep every map that a block can hold */
#define MMVERIFY_BAKE_CENTROID 8u   /* bake's unknown states follow alpha at the centroid; see bake */
#define MMVERIFY_BAKE_TIGHT 64u     /* bake's maps are unknown only where they must be */
#define MMVERIFY_ARRAY_FILES 512u   /* files of arrays are docs/ARRAYS.md's; see array_save */
#define MMVERIFY_DAG_CONTAINER 256u /* codes of scenes are the containers of docs/DAG.md; see dag_encode */
#define MMVERIFY_MESH_OWN_LEVELS \
  1024u /* bake_mesh chooses each map's level, up to the one that is asked for */
/* A call costs as much as thousands of elements, like a dispatch on a device: points, indices and places come in
 * batches of up to 65,536, and questions are repeated less often. */
#define MMVERIFY_LARGE_BATCHES 128u
/* The order of `corners`; at most one of these. */
#define MMVERIFY_CORNERS_OF_CHILDREN 16u /* the corners that the children 0, 2 and 3 touch */
#define MMVERIFY_CORNERS_BASE_U_V \
  32u /* base, and from there one step along u, and one along v; see corners */

/* Formats of maps, as Vulkan numbers them; also the bits of one state. */
#define MMVERIFY_2_STATE 1u
#define MMVERIFY_4_STATE 2u

/* Orders of the micro-vertices and of the micro-triangles (faces) of a map, and roundings of the mean of four codes;
 * see attribute_vertex_index, attribute_face_index and attribute_face_mip. */
#define MMVERIFY_VERTICES_W_MINOR 0u
#define MMVERIFY_VERTICES_U_MAJOR 1u
#define MMVERIFY_VERTICES_BIRD 2u
#define MMVERIFY_FACES_CURVE 0u
#define MMVERIFY_FACES_ROWS 1u
#define MMVERIFY_FACES_U_MAJOR 2u
#define MMVERIFY_ROUND_HALF_UP 0u
#define MMVERIFY_ROUND_HALF_TO_EVEN 1u
#define MMVERIFY_ROUND_TRUNCATE 2u
#define MMVERIFY_ROUND_HALVES_UP 3u
/* Edges of a map whose neighbour has one level less; see attribute_decimate. */
#define MMVERIFY_EDGE_W_U 1u /* v = 0 */
#define MMVERIFY_EDGE_U_V 2u /* w = 0 */
#define MMVERIFY_EDGE_V_W 4u /* u = 0 */

/* The API that traces, the outcomes and the bits of a candidate; see traverse_decide. */
#define MMVERIFY_EXT_PIPELINE 0u /* VK_EXT_opacity_micromap, a ray tracing pipeline */
#define MMVERIFY_EXT_QUERY 1u
#define MMVERIFY_KHR_PIPELINE 2u /* VK_KHR_opacity_micromap */
#define MMVERIFY_KHR_QUERY 3u
#define MMVERIFY_DXR_PIPELINE 4u /* TraceRay */
#define MMVERIFY_DXR_QUERY 5u    /* RayQuery */
#define MMVERIFY_IGNORED 0u      /* dropped without a shader */
#define MMVERIFY_OPAQUE 1u       /* confirmed without a shader */
#define MMVERIFY_NON_OPAQUE 2u   /* a shader decides */
#define MMVERIFY_CANDIDATE_STATE 3u
#define MMVERIFY_CANDIDATE_HAS_MICROMAP 4u
#define MMVERIFY_CANDIDATE_GEOMETRY_OPAQUE 8u

/* Shapes that are cut again and again; see subdivision_index. */
#define MMVERIFY_TRIANGLE_4 0u
#define MMVERIFY_TRIANGLE_9 1u
#define MMVERIFY_HILBERT 2u
#define MMVERIFY_MORTON 3u
#define MMVERIFY_TETRAHEDRON 4u
#define MMVERIFY_BISECTION 5u

/* The operations that blend a hit into a ray's payload; see traverse_blend. */
#define MMVERIFY_BLEND_MAX 0u
#define MMVERIFY_BLEND_MIN 1u
#define MMVERIFY_BLEND_ADD 2u
#define MMVERIFY_BLEND_MULTIPLY 3u
#define MMVERIFY_BLEND_OVER 4u

/* A hit on a ray.  Its value, and a payload, is a word: codes x / 255, R in the lowest byte, then G, B, A. */
typedef struct mmverify_hit {
  float distance;    /* finite, not negative */
  uint32_t accepted; /* 1: it may be the ray's closest hit; 0: it blends, and the ray goes on */
  uint32_t value;    /* the blended value, if it is not accepted */
} mmverify_hit_t;

/* The hits of one ray.  The struct has `size` bytes, as mmverify_bake_case. */
typedef struct mmverify_blend_case {
  uint32_t size;              /* sizeof(mmverify_blend_case) */
  uint32_t operation;         /* MMVERIFY_BLEND_MAX, ... */
  uint32_t payload;           /* before any hit */
  uint32_t count;             /* hits, 1 to 16 */
  const mmverify_hit_t* hits; /* in the order in which they are met, not sorted by distance */
} mmverify_blend_case_t;

/* The meaning of attribute codes, by which they are averaged; see attribute_bake_vertices. */
#define MMVERIFY_LINEAR 0u
#define MMVERIFY_SRGB 1u
#define MMVERIFY_NORMAL 2u
#define MMVERIFY_NORMAL_AND_LENGTH 3u

/* The texels, filters, wrap modes and alpha modes of a bake. */
#define MMVERIFY_UNORM8 1u  /* alpha = byte / 255 */
#define MMVERIFY_UNORM16 2u /* alpha = word / 65535 */
#define MMVERIFY_FLOAT32 3u
#define MMVERIFY_BILINEAR 0u
#define MMVERIFY_NEAREST 1u
#define MMVERIFY_REPEAT 0u
#define MMVERIFY_MIRRORED_REPEAT 1u
#define MMVERIFY_CLAMP_TO_EDGE 2u
#define MMVERIFY_CLAMP_TO_BORDER 3u
#define MMVERIFY_MIRROR_CLAMP_TO_EDGE 4u
#define MMVERIFY_MASK 0u
#define MMVERIFY_BLEND 1u

/* One base triangle on one texture's alpha.  The struct has `size` bytes; later headers add members at its end, and
 * a subject declines a case with members that it does not know. */
typedef struct mmverify_bake_case {
  uint32_t size;   /* sizeof(mmverify_bake_case) */
  uint32_t level;  /* 4^level micro-triangles, up to 12 */
  uint32_t format; /* MMVERIFY_2_STATE or MMVERIFY_4_STATE */

  uint32_t width, height; /* of mip 0; mip k has max(1, width >> k) and max(1, height >> k) */
  uint32_t mips;          /* 1 or more, up to the one of 1 x 1 texel */
  uint32_t texel;         /* MMVERIFY_UNORM8, ... */
  uint32_t border;    /* the texel outside with MMVERIFY_CLAMP_TO_BORDER, by its bits; no other bit is set */
  const void* texels; /* rows from the top, without gaps, mip after mip; aligned to a texel's size */

  uint32_t filter, wrap_u, wrap_v; /* Vulkan's; texel (i, j) has its centre at (i + 1/2, j + 1/2) */
  float factor, vertex_factor;     /* sampled alpha is multiplied by both; none below 0 */
  uint32_t alpha_mode;             /* MMVERIFY_MASK or MMVERIFY_BLEND */
  uint32_t cutoff_numerator,
      cutoff_denominator; /* of MMVERIFY_MASK: one over the other, exactly; also above 1 */
  float
      margin; /* texels, of each mip its own, by which each micro-triangle is grown to either side, along x and along
                 * y: by a square, not a disc; not below 0 */
  float uv
      [6]; /* u and v of the three vertices; (0, 0) is the outer corner of the first texel of the first row, (1, 1)
                 * that of the last one of the last */
} mmverify_bake_case_t;

/* The rules that a baker declares. */
#define MMVERIFY_OPAQUE_FROM_CUTOFF 0u  /* MASK: alpha >= cutoff is opaque */
#define MMVERIFY_OPAQUE_ABOVE_CUTOFF 1u /* MASK: alpha > cutoff is opaque */
#define MMVERIFY_CLOSED_MICRO_TRIANGLES 0u
#define MMVERIFY_OPEN_MICRO_TRIANGLES 1u /* touching in an area of 0 does not count */
#define MMVERIFY_UNKNOWN_ANY 0u          /* either unknown state */
#define MMVERIFY_UNKNOWN_BY_CENTROID 1u  /* by the rule of the flag MMVERIFY_BAKE_CENTROID */
#define MMVERIFY_UNKNOWN_BY_COVERAGE 2u  /* UO if most of the area is opaque; not judged */
#define MMVERIFY_UNKNOWN_OPAQUE 3u       /* all are UO */
#define MMVERIFY_UNKNOWN_TRANSPARENT 4u  /* all are UT */
/* restrictions */
#define MMVERIFY_BAKE_SAME_WRAPS 1u     /* wrap_u is wrap_v */
#define MMVERIFY_BAKE_POWERS_OF_TWO 2u  /* width and height are powers of two */
#define MMVERIFY_BAKE_NO_FACTORS 4u     /* both factors are 1 */
#define MMVERIFY_BAKE_NO_MARGIN 8u      /* margin is 0 */
#define MMVERIFY_BAKE_FLOAT_CUTOFFS 16u /* a cutoff is a number of binary32 in [0, 1] */
/* The cases that a baker supports. Cases are drawn from these, and states are judged by its rules. A field that is 0
 * means the most general choice; a subject built against a shorter header has zeros for the rest. Sets have bit
 * 1 << VALUE for each supported value; 0 means all values. */
typedef struct mmverify_bake_support {
  uint32_t size;         /* sizeof(mmverify_bake_support) */
  uint32_t max_level;    /* 0: 12 */
  uint32_t formats;      /* set of MMVERIFY_2_STATE, MMVERIFY_4_STATE */
  uint32_t texels;       /* set of MMVERIFY_UNORM8, ... */
  uint32_t filters;      /* set of MMVERIFY_BILINEAR, ... */
  uint32_t wraps;        /* set of MMVERIFY_REPEAT, ... */
  uint32_t alpha_modes;  /* set of MMVERIFY_MASK, MMVERIFY_BLEND */
  uint32_t max_side;     /* texels along a side; 0: 16384 */
  uint32_t max_mips;     /* 0: all */
  uint32_t restrictions; /* MMVERIFY_BAKE_SAME_WRAPS, ... */
  float fixed_cutoff;    /* the only cutoff of MASK; 0: any */
  uint32_t opaque;       /* MMVERIFY_OPAQUE_... */
  uint32_t contact;      /* MMVERIFY_CLOSED_... or MMVERIFY_OPEN_MICRO_TRIANGLES */
  uint32_t unknown;      /* MMVERIFY_UNKNOWN_... */
  float uv_min, uv_max;  /* of all texture coordinates; both 0: any */
  /* Sampling in fixed point: bits of a bilinear weight, and of the fraction of a coordinate in texels, 1 to 23;
   * 0: exact. A state may then be wrong where alpha is within (2^-a + 2^-b) R of the cutoff, where a and b are
   * these (a term falls away with its 0) and R is the greatest texel less the least, over the case's texels and, with
   * MMVERIFY_CLAMP_TO_BORDER, its border, times both factors. */
  uint32_t weight_bits, coordinate_bits;
} mmverify_bake_support_t;

/* One base triangle on a texture of attributes, or on one mip of it.  The struct has `size` bytes, as
 * mmverify_bake_case. */
typedef struct mmverify_attribute_case {
  uint32_t size;                   /* sizeof(mmverify_attribute_case) */
  uint32_t level;                  /* up to 12 */
  uint32_t width, height;          /* in texels */
  const void* texels;              /* R G B A each, rows from the top, without gaps; at any address */
  uint32_t texel;                  /* MMVERIFY_UNORM8: a byte a channel; others may follow */
  uint32_t border[4];              /* R G B A outside with MMVERIFY_CLAMP_TO_BORDER, each a code */
  uint32_t filter, wrap_u, wrap_v; /* as in mmverify_bake_case; the filter is for vertices */
  uint32_t meaning;                /* MMVERIFY_LINEAR, ... */
  float uv[6];                     /* as in mmverify_bake_case */
} mmverify_attribute_case_t;

/* The cases that a baker of attributes supports; fields that are 0, and sets, as in mmverify_bake_support. */
typedef struct mmverify_attribute_support {
  uint32_t size;         /* sizeof(mmverify_attribute_support) */
  uint32_t max_level;    /* 0: 12 */
  uint32_t meanings;     /* set of MMVERIFY_LINEAR, ... */
  uint32_t filters;      /* set of MMVERIFY_BILINEAR, ... */
  uint32_t wraps;        /* set of MMVERIFY_REPEAT, ... */
  uint32_t restrictions; /* MMVERIFY_BAKE_SAME_WRAPS */
  uint32_t tolerance; /* codes that a channel may be off by, up to 16; 0: each is the exact number, rounded */
} mmverify_attribute_support_t;

/* Arrays of many triangles' maps; see array_build and the entry points after it. */
#define MMVERIFY_ARRAY_EXT 0u
#define MMVERIFY_ARRAY_KHR 1u
#define MMVERIFY_ARRAY_DXR 2u
#define MMVERIFY_ARRAY_OPTIX 3u
#define MMVERIFY_ARRAY_NVAPI 4u
#define MMVERIFY_ARRAY_GLTF 5u
#define MMVERIFY_INDEX_U8 0u
#define MMVERIFY_INDEX_U16 1u
#define MMVERIFY_INDEX_U32 2u
#define MMVERIFY_INDEX_I16 3u /* glTF alone has signed ones */
#define MMVERIFY_INDEX_I32 4u
#define MMVERIFY_INDEX_IN_CLUSTER 8u /* added to one of these in array_resolve: -5 means no micromap */
#define MMVERIFY_ARRAY_SPECIAL 1u    /* a uniform map becomes a special index */
#define MMVERIFY_ARRAY_SHARE 2u      /* equal level, format and states share a record */
#define MMVERIFY_TARGET_SPECIAL 0u
#define MMVERIFY_TARGET_NONE 1u
#define MMVERIFY_TARGET_RECORD 2u
#define MMVERIFY_TARGET_OUTSIDE 3u

/* A triangle of an array that is to be built. */
typedef struct mmverify_array_triangle {
  uint32_t level, format;
  uint32_t map; /* the first byte of its map in `maps` */
} mmverify_array_triangle_t;

/* The input of array_build.  The struct has `size` bytes, as mmverify_bake_case. */
typedef struct mmverify_array_case {
  uint32_t size;       /* sizeof(mmverify_array_case) */
  uint32_t api;        /* MMVERIFY_ARRAY_EXT, ... */
  uint32_t index_type; /* MMVERIFY_INDEX_U8, ..., one that the API takes */
  uint32_t base_triangle;
  uint32_t flags; /* MMVERIFY_ARRAY_SPECIAL, MMVERIFY_ARRAY_SHARE */
  uint32_t
      bound; /* near-duplicate merging: micro-triangles of each triangle that may become unknown; 0: none */
  uint32_t before; /* the first triangles, which are records already, one each; base_triangle <= before */
  uint32_t count;  /* of all triangles */
  const mmverify_array_triangle_t* triangles;
  const uint8_t* maps; /* packed as maps are, the bits after the last state zero; at any byte */
} mmverify_array_case_t;

/* The head of an answer of array_build.  Without gaps follow: the records, 8 bytes each; the array's usage counts, and
 * the geometry's, three words each: count, level, format; the indices; the data. */
typedef struct mmverify_array_answer {
  uint32_t records, array_counts, geometry_counts; /* how many there are */
  uint32_t index_bytes, data_bytes;
} mmverify_array_answer_t;

/* The head of an array and its geometries as bytes, for changes and files.  Without gaps, little-endian: this; an
 * mmverify_array_geometry for each geometry; the records, 8 bytes each; each geometry's indices; the data. */
typedef struct mmverify_array_parts {
  uint32_t records, data_bytes, geometries;
} mmverify_array_parts_t;

/* A geometry of such an array: an index for each triangle; plain indices count from its base_triangle. */
typedef struct mmverify_array_geometry {
  uint32_t index_type; /* MMVERIFY_INDEX_U8, ... */
  uint32_t base_triangle, triangles;
} mmverify_array_geometry_t;

/* Triangles on one texture, whose maps come in one array; see bake_mesh.  The struct has `size` bytes, as
 * mmverify_bake_case. */
typedef struct mmverify_mesh_case {
  uint32_t size;                       /* sizeof(mmverify_mesh_case) */
  uint32_t api;                        /* MMVERIFY_ARRAY_EXT, ... */
  uint32_t index_type;                 /* MMVERIFY_INDEX_U8, ..., one that the API takes */
  uint32_t triangles, vertices;        /* how many; 1 or more */
  const uint32_t* indices;             /* three vertices a triangle, each below `vertices` */
  const float* uvs;                    /* u and v of each vertex */
  const uint32_t* levels;              /* of each triangle, none above the surface's; null: all have that */
  const mmverify_bake_case_t* surface; /* the texture, its sampling and the format; its uv are zeros */
} mmverify_mesh_case_t;

/* A subject: its name, its limits, its entry points. */
typedef struct mmverify_subject {
  uint32_t abi;     /* MMVERIFY_SUBJECT_ABI */
  uint32_t size;    /* sizeof(mmverify_subject) */
  const char* name; /* for messages; may be null */
  /* The highest supported level: up to 16 for indices and attribute maps, up to 12 for trees. Maps to maps always go to
   * 12; bakers have theirs in bake_support and attribute_support. */
  uint32_t max_level;
  uint32_t flags;

  /* Index of the micro-triangle that contains (u[k], v[k]), as VK_EXT_opacity_micromap defines it: u belongs to the
   * second vertex, v to the third. u, v >= 0, -0 is 0; u+v <= 1, or up to 2^-23 over, as hits on the hypotenuse come: such
   * a point is in the last micro-triangle of the row that contains v. */
  void (*index_f32)(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);
  void (*index_f64)(uint32_t level, const double* u, const double* v, uint32_t* index, size_t count);

  /* Corners of the micro-triangle with index[k] < 4^level: i0 j0 i1 j1 i2 j2, in units of 1/2^level
   * along u and v. Their order matters only if `flags` declares one. MMVERIFY_CORNERS_BASE_U_V: the base is the
   * corner from which the other two lie along u and along v; the steps are +1, in inverted ones -1. */
  void (*corners)(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

  /* The index and the corners in row order (Gruen et al.; Color and Attribute Micromaps, figure 4): a point on an edge
   * belongs where that figure's row, column and diagonal put it: min(N-1, floor((1-w)N)), min(row, floor(vN)) and
   * min(N-1, floor((1-u)N)), of exact numbers, w = 1-u-v. Points are those of index_f32. Corners come in any order. */
  void (*row_index_f32)(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);
  void (*row_corners)(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

  /* Maps and codes. A map of level n and format b is 4^n states of b bits in the order of the index, packed
   * from the least significant bit of each byte on: ceil(4^n b / 8) bytes, the bits after the last state
   * zero. States are T 0, O 1, UT 2, UO 3; a map in 2-state has the first two.
   *   - Bytes may lie at any address. No byte outside a buffer's size is read or written.
   *   - A subject built against a header without these entry points has a smaller `size`, and none is called.
   *
   * With the flag MMVERIFY_TREE_STREAM the codes are those of Succinct Opacity Micromaps, Algorithms 1 and 2:
   * the tree's bits in pre-order, 1 internal and 0 leaf, child 0 first, then from the next whole byte on the
   * leaves' states in the same order; both packed like maps, the bits after the last zero. Then any of the
   * four may stand alone: the specification encodes for a subject without tree_encode and decodes for one
   * without tree_decode. Without the flag tree_encode is required, and a way back: tree_decode or a lookup.
   */

  /* The size of the map's code, which is 1 or more; 0 if there is none, which is a wrong answer. The code is
   * written if `capacity` is at least its size; otherwise the buffer's bytes do not count, and the call is
   * repeated with that size. One map has one code. */
  size_t (*tree_encode)(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code, size_t capacity);

  /* Nonzero if the code is a map's code of this level and format, and then writes the map. Otherwise 0, and
   * the bytes of `map` do not count. `code` may be any bytes: cut short, 0 bytes, one bit flipped. */
  int (*tree_decode)(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size, uint8_t* map);

  /* The states at index[k] < 4^level, and at the barycentrics (u[k], v[k]), which are as in index_f32. One byte a
   * state. `code` is a whole code, as tree_encode gives it. */
  void (*tree_lookup)(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size,
                      const uint32_t* index, uint8_t* state, size_t count);
  void (*tree_lookup_f32)(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size,
                          const float* u, const float* v, uint8_t* state, size_t count);

  /* Maps to maps. Here the bits after the last state may be anything in the input, and must be zero in the
   * output. All write the whole of their output. Level and format are those of the input;
   * levels go up to 12. */

  /* Packs `count` states, one byte each, to a map, and unpacks them. */
  void (*micromap_pack)(uint32_t format, const uint8_t* states, size_t count, uint8_t* map);
  void (*micromap_unpack)(uint32_t format, const uint8_t* map, size_t count, uint8_t* states);

  /* The 2-state map of a 4-state map: T and UT become T, O and UO become O; and a 2-state map as a 4-state map. */
  void (*micromap_force2)(uint32_t level, const uint8_t* four_state, uint8_t* two_state);
  void (*micromap_widen)(uint32_t level, const uint8_t* two_state, uint8_t* four_state);

  /* The map of level + 1 in which four children have their parent's state; and the map of level - 1. There a parent
   * is T or O if its children all are, else, in 4-state, UO if two or more are O or UO, else UT; in 2-state it is O
   * if two or more are. micromap_down is never called at level 0. */
  void (*micromap_up)(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* above);
  void (*micromap_down)(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* below);

  /* A 4-state map through one bit a state and back: mode 0 separates O and UO from the rest (T and O come back),
   * mode 1 T from the rest (T and an unknown, either one), mode 2 O from the rest (O and an unknown, either one). */
  void (*micromap_through)(uint32_t level, uint32_t mode, const uint8_t* four_state, uint8_t* out);

  /* A 4-state map after a lossy codec: encoded and decoded.  The laws lossy.allowed, lossy.conservative and
   * lossy.force2_stable restrict which states may replace others; a codec need not keep all three.  One map has one
   * answer, whatever the bits after its last state. */
  void (*micromap_substitute)(uint32_t level, const uint8_t* four_state, uint8_t* out);

  /* Square opacity maps and blocks of them (Compressed Opacity Maps): VQ2, 16x16 regions in 32 bytes, and
   * VQ4, 32x32 in 64. A map has a byte a region, T 0, C 1, O 2, region (x, y) at x + 16 y or x + 32 y: x from
   * the left, y from the BOTTOM. The order of a block's bits, which the paper leaves open, is that of
   * docs/VQ.md.
   *   - All bytes are a block. A decoder writes the whole map; `region` gives the states at (x[k], y[k]), each
   *     below 16 or 32.
   *   - An encoder takes every map, O beside T included, and writes a whole block; one map has one block. It promises that
   *     the block is conservative: T and O stay or become C, and C stays. With MMVERIFY_VQ_KEEPS all its encoders promise
   *     more: a map that some block can hold whole is kept whole, however few of the entries it needs. Without that flag
   *     no law asks how much is kept.
   *   - Each entry point stands alone: the specification decodes the block of an encoder.
   */
  void (*vq2_decode)(const uint8_t* block, uint8_t* map);
  void (*vq2_region)(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                     size_t count);
  void (*vq2_encode)(const uint8_t* map, uint8_t* block);
  void (*vq4_decode)(const uint8_t* block, uint8_t* map);
  void (*vq4_region)(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                     size_t count);
  void (*vq4_encode)(const uint8_t* map, uint8_t* block);

  /* The map of a base triangle: of level and format `what->level` and `what->format`, its micro-triangles in
   * the order of the index, packed as maps are, the bits after the last state zero. Nonzero if it is baked; 0
   * if the subject does not support the case, and then the bytes of `map` do not count. Cases that it declines are
   * counted and never taken for right.
   *   - O: alpha, as it is sampled, is opaque on the whole closed micro-triangle, and in each mip.
   *     MASK: alpha >= cutoff; BLEND: alpha >= 1.
   *   - T: transparent on all of it. MASK: alpha < cutoff; BLEND: alpha <= 0.
   *   - Any micro-triangle may be unknown; the law bake.tight checks that no more are than must be.
   *   - Alpha is not clamped to [0, 1]: factors and texels of binary32 may take it beyond.  All numbers are finite.  With
   *     BLEND the cutoff means nothing.
   *   - MMVERIFY_NEAREST: the texel at (floor(x), floor(y)), x and y in texels.  A point on the line between two texels
   *     belongs to the second, and an edge on the line has such points.
   *   - With the flag MMVERIFY_BAKE_CENTROID, or MMVERIFY_UNKNOWN_BY_CENTROID in bake_support, an unknown one is UO
   *     if alpha at its centroid, without margin and in mip 0, is >= cutoff (BLEND: >= 1/2), else UT.
   *   - A map in 2-state has O where the one in 4-state has O or UO, T where it has T or UT, by the baker's own rule for
   *     unknown states. */
  int (*bake)(const mmverify_bake_case_t* what, uint8_t* map);

  /* The cases that `bake` supports; null: all, and `bake` declines case by case. */
  const mmverify_bake_support_t* bake_support;

  /* Attribute micromaps (Color and Attribute Micromaps, 3.1): the places of values in a map of level n up to 16, N = 2^n.
   * Micro-vertex (i, j) is i steps along u and j along v, i + j <= N.  Micro-triangle (iu, iv, upper) is half of the
   * grid square with the corner (iu, iv): upper 0 the half at that corner, upper 1 the other, iu + iv + upper < N.
   *   - Orders of vertices, V(n) = (N+1)(N+2)/2 of them.  W-minor: r(r+1)/2 + j, r = i+j.  U-major: i(N+2) - i(i+1)/2 + j.
   *     Bird: the corners w, u, v are 0, 1, 2; then each level m adds three vertices for each upright micro-triangle of
   *     level m-1, in the order of the curve: those of its edges w-v, u-v and w-u.
   *   - Orders of faces, 4^n of them.  Curve: that of index_f32.  Rows: r^2 + 2 iv + upper, r = iu+iv+upper.  U-major:
   *     4^n - (N-iu)^2 + 2 iv + upper.
   *   - An entry point with an order must support all three. */

  /* Place to index, and index to place: i0 j0 i1 j1 ..., iu0 iv0 upper0 iu1 ... */
  void (*attribute_vertex_index)(uint32_t level, uint32_t vertex_order, const uint32_t* i, const uint32_t* j,
                                 uint32_t* index, size_t count);
  void (*attribute_vertex_place)(uint32_t level, uint32_t vertex_order, const uint32_t* index,
                                 uint32_t* place, size_t count);
  void (*attribute_face_index)(uint32_t level, uint32_t face_order, const uint32_t* iu, const uint32_t* iv,
                               const uint32_t* upper, uint32_t* index, size_t count);
  void (*attribute_face_place)(uint32_t level, uint32_t face_order, const uint32_t* index, uint32_t* place,
                               size_t count);

  /* Indices of the three vertices of face[k] < 4^level: the base, one step along u and one along v from there; the base of
   * an upper one is (iu+1, iv+1), and its steps are -1. */
  void (*attribute_triplet)(uint32_t level, uint32_t vertex_order, uint32_t face_order, const uint32_t* face,
                            uint32_t* vertices, size_t count);

  /* The face whose three vertices are first[k], second[k], third[k], in that order. */
  void (*attribute_face_of)(uint32_t level, uint32_t vertex_order, uint32_t face_order, const uint32_t* first,
                            const uint32_t* second, const uint32_t* third, uint32_t* face, size_t count);

  /* The vertices of the micro-triangle that contains (u[k], v[k]), ties as in index_f32, and the point's weights there,
   * in the order of its vertices: with fu = uN - iu and fv = vN - iv, lower (1-fu-fv, fu, fv), upper (fu+fv-1, 1-fu, 1-fv).
   * Each weight is within 2^-24 of the exact one and none is below 0.  Where 4uN and 4vN are whole numbers, the weights are
   * the exact ones, which binary32 holds: so neighbours agree on their edge.  u, v >= 0, -0 is 0; u+v <= 1. */
  void (*attribute_triplet_f32)(uint32_t level, uint32_t vertex_order, const float* u, const float* v,
                                uint32_t* vertices, size_t count);
  void (*attribute_weights_f32)(uint32_t level, const float* u, const float* v, float* weights, size_t count);

  /* The vertex that the value of vertex (i[k], j[k]) is read from if the edges of `flags` (MMVERIFY_EDGE_W_U, ...)
   * have a neighbour of level n-1, as i0 j0 i1 j1 ...  At level 0 no edge has one.  An odd vertex of such an edge goes
   * to one of the two even vertices next to it on the edge, so chosen that no crack opens and no micro-triangle turns
   * over; any other vertex stays. */
  void (*attribute_decimate)(uint32_t level, uint32_t flags, const uint32_t* i, const uint32_t* j,
                             uint32_t* place, size_t count);

  /* The faces of the level below in the order of the curve, from bytes R G B A each: byte by byte the mean of the faces
   * 4k to 4k+3.  With s their sum, HALF_UP floor((s+2)/4); HALF_TO_EVEN to the nearest, halves to the even one; TRUNCATE
   * floor(s/4); HALVES_UP h(h(a,b), h(c,d)), h(x,y) = floor((x+y+1)/2).  `children` are 16 bytes a parent. */
  void (*attribute_face_mip)(uint32_t rounding, const uint8_t* children, size_t parents, uint8_t* out);

  /* Maps of attributes from a texture (Color and Attribute Micromaps, 5.1): bytes R G B A for each micro-triangle in the
   * order of the curve, and for each micro-vertex in W-minor order.  Nonzero if it is baked; 0 if the subject does not
   * support the case, and then the bytes of `map` do not count.
   *   - Faces: the mean of the texels under the micro-triangle, each by its share of the area.  If it is
   *     a segment in the texture, texels weigh by how much of the micro-triangle maps to them; if it is a point, its
   *     texel counts alone: the limits of triangles with an area.
   *   - Vertices: the filter's value at the micro-vertex.
   *   - Means are of codes with MMVERIFY_LINEAR.  MMVERIFY_SRGB has R, G and B on the sRGB curve and averages light.
   *     MMVERIFY_NORMAL has directions 2 code / 255 - 1, whose mean is made one unit long again; MMVERIFY_NORMAL_AND_LENGTH
   *     the same, and in the place of alpha the mean's own length, 1 at most.  Texels are averaged as they are stored, and
   *     one texel alone is made one unit long, too.  Alpha is linear.  A mean without a direction is (0, 0, 1).
   *   - A code is the one nearest to the number, of two the greater. */
  int (*attribute_bake_faces)(const mmverify_attribute_case_t* what, uint8_t* map);
  int (*attribute_bake_vertices)(const mmverify_attribute_case_t* what, uint8_t* map);

  /* The cases that these two support; null: all, and they decline case by case. */
  const mmverify_attribute_support_t* attribute_support;

  /* The outcome of a candidate hit on a triangle before any shader runs: a byte each, MMVERIFY_IGNORED, ...
   *   - candidate[k]: the state that was read, T 0, O 1, UT 2, UO 3, after any lossy substitution, with
   *     MMVERIFY_CANDIDATE_HAS_MICROMAP if a micromap or a special index gave it (else the state is 0), and
   *     MMVERIFY_CANDIDATE_GEOMETRY_OPAQUE if the geometry was built as opaque.
   *   - instance_flags[k] has Vulkan's and DXR's numbers: FORCE_OPAQUE 4, FORCE_NO_OPAQUE 8, force-2-state 16, micromaps
   *     disabled 32.  ray_flags[k] has SPIR-V's and DXR's: Opaque 1, NoOpaque 2, CullOpaque 64, CullNoOpaque 128,
   *     force-2-state 1024.  No other bit is set in any of them.
   *   - `api` is MMVERIFY_EXT_PIPELINE, ...; the pipeline, the shader or the RayQuery is set up for micromaps wherever there
   *     is one.  Combinations that no API defines are never asked: docs/TRAVERSE.md names them. */
  void (*traverse_decide)(uint32_t api, const uint32_t* candidate, const uint32_t* instance_flags,
                          const uint32_t* ray_flags, uint8_t* outcome, size_t count);

  /* The place where the subject runs, such as a device: lines KEY: VALUE, of 4000 bytes together, which are printed and
   * stored with the verdicts.  May be null. */
  const char* runs_on;

  /* Fixed functions in traversal (Color and Attribute Micromaps, 4.3): out[k] is the payload payload[k] after a hit with
   * value[k], code by code, p of the payload, v of the value, alpha the value's own code A:
   *   MAX max(p, v); MIN min(p, v); ADD min(255, p + v); MULTIPLY p v / 255; OVER min(255, v + p (255 - alpha) / 255), of
   *   values with alpha multiplied in, or with any alpha.  A quotient is the code nearest to it; none lies halfway. */
  void (*traverse_blend)(uint32_t operation, const uint32_t* payload, const uint32_t* value, uint32_t* out,
                         size_t count);

  /* The payload that a ray ends with, as bytes R G B A.  The hits that blend are those nearer than the nearest accepted
   * one, whether that is met before them or after; one at its very distance does not blend.  Each blends as often as it is
   * reported, MULTIPLY and OVER in the order in which the hits are met. */
  void (*traverse_blend_hits)(const mmverify_blend_case_t* what, uint8_t* payload);

  /* The array of a geometry's triangles, behind the records before: an mmverify_array_answer and the parts that follow it,
   * little-endian. Returns its size, as tree_encode; 0 only if an index does not fit its type.
   *   - A record is u32 offset of its map in the data, u16 level, u16 format, as VkMicromapTriangleEXT. The records before
   *     come first and keep their maps; each triangle after them has an index, and no new record is unused.
   *   - An index is its record less base_triangle; maps share records from base_triangle on. A special index is -1 T,
   *     -2 O, -3 UT, -4 UO in the type's width, and base_triangle is no part of it.
   *   - Each triangle keeps its level and format, and resolves to its own map. With a bound, T and O may become UT or
   *     UO in 4-state, in at most `bound` micro-triangles of each triangle; nothing else may change. Nothing has to be
   *     merged.
   *   - The array's usage counts are its records' by level and format. The geometry's, which EXT, OptiX and NVAPI alone
   *     have, are its triangles', by their records' level and format, special indices left out. Both in any order. */
  size_t (*array_build)(const mmverify_array_case_t* what, uint8_t* answer, size_t capacity);

  /* The target of code[k] < 2^width in a geometry with base_triangle[k], over records[k] records: two numbers each, its
   * kind and its value. MMVERIFY_TARGET_SPECIAL and the state; _NONE and 0: -5 in a cluster; _RECORD and its number,
   * base added; _OUTSIDE and 0: no such record, and a signed code below the special ones. */
  void (*array_resolve)(uint32_t index_type, const uint32_t* code, const uint32_t* base_triangle,
                        const uint32_t* records, uint32_t* target, size_t count);

  /* Changes of arrays, after which each triangle of each geometry resolves as before.  Arrays are bytes as in
   * mmverify_array_parts, before and after; the size is returned, as by tree_encode.  Every plain index names a
   * record, every record's bytes lie in the data; records may share bytes.
   *   compact      drops unused records, and bytes that no record uses
   *   reorder      all records, those in use first, in the order of their first use
   *   concatenate  two arrays, whose bytes follow each other: the first's records and geometries, then the second's
   * After compact and reorder every byte of the data is a record's. */
  size_t (*array_compact)(const uint8_t* array, size_t array_size, uint8_t* changed, size_t capacity);
  size_t (*array_reorder)(const uint8_t* array, size_t array_size, uint8_t* changed, size_t capacity);
  size_t (*array_concatenate)(const uint8_t* arrays, size_t arrays_size, uint8_t* changed, size_t capacity);

  /* The file of an array, of version 1 or 2, and the array of a file, as mmverify_array_parts; sizes as by tree_encode.
   * Version 2 holds every array. array_save returns 0 if version 1 does not hold this one; array_load, for bytes that
   * are no file.
   *   - Any form of file will do if each array that is saved is loaded unchanged.  With the flag MMVERIFY_ARRAY_FILES files
   *     are docs/ARRAYS.md's, byte by byte, and array_load refuses other bytes: cut short, one bit flipped, 0 bytes.  A
   *     file whose indices or records make no array ("Files" there lists them) may be loaded as it is, or refused. */
  size_t (*array_save)(uint32_t version, const uint8_t* array, size_t array_size, uint8_t* file,
                       size_t capacity);
  size_t (*array_load)(const uint8_t* file, size_t file_size, uint8_t* array, size_t capacity);

  /* The 4-state map at level most < level that replaces one of a level that a device does not support (KHR, lossy
   * micromaps): T for a block of T alone, O for one of O, UT or UO for any other. */
  size_t (*array_emulate)(uint32_t level, uint32_t most, const uint8_t* map, uint8_t* emulated,
                          size_t capacity);

  /* The maps of a scene in one graph, or in whatever form a codec of many maps has.
   *   - A scene is maps of one format, one after another: a byte with the level, 0 to 12, then the map, packed, its
   *     bits after the last state zero.  Maps are numbered from 0 in that order.
   *   - Any form of code will do, as long as a scene has one.  With the flag MMVERIFY_DAG_CONTAINER the codes are the
   *     containers of docs/DAG.md.
   *   - dag_encode is required, and a way back: dag_decode or a lookup.
   */

  /* The size of the scene's code, and the code, as tree_encode. */
  size_t (*dag_encode)(uint32_t format, const uint8_t* scene, size_t scene_size, uint8_t* code,
                       size_t capacity);

  /* The size of the scene of a code, and the scene, likewise; 0 if no scene has that code, which may be any bytes: cut
   * short, 0 bytes, one bit flipped.  If the form of the codes is the subject's own, such bytes may give 0 or any
   * scene, the same at each call. */
  size_t (*dag_decode)(uint32_t format, const uint8_t* code, size_t code_size, uint8_t* scene,
                       size_t capacity);

  /* The states at index[k] < 4^level of map[k], and at the barycentrics (u[k], v[k]) as index_f32 gets them.  One byte a
   * state.  `code` is a whole code, as dag_encode gives it. */
  void (*dag_lookup)(uint32_t format, const uint8_t* code, size_t code_size, const uint32_t* map,
                     const uint32_t* index, uint8_t* state, size_t count);
  void (*dag_lookup_f32)(uint32_t format, const uint8_t* code, size_t code_size, const uint32_t* map,
                         const float* u, const float* v, uint8_t* state, size_t count);

  /* The maps of a mesh, as an array and a geometry's indices: an answer like array_build's, its size likewise; 0 if the
   * subject does not support the case.  bake_support holds for it, too; records, indices and both usage counts are as
   * in array_build, without a base triangle.
   *   - A triangle's index leads to a map, or is special.  Each state, and a special one on the whole triangle, is right
   *     as `bake` has it for the triangle's own coordinates, in the order of its own vertices; any may be unknown.
   *   - Triangles may share a record wherever it is right for each of them, and nowhere else.
   *   - A record has the format of `surface` and the level that its triangles ask for, or, with
   *     MMVERIFY_MESH_OWN_LEVELS, at most that.  Records may lie in any order, their bytes at any offset; two overlap
   *     only if they have one offset, level and format.
   *   - With MMVERIFY_BAKE_TIGHT a state is unknown only where it must be, also if the triangle shares its map.
   *   - In 2-state all is as force-2-state of the array in 4-state. */
  size_t (*bake_mesh)(const mmverify_mesh_case_t* what, uint8_t* answer, size_t capacity);

  /* The cells of shapes that are cut again and again, in the order of a curve: docs/SUBDIVISION.md lists the children.
   *   - scheme is MMVERIFY_TRIANGLE_4, ...; levels go to max_level, of the bisection to twice that and one, and up to
   *     the scheme's last one.
   *   - A point has the coordinates x[k], y[k], z[k] over denominator[k] <= 2^31: barycentrics of a triangle's second and
   *     third vertex, x and y of a quad, barycentrics of a tetrahedron's last three; others are 0.  It lies in the shape.
   *   - corners: four times x, y, z on the level's grid, of 2^n, 3^n or, of the bisection, 2^ceil(n/2) to a side, in the
   *     order of the specification; a triangle's fourth one is 0. */
  void (*subdivision_index)(uint32_t scheme, uint32_t level, const uint32_t* x, const uint32_t* y,
                            const uint32_t* z, const uint32_t* denominator, uint32_t* index, size_t count);
  void (*subdivision_corners)(uint32_t scheme, uint32_t level, const uint32_t* index, uint32_t* corners,
                              size_t count);
} mmverify_subject_t;

/* The one exported symbol. The result must stay valid and unchanged for the life of the process; a later call returns
 * the same. Null is an error. */
const mmverify_subject_t* mmverify_subject_v1(void);

/* A library that can run in some places only may export this as well. It is called if mmverify_subject_v1 returned
 * null, and returns the reason why it cannot run here, "no Vulkan device" for example. Its laws are then not_applicable
 * for that reason. */
const char* mmverify_subject_v1_not_here(void);

/* ---- A tree codec by recursion, for proofs at levels that have too many maps for one formula ---- */

/* A place in the two sequences of a code: bits of the tree, and states of the data, before it. */
typedef struct mmverify_place {
  size_t nodes, leaves;
} mmverify_place_t;

/* The recursive functions of a tree codec. tree_encode, tree_decode and tree_lookup call them, and each calls itself,
 * or skip, for the four subtrees of the level below. They keep a contract, which `mmverify prove --source` proves from
 * level to level: a subtree of `level` is that of the states from number `first` on; it has 4 j + 1 nodes and 3 j + 1
 * leaves for some j. Packing and order of the bits are those of a map, the lowest bits of a byte first. `tree` and
 * `data` begin where the code's sequences do. Nothing that a function reads changes, but what it shall write and `at`.
 * Laws of decoding need skip and read, tree.lookup_is_decode needs skip and find; what no law needs may be null. */
typedef struct mmverify_contract {
  size_t size; /* sizeof(mmverify_contract_t) */

  /* Moves `at` over the subtree of the map. */
  void (*measure)(uint32_t level, uint32_t format, const uint8_t* map, size_t first, mmverify_place_t* at);

  /* Writes the subtree's nodes and leaves into zeros, from `at` on, and moves `at` over them. */
  void (*write)(uint32_t level, uint32_t format, const uint8_t* map, size_t first, uint8_t* tree,
                uint8_t* data, mmverify_place_t* at);

  /* Moves `at` over the subtree and returns 1; or returns 0, and `at` may be anything. Bits of the tree from number
   * `most` on, counted from its beginning, may not be read. */
  int (*skip)(uint32_t level, const uint8_t* tree, size_t most, mmverify_place_t* at);

  /* Writes the subtree's states into zeros of the map, moves `at` over the subtree and returns 1; or returns 0. */
  int (*read)(uint32_t level, uint32_t format, const uint8_t* tree, const uint8_t* data, size_t first,
              mmverify_place_t* at, uint8_t* map);

  /* The state at index % 4^level of the subtree at `at`, which may be anything afterwards. */
  unsigned (*find)(uint32_t level, uint32_t format, const uint8_t* tree, const uint8_t* data, size_t most,
                   size_t index, mmverify_place_t* at);
} mmverify_contract_t;

/* Exported, beside mmverify_subject_v1, by codecs that are to be proved in that way. skip and read return 1 for the
 * code of a map. */
const mmverify_contract_t* mmverify_contract_v1(void);

#ifdef __cplusplus
}
#endif

#endif
