// The table of entry points.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "subjects/dock/signature.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::dock {

/// The topic whose laws call an entry point.
enum class Topic : std::uint32_t {
  index,
  tree,
  micromap,
  vq,
  bake,
  attribute,
  traverse,
  array,
  dag,
  subdivision
};

/// Bytes of a face's value in RGBA8.
constexpr std::size_t bytes_of_face = 4;

/// Two formats in one number, for calls that take two orders. Domain: each below formats_side.
constexpr std::uint32_t formats_side = 4;
constexpr std::uint32_t two_formats(std::uint32_t first, std::uint32_t second) {
  return first + formats_side * second;
}
/// The number of formats.
constexpr std::uint32_t formats = formats_side * formats_side;

// A row is ROW(name, topic, values, arguments), in the order of the header:
//   name       of the pointer in mmverify_subject_t;
//   values     the count of numbers in the answer for one element;
//   arguments  of the call, where `a` is the Arguments of subjects/dock/desk/arguments.hpp.
// The entry point's type in the header gives its arrays, its answer, and whether it takes a blob: see
// Signature.
// clang-format off
#define MMVERIFY_ENTRY_POINTS(ROW)                                                                                    \
  ROW(index_f32,           index,    1, (a.level, a.floats(0), a.floats(1), a.numbers(), a.count))                    \
  ROW(index_f64,           index,    1, (a.level, a.doubles(0), a.doubles(1), a.numbers(), a.count))                  \
  ROW(corners,             index,    6, (a.level, a.words(0), a.numbers(), a.count))                                  \
  ROW(row_index_f32,       index,    1, (a.level, a.floats(0), a.floats(1), a.numbers(), a.count))                    \
  ROW(row_corners,         index,    6, (a.level, a.words(0), a.numbers(), a.count))                                  \
  ROW(tree_encode,         tree,     1, (a.level, a.format, a.blob, a.bytes(), a.room))                               \
  ROW(tree_decode,         tree,     1, (a.level, a.format, a.blob, a.blob_bytes, a.bytes()))                         \
  ROW(tree_lookup,         tree,     1, (a.level, a.format, a.blob, a.blob_bytes, a.words(0), a.bytes(), a.count))    \
  ROW(tree_lookup_f32,     tree,     1,                                                                               \
      (a.level, a.format, a.blob, a.blob_bytes, a.floats(0), a.floats(1), a.bytes(), a.count))                        \
  ROW(micromap_pack,       micromap, 1, (a.format, a.blob, a.blob_bytes, a.bytes()))                                  \
  ROW(micromap_unpack,     micromap, 1, (a.format, a.blob, a.room, a.bytes()))                                        \
  ROW(micromap_force2,     micromap, 1, (a.level, a.blob, a.bytes()))                                                 \
  ROW(micromap_widen,      micromap, 1, (a.level, a.blob, a.bytes()))                                                 \
  ROW(micromap_up,         micromap, 1, (a.level, a.format, a.blob, a.bytes()))                                       \
  ROW(micromap_down,       micromap, 1, (a.level, a.format, a.blob, a.bytes()))                                       \
  ROW(micromap_through,    micromap, 1, (a.level, a.format, a.blob, a.bytes()))                                       \
  ROW(micromap_substitute, micromap, 1, (a.level, a.blob, a.bytes()))                                                 \
  ROW(vq2_decode,          vq,       1, (a.blob, a.bytes()))                                                          \
  ROW(vq2_region,          vq,       1, (a.blob, a.words(0), a.words(1), a.bytes(), a.count))                         \
  ROW(vq2_encode,          vq,       1, (a.blob, a.bytes()))                                                          \
  ROW(vq4_decode,          vq,       1, (a.blob, a.bytes()))                                                          \
  ROW(vq4_region,          vq,       1, (a.blob, a.words(0), a.words(1), a.bytes(), a.count))                         \
  ROW(vq4_encode,          vq,       1, (a.blob, a.bytes()))                                                          \
  ROW(bake,                bake,     1, (CaseOf<mmverify_bake_case_t>(a), a.bytes()))                                 \
  ROW(attribute_vertex_index, attribute, 1, (a.level, a.format, a.words(0), a.words(1), a.numbers(), a.count))        \
  ROW(attribute_vertex_place, attribute, 2, (a.level, a.format, a.words(0), a.numbers(), a.count))                    \
  ROW(attribute_face_index, attribute, 1,                                                                             \
      (a.level, a.format, a.words(0), a.words(1), a.words(2), a.numbers(), a.count))                                  \
  ROW(attribute_face_place, attribute, 3, (a.level, a.format, a.words(0), a.numbers(), a.count))                      \
  ROW(attribute_triplet,   attribute, 3, (a.level, a.first(), a.second(), a.words(0), a.numbers(), a.count))          \
  ROW(attribute_face_of,   attribute, 1,                                                                              \
      (a.level, a.first(), a.second(), a.words(0), a.words(1), a.words(2), a.numbers(), a.count))                     \
  ROW(attribute_triplet_f32, attribute, 3, (a.level, a.format, a.floats(0), a.floats(1), a.numbers(), a.count))       \
  ROW(attribute_weights_f32, attribute, 3, (a.level, a.floats(0), a.floats(1), a.weights(), a.count))                 \
  ROW(attribute_decimate,  attribute, 2, (a.level, a.format, a.words(0), a.words(1), a.numbers(), a.count))           \
  ROW(attribute_face_mip,  attribute, 1, (a.format, a.blob, a.room / bytes_of_face, a.bytes()))                       \
  ROW(attribute_bake_faces, attribute, 1, (CaseOf<mmverify_attribute_case_t>(a), a.bytes()))                          \
  ROW(attribute_bake_vertices, attribute, 1, (CaseOf<mmverify_attribute_case_t>(a), a.bytes()))                       \
  ROW(traverse_decide,     traverse, 1, (a.format, a.words(0), a.words(1), a.words(2), a.bytes(), a.count))           \
  ROW(traverse_blend,      traverse, 1, (a.format, a.words(0), a.words(1), a.numbers(), a.count))                     \
  ROW(traverse_blend_hits, traverse, 1, (HitsOf(a), a.bytes()))                                                       \
  ROW(array_build,         array,    1, (TrianglesOf(a), a.bytes(), a.room))                                          \
  ROW(array_resolve,       array,    2, (a.format, a.words(0), a.words(1), a.words(2), a.numbers(), a.count))          \
  ROW(array_compact,       array,    1, (a.blob, a.blob_bytes, a.bytes(), a.room))                                    \
  ROW(array_reorder,       array,    1, (a.blob, a.blob_bytes, a.bytes(), a.room))                                    \
  ROW(array_concatenate,   array,    1, (a.blob, a.blob_bytes, a.bytes(), a.room))                                    \
  ROW(array_save,          array,    1, (a.format, a.blob, a.blob_bytes, a.bytes(), a.room))                          \
  ROW(array_load,          array,    1, (a.blob, a.blob_bytes, a.bytes(), a.room))                                    \
  ROW(array_emulate,       array,    1, (a.level, a.format, a.blob, a.bytes(), a.room))                               \
  ROW(dag_encode,          dag,      1, (a.format, a.blob, a.blob_bytes, a.bytes(), a.room))                          \
  ROW(dag_decode,          dag,      1, (a.format, a.blob, a.blob_bytes, a.bytes(), a.room))                          \
  ROW(dag_lookup,          dag,      1,                                                                               \
      (a.format, a.blob, a.blob_bytes, a.words(0), a.words(1), a.bytes(), a.count))                                   \
  ROW(dag_lookup_f32,      dag,      1,                                                                               \
      (a.format, a.blob, a.blob_bytes, a.words(0), a.floats(1), a.floats(2), a.bytes(), a.count))                     \
  ROW(bake_mesh,           bake,     1, (MeshOf(a), a.bytes(), a.room))                                               \
  ROW(subdivision_index,   subdivision, 1,                                                                            \
      (a.format, a.level, a.words(0), a.words(1), a.words(2), a.words(3), a.numbers(), a.count))                      \
  ROW(subdivision_corners, subdivision, 12, (a.format, a.level, a.words(0), a.numbers(), a.count))
