/* The library for C, and for all languages that call C.  Installed as <mmverify/mmverify.h>.
 *
 * Functions that can fail return 1 on success, and 0 on failure: an argument outside its domain, or no memory.
 * mmverify_error() then gives the reason.  A failed call writes nothing, and nothing is thrown.  All functions may
 * be called from several threads at once; none starts a thread.  Memory is allocated by functions that make a
 * tree, a baker, an array or a code, by failures, and by mmverify_bake with several mip levels.
 *
 * Levels are 0..16 of indices, 0..12 of maps.  A map of level n and format b is 4^n states of b bits in the
 * order of the index, packed from the least significant bit of each byte on: ceil(4^n b / 8) bytes, the bits
 * after the last state zero.  States are T 0, O 1, UT 2, UO 3.
 */
#ifndef MMVERIFY_H
#define MMVERIFY_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Formats of maps, as Vulkan numbers them; also the bits of one state. */
enum { MMVERIFY_FORMAT_2_STATE = 1, MMVERIFY_FORMAT_4_STATE = 2 };

/* The reason of this thread's last failed call; "" before the first.  Valid until its next call. */
const char* mmverify_error(void);

/* index[k]: the micro-triangle that contains the barycentrics (u[k], v[k]) of the second and third vertex.
 * Source: Vulkan, VK_EXT_opacity_micromap, "Reference Code"; exact for all finite floats in the triangle.
 * Law: index.equals_reference, index.exact_on_floats */
int mmverify_index(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);

/* corners[6 k .. 6 k + 5]: the corners i0 j0 i1 j1 i2 j2 of micro-triangle index[k] < 4^level, in units of 1/2^level
 * along u and v. Corner 0, 1, 2 is the one that child 0, 2, 3 touches.
 * Law: index.corners, index.corner_order */
int mmverify_corners(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

/* The two functions above in row order.  Source: Color and Attribute Micromaps, figure 4.
 * Law: index.row_order, index.row_corners */
int mmverify_row_index(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);
int mmverify_row_corners(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

/* Packs `count` states, a byte each, to ceil(count b / 8) bytes, and unpacks them.
 * Law: micromap.packing */
int mmverify_pack(uint32_t format, const uint8_t* states, size_t count, uint8_t* map);
int mmverify_unpack(uint32_t format, const uint8_t* map, size_t count, uint8_t* states);

/* Force-2: the 2-state map of a 4-state map; T and UT become T, O and UO become O. Widen: a 2-state map as a 4-state
 * map.
 * Law: micromap.force2 */
int mmverify_force2(uint32_t level, const uint8_t* four_state, uint8_t* two_state);
int mmverify_widen(uint32_t level, const uint8_t* two_state, uint8_t* four_state);

/* Up: the map of level + 1, in which each child has its parent's state. Down: the map of level - 1. There a 4-state
 * parent is T or O if all its children are, else unknown; a 2-state parent is O if two of them are (docs/MICROMAP.md).
 * Law: micromap.up, micromap.down */
int mmverify_map_up(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* above);
int mmverify_map_down(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* below);

/* The code of a map: the tree's bits, then from the next whole byte on its leaves' states.  Returns the size of the
 * code, or 0 on failure; the code is written if `capacity` is at least its size.
 * Source: Succinct Opacity Micromaps, Algorithms 1 and 2.
 * Law: tree.equals_spec */
size_t mmverify_tree_encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code,
                            size_t capacity);

/* A map in the form for lookups, in memory of its own.  Null on failure. */
typedef struct mmverify_tree mmverify_tree;
mmverify_tree* mmverify_tree_new(uint32_t level, uint32_t format, const uint8_t* map);
void mmverify_tree_free(mmverify_tree* tree);
/* state[k]: the state at index[k] < 4^level.
 * Law: tree.lookup_is_decode */
int mmverify_tree_lookup(const mmverify_tree* tree, const uint32_t* index, uint8_t* state, size_t count);
int mmverify_tree_decode(const mmverify_tree* tree, uint8_t* map);

/* Square maps: a byte a region, T 0, C 1, O 2, region (x, y) at x + 16 y or x + 32 y, y from the bottom; blocks
 * of VQ2 have 32 bytes, of VQ4 64 (docs/VQ.md).  Any bytes are a block; an encoder takes any map.
 * Law: vq2.region_is_map, vq4.region_is_map, vq2.conservative */
int mmverify_vq2_decode(const uint8_t* block, uint8_t* map);
int mmverify_vq4_decode(const uint8_t* block, uint8_t* map);
int mmverify_vq2_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                        size_t count);
int mmverify_vq4_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                        size_t count);
int mmverify_vq2_encode(const uint8_t* map, uint8_t* block);
int mmverify_vq4_encode(const uint8_t* map, uint8_t* block);

