// The shared part of adapters to bakers of whole meshes: the answer of bake_mesh from what a baker made.
#pragma once

#include <array>

#include "examples/adapters/subject.hpp"

/// A count, a level and a format.
using UsageCounts = std::vector<std::array<uint32_t, 3>>;

/// A baker's records, each with its offset in the data and its level; an index, or a special one, a triangle; and the
/// usage counts of its records and of its references.
struct MadeMesh {
  std::vector<uint32_t> offsets, levels;
  std::vector<int32_t> indices;
  std::vector<uint8_t> data;
  UsageCounts of_records, of_references;
};

/// The corner's u and v.
inline const float* corner(const mmverify_mesh_case_t& c, uint32_t triangle, uint32_t k) {
  return c.uvs + 2 * size_t{c.indices[3 * triangle + k]};
}

inline uint32_t index_bytes(const mmverify_mesh_case_t& c) {
  if (c.index_type == MMVERIFY_INDEX_U8) return 1;
  return c.index_type == MMVERIFY_INDEX_U16 || c.index_type == MMVERIFY_INDEX_I16 ? 2 : 4;
}

/// Counts for a baker that leaves this to its caller.
inline void count_usage(const mmverify_mesh_case_t& c, MadeMesh& made) {
  for (uint32_t level = 0; level <= 12; ++level) {
    uint32_t records = 0, references = 0;
    for (const uint32_t of_record : made.levels) records += of_record == level ? 1 : 0;
    for (const int32_t index : made.indices)
      references += index >= 0 && made.levels[size_t(index)] == level ? 1 : 0;
    if (records != 0) made.of_records.push_back({records, level, c.surface->format});
    if (references != 0) made.of_references.push_back({references, level, c.surface->format});
  }
}

/// The answer in the header's form.
inline size_t mesh_answer(const mmverify_mesh_case_t& c, const MadeMesh& made, uint8_t* answer,
                          size_t capacity) {
  const bool counts_geometry =
      c.api == MMVERIFY_ARRAY_EXT || c.api == MMVERIFY_ARRAY_OPTIX || c.api == MMVERIFY_ARRAY_NVAPI;
  const UsageCounts of_references = counts_geometry ? made.of_references : UsageCounts();
  const mmverify_array_answer_t head = {uint32_t(made.levels.size()), uint32_t(made.of_records.size()),
                                        uint32_t(of_references.size()), index_bytes(c) * c.triangles,
                                        uint32_t(made.data.size())};
  std::vector<uint32_t> words;
  for (size_t k = 0; k < made.levels.size(); ++k)
    words.insert(words.end(), {made.offsets[k], made.levels[k] | c.surface->format << 16});
  for (const UsageCounts* counts : {&made.of_records, &of_references})
    for (const auto& one : *counts) words.insert(words.end(), one.begin(), one.end());
  const size_t size = sizeof head + 4 * words.size() + head.index_bytes + head.data_bytes;
  if (size > capacity) return size;
  const auto put = [&](const void* from, size_t bytes) {
    if (bytes != 0) std::memcpy(answer, from, bytes);
    answer += bytes;
  };
  put(&head, sizeof head);
  put(words.data(), 4 * words.size());
  for (const int32_t index : made.indices) put(&index, index_bytes(c));
  put(made.data.data(), made.data.size());
  return size;
}