// clang-format on

/// Entry points by the number of their row.
#define MMVERIFY_NUMBER(name, topic, values, arguments) name,
enum class Call : std::uint32_t { MMVERIFY_ENTRY_POINTS(MMVERIFY_NUMBER) };
#undef MMVERIFY_NUMBER

struct EntryPoint {
  const char* name;
  Topic topic;
  std::size_t offset;  ///< the pointer's, in mmverify_subject_t
  Signature signature;
  std::size_t answer_bytes;  ///< for one element
};

#define MMVERIFY_ROW(name, topic, values, arguments)                                 \
  EntryPoint{#name, Topic::topic, offsetof(mmverify_subject_t, name),                \
             signature_of(static_cast<decltype(mmverify_subject_t::name)>(nullptr)), \
             values * signature_of(static_cast<decltype(mmverify_subject_t::name)>(nullptr)).value_bytes},
constexpr std::array entry_points = {MMVERIFY_ENTRY_POINTS(MMVERIFY_ROW)};
#undef MMVERIFY_ROW

constexpr std::size_t calls = entry_points.size();
constexpr const EntryPoint& entry_point(Call c) { return entry_points[static_cast<std::size_t>(c)]; }

/// Whether the pointer at this offset points to data; such pointers may stand between pointers to functions.
constexpr bool is_data(std::size_t offset) {
  return offset == offsetof(mmverify_subject_t, bake_support) ||
         offset == offsetof(mmverify_subject_t, attribute_support) ||
         offset == offsetof(mmverify_subject_t, runs_on);
}

constexpr bool rows_are_the_headers() {
  constexpr std::size_t pointer = sizeof(void (*)()),
                        before = offsetof(mmverify_subject_t, flags) + sizeof(std::uint32_t);
  std::size_t next = (before + pointer - 1) / pointer * pointer;
  for (const EntryPoint& e : entry_points) {
    if (is_data(next)) next += pointer;
    if (e.offset != next) return false;
    next += pointer;
  }
  if (is_data(next)) next += pointer;
  return next == sizeof(mmverify_subject_t);
}
static_assert(rows_are_the_headers(), "a row each for the pointers of mmverify_subject_t, in their order");

/// The largest value of `of` over the table.
constexpr std::size_t largest(std::size_t (*of)(const EntryPoint&)) {
  std::size_t found = 0;
  for (const EntryPoint& e : entry_points) found = std::max(found, of(e));
  return found;
}
constexpr std::size_t most_arrays = largest([](const EntryPoint& e) { return e.signature.arrays; });
constexpr std::size_t most_number_bytes =
    largest([](const EntryPoint& e) { return e.signature.number_bytes; });
constexpr std::size_t most_answer_bytes = largest([](const EntryPoint& e) { return e.answer_bytes; });

}  // namespace mmverify::dock