/* The texels, filters and wrap modes of a baker. */
enum { MMVERIFY_TEXEL_UNORM8 = 1, MMVERIFY_TEXEL_UNORM16 = 2, MMVERIFY_TEXEL_FLOAT32 = 3 };
enum { MMVERIFY_FILTER_BILINEAR = 0, MMVERIFY_FILTER_NEAREST = 1 };
enum {
  MMVERIFY_WRAP_REPEAT = 0,
  MMVERIFY_WRAP_MIRRORED_REPEAT = 1,
  MMVERIFY_WRAP_CLAMP_TO_EDGE = 2,
  MMVERIFY_WRAP_CLAMP_TO_BORDER = 3,
  MMVERIFY_WRAP_MIRROR_CLAMP_TO_EDGE = 4
};

/* One mip level of a texture's alpha: texel (x, y) at x + width y. */
typedef struct mmverify_texture {
  const void* texels;
  uint32_t width, height;
} mmverify_texture;

/* One mip level of interleaved pixels of 8 bits a channel: alpha of texel (x, y) at pitch y + channels x + channel.
 * Alpha is linear in sRGB formats, too. */
typedef struct mmverify_pixels {
  const uint8_t* bytes;
  uint32_t width, height;
  size_t pitch;               /* in bytes, at least channels width */
  uint32_t channels, channel; /* at most 16; RGBA8 has 4, and alpha in channel 3 */
} mmverify_pixels;

/* Formats of blocks of 4 x 4 texels.  BC4 is a mask of one channel, UNORM.  BC1 is the format with alpha.  sRGB formats have
 * the same alpha. */
enum {
  MMVERIFY_BLOCKS_BC1 = 1,
  MMVERIFY_BLOCKS_BC2 = 2,
  MMVERIFY_BLOCKS_BC3 = 3,
  MMVERIFY_BLOCKS_BC4 = 4,
  MMVERIFY_BLOCKS_BC7 = 7
};
/* One mip level of blocks of 4 x 4 texels, row by row: block (i, j) at pitch j + size i, size 8 bytes in BC1 and BC4, 16 in
 * the others. */
typedef struct mmverify_blocks {
  uint32_t format;
  const uint8_t* bytes;
  uint32_t width, height; /* in texels; sides that are no multiples of four round up to whole blocks */
  size_t pitch;           /* in bytes, from one row of blocks to the next */
} mmverify_blocks;

/* The sampling of a texture, and the rule by which alpha is opaque. */
typedef struct mmverify_sampling {
  uint32_t texel;                  /* MMVERIFY_TEXEL_UNORM8, ... */
  uint32_t filter, wrap_u, wrap_v; /* Vulkan's; texel (i, j) has its centre at (i + 1/2, j + 1/2) */
  float border;                    /* stored number, for MMVERIFY_WRAP_CLAMP_TO_BORDER */
  float factor, vertex_factor;     /* sampled alpha times both: 1 in both for none; 0 in one makes all T */
  uint32_t blend; /* 0: alpha >= the cutoff is opaque; else alpha >= 1 is opaque, alpha <= 0 transparent */
  uint32_t cutoff_numerator, cutoff_denominator;
  float margin; /* texels by which each micro-triangle is grown to either side along x and y */
} mmverify_sampling;

