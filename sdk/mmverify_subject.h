/* The interface between mmverify and an implementation under test.
 *
 * Build a shared library that exports one function, mmverify_subject_v1, and hand it over:
 *
 *     cc -O2 -shared -fPIC -o mine.so mine.c && mmverify prove --subject ./mine.so
 *
 * Every entry point is optional: leave a pointer null and the laws that need it say not_applicable. The
 * library is loaded into a process of its own; a crash, a hang, a write outside the buffers, exit() or an
 * exception ends that process alone and is reported with the case that did it.
 *
 * Contract of every entry point (those of maps and codes have more to it, below):
 *   - count is 1 or more; arrays hold count elements (corners: 6 times count; places, triplets and weights 2 or
 *     3 times). Inputs are read-only.
 *   - the answer for an element depends on that element and the level alone: not on its place in the batch,
 *     the batch's size, earlier calls or the thread. Anything else is reported as non-deterministic.
 *   - calls come from several threads of one process at once, unless flags has MMVERIFY_SINGLE_THREADED.
 *   - the rounding and flush-to-zero modes are those of a fresh process, and are left as they were found.
 *   - numbers lie at multiples of their size; maps, codes and blocks, which are bytes, at any address.
 *   - nothing is thrown across this border.
 */
#ifndef MMVERIFY_SUBJECT_H
#define MMVERIFY_SUBJECT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Grows with every change that an older subject would not survive. New entry points come at the end: `size`
 * tells. */
#define MMVERIFY_SUBJECT_ABI 1u

/* flags */
#define MMVERIFY_SINGLE_THREADED 1u
#define MMVERIFY_TREE_STREAM 2u     /* codes of trees are the paper's two bit sequences; see tree_encode */
#define MMVERIFY_VQ_KEEPS 4u        /* vq2_encode and vq4_encode keep every map that a block can hold */
#define MMVERIFY_BAKE_CENTROID 8u   /* bake's unknown states are those of the centroid; see bake */
#define MMVERIFY_BAKE_TIGHT 64u     /* nothing is unknown in bake's maps but what has to be */
#define MMVERIFY_ARRAY_FILES 512u   /* files of arrays are docs/ARRAYS.md's; see array_save */
#define MMVERIFY_DAG_CONTAINER 256u /* codes of scenes are the containers of docs/DAG.md; see dag_encode */
/* A call costs as much as thousands of elements do, as a dispatch on a device does: points, indices and places come in
 * batches of up to 65,536, and answers are asked again less often. */
#define MMVERIFY_LARGE_BATCHES 128u
/* The order of `corners`; at most one of these. */
#define MMVERIFY_CORNERS_OF_CHILDREN 16u /* those that the children 0, 2 and 3 touch */
#define MMVERIFY_CORNERS_BASE_U_V \
  32u /* base, and from there one step along u, and one along v; see corners */

/* Formats of maps, as Vulkan numbers them; also the bits of one state. */
#define MMVERIFY_2_STATE 1u
#define MMVERIFY_4_STATE 2u

/* Orders of the micro-vertices and of the micro-triangles (faces) of a map, and what is done with the mean of four codes;
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

/* Who traces, and what becomes of a candidate; see traverse_decide. */
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

/* How a hit blends into a ray's payload; see traverse_blend. */
#define MMVERIFY_BLEND_MAX 0u
#define MMVERIFY_BLEND_MIN 1u
#define MMVERIFY_BLEND_ADD 2u
#define MMVERIFY_BLEND_MULTIPLY 3u
#define MMVERIFY_BLEND_OVER 4u

/* A hit on a ray.  Its value, and a payload, is a word: codes x / 255, R in the lowest byte, then G, B, A. */
typedef struct mmverify_hit {
  float distance;    /* finite, not negative */
  uint32_t accepted; /* 1: it may be the ray's closest hit; 0: it blends, and the ray goes on */
  uint32_t value;    /* of one that blends */
} mmverify_hit_t;