/* Mip levels in the order in which they are sampled, the largest first.  The texels must outlive the baker; of pixels it
 * copies the channel, and their sampling's texel is MMVERIFY_TEXEL_UNORM8; of blocks it keeps the alpha, and the texel
 * is MMVERIFY_TEXEL_UNORM16.  Null on failure. */
typedef struct mmverify_baker mmverify_baker;
mmverify_baker* mmverify_baker_new(const mmverify_texture* mips, size_t count,
                                   const mmverify_sampling* sampling);
mmverify_baker* mmverify_baker_of_pixels(const mmverify_pixels* mips, size_t count,
                                         const mmverify_sampling* sampling);
mmverify_baker* mmverify_baker_of_blocks(const mmverify_blocks* mips, size_t count,
                                         const mmverify_sampling* sampling);
void mmverify_baker_free(mmverify_baker* baker);
/* The 4-state map of the triangle with these texture coordinates, u and v of three vertices: O if alpha is opaque
 * on all of a closed micro-triangle in each mip, T if it is transparent on all of it in each mip; else unknown, UO or
 * UT by alpha at the centroid.  Exact.
 * Law: bake.conservative, bake.tight */
int mmverify_bake(const mmverify_baker* baker, const float* uv, uint32_t level, uint8_t* map);

/* level: the highest useful level of a triangle with these texture coordinates, the smallest at which no edge of a
 * micro-triangle is longer than a texel; at most limit, and at most 12.
 * Source: Succinct Opacity Micromaps, 3.1.1.
 * Test: impl_c_face_test */
int mmverify_useful_level(const float* uv, uint32_t width, uint32_t height, uint32_t limit, uint32_t* level);

/* A triangle's packed map. */
typedef struct mmverify_map {
  uint32_t level, format;
  const uint8_t* bytes;
} mmverify_map;

/* VkMicromapTriangleEXT, member by member. */
typedef struct mmverify_record {
  uint32_t offset;
  uint16_t level, format;
} mmverify_record;
/* VkMicromapUsageEXT, member by member: how many records, or triangles, have a level and a format. */
typedef struct mmverify_usage {
  uint32_t count, level, format;
} mmverify_usage;

/* The buffers of an array of micromaps and of the geometry that refers to it; they live as long as the array. */
typedef struct mmverify_buffers {
  const mmverify_record* records;
  size_t record_count;
  const uint8_t* data;
  size_t data_bytes;
  const void* indices; /* one a triangle, of index_bits; -1 to -4 are special indices */
  size_t index_count;
  const mmverify_usage* array_usage; /* how many records have each level and format */
  size_t array_usage_count;
  const mmverify_usage* geometry_usage; /* how many triangles refer to records of each level and format */
  size_t geometry_usage_count;
} mmverify_buffers;

/* The array of these maps, one a triangle.  A uniform map becomes a special index; equal maps share a record.
 * index_bits: 8, 16 or 32.  Null on failure.
 * Law: array.resolves, array.shares */
typedef struct mmverify_array mmverify_array;
mmverify_array* mmverify_array_new(const mmverify_map* maps, size_t count, uint32_t index_bits);
void mmverify_array_free(mmverify_array* array);
void mmverify_array_buffers(const mmverify_array* array, mmverify_buffers* buffers);

/* The counts of the triangles first to first + count - 1 that refer to records, by level and format, none of them zero:
 * VkMicromapUsageEXT of a geometry that takes these triangles' indices of a shared array.  found: how many
 * there are, 26 at most, two formats of 13 levels.  usage has room for capacity of them; where it is null, found alone is
 * written.
 * Test: impl_c_face_test */
int mmverify_array_geometry_counts(const mmverify_array* array, size_t first, size_t count,
                                   mmverify_usage* usage, size_t capacity, size_t* found);

/* state: that of the micro-triangle of a triangle that contains the barycentrics (u, v).
 * Test: impl_c_face_test */
int mmverify_array_state(const mmverify_array* array, size_t triangle, float u, float v, uint8_t* state);

#ifdef __cplusplus
}
#endif

#endif