/* What a ray met.  `size` bytes of it are there, as of mmverify_bake_case. */
typedef struct mmverify_blend_case {
  uint32_t size;              /* sizeof(mmverify_blend_case) */
  uint32_t operation;         /* MMVERIFY_BLEND_MAX, ... */
  uint32_t payload;           /* before any hit */
  uint32_t count;             /* hits, up to 16 */
  const mmverify_hit_t* hits; /* in the order in which they are met, which is none by distance */
} mmverify_blend_case_t;

/* What codes of attributes mean, and so what is averaged; see attribute_bake_vertices. */
#define MMVERIFY_LINEAR 0u
#define MMVERIFY_SRGB 1u
#define MMVERIFY_NORMAL 2u
#define MMVERIFY_NORMAL_AND_LENGTH 3u

/* What is baked. */
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

/* One base triangle on one texture's alpha.  `size` bytes of it are there; later headers add at its end, and
 * a subject that is asked for a case that it does not know whole declines it. */
typedef struct mmverify_bake_case {
  uint32_t size;   /* sizeof(mmverify_bake_case) */
  uint32_t level;  /* 4^level micro-triangles, up to 12 */
  uint32_t format; /* MMVERIFY_2_STATE or MMVERIFY_4_STATE */

  uint32_t width, height; /* of mip 0; of mip k max(1, width >> k) and max(1, height >> k) */
  uint32_t mips;          /* 1 or more, up to the one of 1 x 1 texel */
  uint32_t texel;         /* MMVERIFY_UNORM8, ... */
  uint32_t border;    /* the texel outside with MMVERIFY_CLAMP_TO_BORDER, by its bits; no other bit is set */
  const void* texels; /* rows from the top, without gaps, mip after mip; aligned as one texel asks for it */

  uint32_t filter, wrap_u, wrap_v; /* Vulkan's; texel (i, j) has its centre at (i + 1/2, j + 1/2) */
  float factor, vertex_factor;     /* alpha is what is sampled, times both; none below 0 */
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

/* What a baker declares of its rules. */
#define MMVERIFY_OPAQUE_FROM_CUTOFF 0u  /* MASK: opaque where alpha >= cutoff */
#define MMVERIFY_OPAQUE_ABOVE_CUTOFF 1u /* MASK: opaque where alpha > cutoff */
#define MMVERIFY_CLOSED_MICRO_TRIANGLES 0u
#define MMVERIFY_OPEN_MICRO_TRIANGLES 1u /* what meets a micro-triangle in an area of 0 does not count */
#define MMVERIFY_UNKNOWN_ANY 0u          /* nothing is said of which unknown it is */
#define MMVERIFY_UNKNOWN_BY_CENTROID 1u  /* as the flag MMVERIFY_BAKE_CENTROID says it */
#define MMVERIFY_UNKNOWN_BY_COVERAGE 2u  /* UO where most of the area is opaque; not judged */
#define MMVERIFY_UNKNOWN_OPAQUE 3u       /* all are UO */
#define MMVERIFY_UNKNOWN_TRANSPARENT 4u  /* all are UT */
/* restrictions */
#define MMVERIFY_BAKE_SAME_WRAPS 1u     /* wrap_u is wrap_v */
#define MMVERIFY_BAKE_POWERS_OF_TWO 2u  /* width and height are */
#define MMVERIFY_BAKE_NO_FACTORS 4u     /* both factors are 1 */
#define MMVERIFY_BAKE_NO_MARGIN 8u      /* margin is 0 */
#define MMVERIFY_BAKE_FLOAT_CUTOFFS 16u /* a cutoff is a number of binary32 in [0, 1] */
/* What a baker supports. Cases are drawn inside it, and states are judged by its rules. A field that is 0 says
 * the most general thing; a subject built against a shorter header has zeros for the rest. Sets have bit
 * 1 << VALUE for each value that is supported; 0 is all of them. */
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
  float fixed_cutoff;    /* of MASK; 0: any. Then the case's cutoff is this number */
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

/* One base triangle on a texture of attributes, or on one mip of it.  `size` bytes of it are there, as of
 * mmverify_bake_case. */
typedef struct mmverify_attribute_case {
  uint32_t size;                   /* sizeof(mmverify_attribute_case) */
  uint32_t level;                  /* up to 12 */
  uint32_t width, height;          /* in texels */
  const void* texels;              /* R G B A each, rows from the top, without gaps; at any address */
  uint32_t texel;                  /* MMVERIFY_UNORM8: a byte a channel; others may follow */
  uint32_t border[4];              /* R G B A outside with MMVERIFY_CLAMP_TO_BORDER, each a code */
  uint32_t filter, wrap_u, wrap_v; /* as of mmverify_bake_case; the filter is that of vertices */
  uint32_t meaning;                /* MMVERIFY_LINEAR, ... */
  float uv[6];                     /* as of mmverify_bake_case */
} mmverify_attribute_case_t;

/* What a baker of attributes supports; fields that are 0, and sets, as of mmverify_bake_support. */
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
#define MMVERIFY_INDEX_IN_CLUSTER 8u /* with any of these, of array_resolve: -5 is no micromap */
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

/* What an array is built of.  `size` bytes of it are there, as of mmverify_bake_case. */
typedef struct mmverify_array_case {
  uint32_t size;       /* sizeof(mmverify_array_case) */
  uint32_t api;        /* MMVERIFY_ARRAY_EXT, ... */
  uint32_t index_type; /* MMVERIFY_INDEX_U8, ..., one that the API takes */
  uint32_t base_triangle;
  uint32_t flags; /* MMVERIFY_ARRAY_SPECIAL, MMVERIFY_ARRAY_SHARE */
  uint32_t
      bound; /* of near-duplicate merging: micro-triangles of each triangle that may become unknown; 0: none */
  uint32_t
      before; /* so many of the triangles, the first ones, are records already, one each; base_triangle is no more */
  uint32_t count; /* of all triangles */
  const mmverify_array_triangle_t* triangles;
  const uint8_t* maps; /* packed as maps are, the bits after the last state zero; at any byte */
} mmverify_array_case_t;

/* What an answer of array_build begins with.  Without gaps follow: the records, 8 bytes each; the array's usage counts, and
 * the geometry's, three words each: count, level, format; the indices; the data. */
typedef struct mmverify_array_answer {
  uint32_t records, array_counts, geometry_counts; /* how many there are */
  uint32_t index_bytes, data_bytes;
} mmverify_array_answer_t;

/* An array and its geometries as bytes, which changes and files are asked about.  Without gaps, little-endian: this; an
 * mmverify_array_geometry for each geometry; the records, 8 bytes each; each geometry's indices; the data. */
typedef struct mmverify_array_parts {
  uint32_t records, data_bytes, geometries;
} mmverify_array_parts_t;

/* A geometry of such an array: its indices, one for each triangle, are read from its own base on. */
typedef struct mmverify_array_geometry {
  uint32_t index_type; /* MMVERIFY_INDEX_U8, ... */
  uint32_t base_triangle, triangles;
} mmverify_array_geometry_t;

/* What a subject is: its name, its limits, its entry points. */
typedef struct mmverify_subject {
  uint32_t abi;     /* MMVERIFY_SUBJECT_ABI */
  uint32_t size;    /* sizeof(mmverify_subject) */
  const char* name; /* for messages; may be null */
  /* The highest level it is defined at: of indices and attribute maps up to 16, of trees up to 12. Maps to maps go to 12
   * whatever it says; bakers say theirs in bake_support and attribute_support. */
  uint32_t max_level;
  uint32_t flags;

  /* Index of the micro-triangle that holds (u[k], v[k]), as VK_EXT_opacity_micromap has it: u belongs to the
   * second vertex, v to the third. u, v >= 0, -0 is 0; u+v <= 1, or up to 2^-23 over, as hits on the hypotenuse come: such
   * a point is in the last micro-triangle of the row that holds v. */
  void (*index_f32)(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);
  void (*index_f64)(uint32_t level, const double* u, const double* v, uint32_t* index, size_t count);

  /* Corners of the micro-triangle that carries index[k] < 4^level: i0 j0 i1 j1 i2 j2, in units of 1/2^level
   * along u and v. Their order matters where `flags` declares one. MMVERIFY_CORNERS_BASE_U_V: the base is the
   * corner from which the other two lie along u and along v; the steps are +1, in inverted ones -1. */
  void (*corners)(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

  /* The same two in row order (Gruen et al.; Color and Attribute Micromaps, figure 4): a point on an edge belongs where
   * that figure's rows, columns and diagonals put it, floor((1-w)N), floor(vN), floor((1-u)N) of exact numbers, w = 1-u-v,
   * each N-1 at most and the column no greater than the row. Points are those of index_f32. Corners come in any order. */
  void (*row_index_f32)(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);
  void (*row_corners)(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

  /* Maps and codes. A map of level n and format b is 4^n states of b bits in the order of the index, packed
   * from the least significant bit of each byte on: ceil(4^n b / 8) bytes, the bits after the last state
   * zero. States are T 0, O 1, UT 2, UO 3; a map in 2-state has the first two.
   *   - Bytes may lie at any address. No byte outside a buffer's size is read or written.
   *   - A subject built against a header without these has a smaller `size`, and is asked for none of them.
   *
   * With the flag MMVERIFY_TREE_STREAM the codes are those of Succinct Opacity Micromaps, Algorithms 1 and 2:
   * the tree's bits in pre-order, 1 internal and 0 leaf, child 0 first, then from the next whole byte on the
   * leaves' states in the same order; both packed like maps, the bits after the last zero. Then any of the
   * four may stand alone: the specification encodes for a subject without tree_encode and decodes for one
   * without tree_decode. Without the flag tree_encode must be there, and a way back: tree_decode or a lookup.
   */

  /* The size of the map's code, which is 1 or more; 0 if there is none, which is a wrong answer. The code is
   * written if `capacity` is at least its size; otherwise what lies in the buffer does not count, and the
   * call comes again with the room that it asked for. One map has one code. */
  size_t (*tree_encode)(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code, size_t capacity);

  /* Nonzero if the code is a map's code of this level and format, and then writes the map. Otherwise 0, and
   * what lies in `map` does not count. `code` may be anything: cut short, 0 bytes, one bit flipped. */
  int (*tree_decode)(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size, uint8_t* map);

  /* The states at index[k] < 4^level, and at the barycentrics (u[k], v[k]) as index_f32 gets them. One byte a
   * state. `code` is a whole code, as tree_encode gives it. */
  void (*tree_lookup)(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size,
                      const uint32_t* index, uint8_t* state, size_t count);
  void (*tree_lookup_f32)(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size,
                          const float* u, const float* v, uint8_t* state, size_t count);

  /* Maps to maps. Here the bits after the last state may be anything in what is given, and must be zero in
   * what is written. All write the whole of their output. Level and format are those of the input;
   * levels go up to 12. */

  /* `count` states, one byte each, to a map, and back. */
  void (*micromap_pack)(uint32_t format, const uint8_t* states, size_t count, uint8_t* map);
  void (*micromap_unpack)(uint32_t format, const uint8_t* map, size_t count, uint8_t* states);

  /* 4-state to 2-state: T and UT to T, O and UO to O; and 2-state as 4-state. */
  void (*micromap_force2)(uint32_t level, const uint8_t* four_state, uint8_t* two_state);
  void (*micromap_widen)(uint32_t level, const uint8_t* two_state, uint8_t* four_state);

  /* The map of level + 1 in which four children have their parent's state, and of level - 1 in which a parent
   * is T or O if its children all are, otherwise, in 4-state, UO where two or more are O or UO, else UT; in
   * 2-state O where two or more are. Level 0 has no level below, and is not asked. */
  void (*micromap_up)(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* above);
  void (*micromap_down)(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* below);

  /* A 4-state map through one bit a state and back: mode 0 tells O and UO from the rest (T and O come back),
   * mode 1 T from the rest (T and an unknown, either one), mode 2 O from the rest (O and an unknown, either one). */
  void (*micromap_through)(uint32_t level, uint32_t mode, const uint8_t* four_state, uint8_t* out);

  /* What is left of a 4-state map after a lossy codec: encoded and decoded.  Which states may stand for which the laws
   * lossy.allowed, lossy.conservative and lossy.force2_stable say; a codec need not keep all three.  One map has one answer,
   * whatever the bits after its last state. */
  void (*micromap_substitute)(uint32_t level, const uint8_t* four_state, uint8_t* out);

  /* Square opacity maps and blocks of them (Compressed Opacity Maps): VQ2, 16x16 regions in 32 bytes, and
   * VQ4, 32x32 in 64. A map has a byte a region, T 0, C 1, O 2, region (x, y) at x + 16 y or x + 32 y: x from
   * the left, y from the BOTTOM. The order of a block's bits, which the paper does not say, is that of
   * docs/VQ.md.
   *   - Every block is one. A decoder writes the whole map; `region` gives the states at (x[k], y[k]), each
   *     below 16 or 32.
   *   - An encoder takes every map, O beside T included, and writes a whole block; one map has one block. It promises that
   *     what it writes is conservative: T and O stay or become C, and C stays. How much it keeps it promises with
   *     MMVERIFY_VQ_KEEPS alone, for all its encoders: then a map that some block holds whole is held whole, however few
   *     of the entries it needs. Without that flag nothing is asked of how much is kept.
   *   - Each stands alone: what the block of an encoder means is found by the specification.
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
   * if the subject does not support the case, and then what lies in `map` does not count. Cases that it
   * declines are counted and never held for right.
   *   - O: alpha, as it is sampled, is opaque on the whole closed micro-triangle, and in each mip.
   *     MASK: alpha >= cutoff; BLEND: alpha >= 1.
   *   - T: transparent on all of it. MASK: alpha < cutoff; BLEND: alpha <= 0.
   *   - Anything may be unknown; how much of it has to be is for the law bake.tight to say.
   *   - Alpha is not clamped to [0, 1]: factors and texels of binary32 may take it beyond.  All numbers are finite.  With
   *     BLEND the cutoff says nothing.
   *   - MMVERIFY_NEAREST: the texel at (floor(x), floor(y)), x and y in texels.  A point on the line between two is the
   *     second one's, and an edge that lies on the line has such points.
   *   - With the flag MMVERIFY_BAKE_CENTROID, or MMVERIFY_UNKNOWN_BY_CENTROID in what it supports, an unknown one is UO
   *     where alpha at its centroid, without margin and in mip 0, is >= cutoff (BLEND: >= 1/2), else UT.
   *   - A map in 2-state has O for O and UO of the one in 4-state, T for T and UT, by whichever rule a baker tells its
   *     unknown ones apart. */
  int (*bake)(const mmverify_bake_case_t* what, uint8_t* map);

  /* What it supports; null: all, and what it does not it declines, case by case. */
  const mmverify_bake_support_t* bake_support;

  /* Attribute micromaps (Color and Attribute Micromaps, 3.1): where values lie in a map of a level n up to 16, N = 2^n.
   * Micro-vertex (i, j) is i steps along u and j along v, i + j <= N.  Micro-triangle (iu, iv, upper) is half of the
   * grid square with the corner (iu, iv): upper 0 the half at that corner, upper 1 the other, iu + iv + upper < N.
   *   - Orders of vertices, V(n) = (N+1)(N+2)/2 of them.  W-minor: r(r+1)/2 + j, r = i+j.  U-major: i(N+2) - i(i+1)/2 + j.
   *     Bird: the corners w, u, v are 0, 1, 2; then each level m adds three vertices for each upright micro-triangle of
   *     level m-1, in the order of the curve: those of its edges w-v, u-v and w-u.
   *   - Orders of faces, 4^n of them.  Curve: that of index_f32.  Rows: r^2 + 2 iv + upper, r = iu+iv+upper.  U-major:
   *     4^n - (N-iu)^2 + 2 iv + upper.
   *   - All three orders are asked of whoever has an entry point with an order. */

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

  /* And back: the face whose three vertices are first[k], second[k], third[k], in that order. */
  void (*attribute_face_of)(uint32_t level, uint32_t vertex_order, uint32_t face_order, const uint32_t* first,
                            const uint32_t* second, const uint32_t* third, uint32_t* face, size_t count);

  /* The vertices of the micro-triangle that holds (u[k], v[k]), ties as of index_f32, and the point's weights there, in the
   * order of its vertices: with fu = uN - iu and fv = vN - iv, lower (1-fu-fv, fu, fv), upper (fu+fv-1, 1-fu, 1-fv).
   * Each weight is within 2^-24 of the exact one and none is below 0.  Where 4uN and 4vN are whole numbers, the weights are
   * the exact ones, which binary32 holds: so neighbours agree on their edge.  u, v >= 0, -0 is 0; u+v <= 1. */
  void (*attribute_triplet_f32)(uint32_t level, uint32_t vertex_order, const float* u, const float* v,
                                uint32_t* vertices, size_t count);
  void (*attribute_weights_f32)(uint32_t level, const float* u, const float* v, float* weights, size_t count);

  /* The vertex (i, j) that the value of (i[k], j[k]) is read from where the edges of `flags` (MMVERIFY_EDGE_W_U, ...) have a
   * neighbour of level n-1, of none at level 0: i0 j0 i1 j1 ...  An odd vertex of such an edge goes to an even neighbour on it,
   * any other one stays, and which of the two it is leaves no crack and turns no micro-triangle over. */
  void (*attribute_decimate)(uint32_t level, uint32_t flags, const uint32_t* i, const uint32_t* j,
                             uint32_t* place, size_t count);

  /* The faces of the level below in the order of the curve, from bytes R G B A each: byte by byte the mean of the faces
   * 4k to 4k+3.  With s their sum, HALF_UP floor((s+2)/4); HALF_TO_EVEN to the nearest, halves to the even one; TRUNCATE
   * floor(s/4); HALVES_UP h(h(a,b), h(c,d)), h(x,y) = floor((x+y+1)/2).  `children` are 16 bytes a parent. */
  void (*attribute_face_mip)(uint32_t rounding, const uint8_t* children, size_t parents, uint8_t* out);

  /* Maps of attributes from a texture (Color and Attribute Micromaps, 5.1): bytes R G B A for each micro-triangle in the
   * order of the curve, and for each micro-vertex in W-minor order.  Nonzero if it is baked; 0 if the subject does not
   * support the case, and then what lies in `map` does not count.
   *   - Faces: the mean of the texels under the micro-triangle, each by its share of the area.  Along a segment texels
   *     weigh by how much of the micro-triangle maps to them, and a point has its own: the limits of triangles with an area.
   *   - Vertices: what the filter gives at the micro-vertex.
   *   - Means are of codes with MMVERIFY_LINEAR.  MMVERIFY_SRGB has R, G and B on the sRGB curve and averages light.
   *     MMVERIFY_NORMAL has directions 2 code / 255 - 1, whose mean is made one unit long again; MMVERIFY_NORMAL_AND_LENGTH
   *     the same, and in the place of alpha the mean's own length, 1 at most.  Texels are averaged as they are stored, and
   *     one texel alone is made one unit long, too.  Alpha is linear.  A mean without a direction is (0, 0, 1).
   *   - A code is the one nearest to the number, of two the greater. */
  int (*attribute_bake_faces)(const mmverify_attribute_case_t* what, uint8_t* map);
  int (*attribute_bake_vertices)(const mmverify_attribute_case_t* what, uint8_t* map);

  /* What these two support; null: all, and what they do not they decline, case by case. */
  const mmverify_attribute_support_t* attribute_support;

  /* What traversal does with a candidate hit on a triangle before any shader runs: a byte each, MMVERIFY_IGNORED, ...
   *   - candidate[k]: the state that was read, T 0, O 1, UT 2, UO 3, after any lossy substitution, with
   *     MMVERIFY_CANDIDATE_HAS_MICROMAP where a micromap or a special index gave it (else the state is 0), and
   *     MMVERIFY_CANDIDATE_GEOMETRY_OPAQUE where the geometry was built so.
   *   - instance_flags[k] has Vulkan's and DXR's numbers: FORCE_OPAQUE 4, FORCE_NO_OPAQUE 8, force-2-state 16, micromaps
   *     disabled 32.  ray_flags[k] has SPIR-V's and DXR's: Opaque 1, NoOpaque 2, CullOpaque 64, CullNoOpaque 128,
   *     force-2-state 1024.  No other bit is set in any of them.
   *   - `api` is MMVERIFY_EXT_PIPELINE, ...; the pipeline, the shader or the RayQuery is set up for micromaps wherever there
   *     is one.  Combinations that no API defines are asked of nobody: docs/TRAVERSE.md names them. */
  void (*traverse_decide)(uint32_t api, const uint32_t* candidate, const uint32_t* instance_flags,
                          const uint32_t* ray_flags, uint8_t* outcome, size_t count);

  /* Where it runs, for whom that matters: lines KEY: VALUE, which are printed and kept with the verdicts, of 4000
   * bytes together.  May be null. */
  const char* runs_on;

  /* Fixed functions in traversal (Color and Attribute Micromaps, 4.3): out[k] is the payload payload[k] after a hit with
   * value[k], code by code, p of the payload, v of the value, alpha the value's own code A:
   *   MAX max(p, v); MIN min(p, v); ADD min(255, p + v); MULTIPLY p v / 255; OVER min(255, v + p (255 - alpha) / 255), of
   *   values with alpha multiplied in, or with any alpha.  A quotient is the code nearest to it; none lies halfway. */
  void (*traverse_blend)(uint32_t operation, const uint32_t* payload, const uint32_t* value, uint32_t* out,
                         size_t count);

  /* The payload that a ray ends with, as bytes R G B A.  The hits that blend are those nearer than the nearest accepted one,
   * whether that is met before them or after; one at its very distance does not blend.  Each blends as often as it is
   * reported, MULTIPLY and OVER in the order in which the hits are met. */
  void (*traverse_blend_hits)(const mmverify_blend_case_t* what, uint8_t* payload);

  /* The array of a geometry's triangles, behind the records that are there before: an mmverify_array_answer and what follows
   * it, little-endian. Its size is returned, as of tree_encode; 0 if an index does not fit its type, and for nothing else.
   *   - A record is u32 offset of its map in the data, u16 level, u16 format, as VkMicromapTriangleEXT. Those before come
   *     first and keep their maps; there is an index for each triangle after them, and records that nobody uses are none.
   *   - An index is its record less base_triangle; what shares is the maps from base_triangle on. A special index is -1 T,
   *     -2 O, -3 UT, -4 UO in the type's width, and base_triangle is no part of it.
   *   - Each triangle keeps its level and format, and resolves to what it was given as. With a bound T and O may be UT or UO
   *     in 4-state, in at most so many micro-triangles of each triangle; nothing else may change. Nothing has to be merged.
   *   - The array's usage counts are its records' by level and format; the geometry's, of EXT, OptiX and NVAPI, those of its
   *     triangles' records, special indices left out; other APIs have none. In any order. */
  size_t (*array_build)(const mmverify_array_case_t* what, uint8_t* answer, size_t capacity);

  /* What code[k] < 2^width means to a geometry with base_triangle[k], over records[k] records: two numbers each, what it is
   * and which. MMVERIFY_TARGET_SPECIAL and the state; _NONE and 0: -5 in a cluster; _RECORD and its number, base added;
   * _OUTSIDE and 0: no such record, and a signed code below the special ones. */
  void (*array_resolve)(uint32_t index_type, const uint32_t* code, const uint32_t* base_triangle,
                        const uint32_t* records, uint32_t* target, size_t count);

  /* Arrays that are there, changed: each triangle of each geometry resolves as before.  The bytes of the array, and of what
   * becomes of it, as mmverify_array_parts has them; the size is returned, as of tree_encode.  Every plain index names a
   * record, every record's bytes lie in the data.
   *   compact      without the records that nobody refers to and the bytes of no record
   *   reorder      all records, those in use first, in the order of their first use
   *   concatenate  two arrays, whose bytes follow each other: the first's records and geometries, then the second's
   * The data that compact and reorder leave has no gaps and no bytes behind. */
  size_t (*array_compact)(const uint8_t* array, size_t array_size, uint8_t* changed, size_t capacity);
  size_t (*array_reorder)(const uint8_t* array, size_t array_size, uint8_t* changed, size_t capacity);
  size_t (*array_concatenate)(const uint8_t* arrays, size_t arrays_size, uint8_t* changed, size_t capacity);

  /* An array as a file of a version, 1 or 2, and the array of a file again, as mmverify_array_parts has it; sizes as of
   * tree_encode.  Version 2 holds every array; 0 if version 1 does not hold this one, and for bytes that are no file.
   *   - Any form of file will do; what is saved in a version is loaded as it was.  With the flag MMVERIFY_ARRAY_FILES files
   *     are docs/ARRAYS.md's, byte by byte, and array_load refuses other bytes: cut short, one bit flipped, 0 bytes.  A file
   *     whose indices or records make no array ("Files" there says which) it may load as it is, or refuse. */
  size_t (*array_save)(uint32_t version, const uint8_t* array, size_t array_size, uint8_t* file,
                       size_t capacity);
  size_t (*array_load)(const uint8_t* file, size_t file_size, uint8_t* array, size_t capacity);

  /* The 4-state map at level most < level that stands for one that a device has no level for (KHR, lossy micromaps): T for
   * a block of T alone, O for one of O, UT or UO for any other. */
  size_t (*array_emulate)(uint32_t level, uint32_t most, const uint8_t* map, uint8_t* emulated,
                          size_t capacity);

  /* The maps of a scene in one graph, or in whatever form a codec of many maps has.
   *   - A scene is maps of one format, one after another: a byte with the level, 0 to 12, then the map, packed, its bits after
   *     the last state zero.  Maps are numbered from 0 in that order.
   *   - Any form of code will do, as long as a scene has one.  With the flag MMVERIFY_DAG_CONTAINER the codes are the
   *     containers of docs/DAG.md.
   *   - dag_encode has to be there, and a way back: dag_decode or a lookup.
   */

  /* The size of the scene's code, and the code, as of tree_encode. */
  size_t (*dag_encode)(uint32_t format, const uint8_t* scene, size_t scene_size, uint8_t* code,
                       size_t capacity);

  /* The size of the scene of a code, and the scene, likewise; 0 if no scene has that code, which may be anything: cut short,
   * 0 bytes, one bit flipped.  Of a form of its own nobody else can tell: 0 or a scene, the same one at each call. */
  size_t (*dag_decode)(uint32_t format, const uint8_t* code, size_t code_size, uint8_t* scene,
                       size_t capacity);

  /* The states at index[k] < 4^level of map[k], and at the barycentrics (u[k], v[k]) as index_f32 gets them.  One byte a
   * state.  `code` is a whole code, as dag_encode gives it. */
  void (*dag_lookup)(uint32_t format, const uint8_t* code, size_t code_size, const uint32_t* map,
                     const uint32_t* index, uint8_t* state, size_t count);
  void (*dag_lookup_f32)(uint32_t format, const uint8_t* code, size_t code_size, const uint32_t* map,
                         const float* u, const float* v, uint8_t* state, size_t count);
} mmverify_subject_t;

/* The one exported symbol. The result must stay valid for the life of the process; null is an error. */
const mmverify_subject_t* mmverify_subject_v1(void);

/* A library that can run in some places only may export this as well. It is asked where mmverify_subject_v1 returned
 * null: why it cannot run here, "no Vulkan device" for example. Its laws are then not_applicable for that reason. */
const char* mmverify_subject_v1_not_here(void);

#ifdef __cplusplus
}
#endif

#endif
