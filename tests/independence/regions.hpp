// An entry point's arguments, element by element, as named regions of bytes that can be read and replaced.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "subjects/dock/entry_points.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::independence {

/// A part of one question.
struct Region {
  std::string_view parameter;  ///< "words(0)", "what"
  std::string_view member;     ///< of a case's struct: "width"; otherwise empty
  std::uint8_t* at;
  std::size_t bytes;
};
using Regions = std::vector<Region>;

inline std::size_t map_bytes(std::uint32_t level, std::uint32_t format) {
  return ((std::size_t{1} << 2 * level) * format + 7) / 8;
}

/// Bytes of the blob of an entry point, from its numbers and its sizes in the order of the parameters.
inline std::size_t blob_bytes(dock::Call entry, const std::vector<std::uint32_t>& numbers,
                              const std::vector<std::size_t>& sizes) {
  using dock::Call;
  switch (entry) {
    case Call::tree_encode:
    case Call::micromap_up:
    case Call::micromap_down: return map_bytes(numbers[0], numbers[1]);
    case Call::micromap_force2:
    case Call::micromap_through:
    case Call::micromap_substitute:
    case Call::array_emulate: return map_bytes(numbers[0], MMVERIFY_4_STATE);
    case Call::micromap_widen: return map_bytes(numbers[0], MMVERIFY_2_STATE);
    case Call::micromap_unpack: return (sizes[0] * numbers[0] + 7) / 8;
    case Call::vq2_decode:
    case Call::vq2_region: return 32;
    case Call::vq4_decode:
    case Call::vq4_region: return 64;
    case Call::vq2_encode: return 256;
    case Call::vq4_encode: return 1024;
    case Call::attribute_face_mip: return 16;
    default: return sizes[0];
  }
}

/// Bytes of the answer of an entry point that neither says its size nor has elements, from its numbers and sizes.  A case
/// gives its level and format as numbers.
inline std::size_t answer_bytes(dock::Call entry, const std::vector<std::uint32_t>& numbers,
                                const std::vector<std::size_t>& sizes) {
  using dock::Call;
  const std::size_t level = numbers.empty() ? 0 : numbers[0];
  switch (entry) {
    case Call::micromap_pack: return (sizes[0] * numbers[0] + 7) / 8;
    case Call::micromap_unpack: return sizes[0];
    case Call::micromap_force2: return map_bytes(numbers[0], MMVERIFY_2_STATE);
    case Call::micromap_widen:
    case Call::micromap_through:
    case Call::micromap_substitute: return map_bytes(numbers[0], MMVERIFY_4_STATE);
    case Call::micromap_up: return map_bytes(numbers[0] + 1, numbers[1]);
    case Call::micromap_down: return map_bytes(numbers[0] - 1, numbers[1]);
    case Call::vq2_decode: return 256;
    case Call::vq4_decode: return 1024;
    case Call::vq2_encode: return 32;
    case Call::vq4_encode: return 64;
    case Call::attribute_bake_faces: return std::size_t{4} << 2 * level;
    case Call::attribute_bake_vertices:
      return 2 * ((std::size_t{1} << level) + 1) * ((std::size_t{1} << level) + 2);
    case Call::traverse_blend_hits: return 4;
    default:  // tree_decode, bake
      return map_bytes(numbers[0], numbers[1]);
  }
}

/// One parameter's own copy: `take` reads it as element k has it, `argument` is what the right function gets, and
/// `regions` are the places at which a question can be changed.
template <class T>
struct Copy;

template <>
struct Copy<std::uint32_t> {
  std::uint32_t number = 0;
  void take(std::uint32_t given, std::size_t, std::size_t) { number = given; }
  std::uint32_t argument() { return number; }
  void regions(std::string_view name, Regions& all) {
    all.push_back({name, {}, reinterpret_cast<std::uint8_t*>(&number), sizeof number});
  }
};

/// Sizes and counts are no fields: what a blob holds says how long it is.
template <>
struct Copy<std::size_t> {
  std::size_t size = 0;
  void take(std::size_t given, std::size_t, std::size_t) { size = given; }
  std::size_t argument() { return size; }
  void regions(std::string_view, Regions&) {}
};

template <class T>
struct Number {
  T number{};
  void take(const T* given, std::size_t k, std::size_t) { number = given[k]; }
  const T* argument() { return &number; }
  void regions(std::string_view name, Regions& all) {
    all.push_back({name, {}, reinterpret_cast<std::uint8_t*>(&number), sizeof number});
  }
};
template <>
struct Copy<const std::uint32_t*> : Number<std::uint32_t> {};
template <>
struct Copy<const float*> : Number<float> {};
template <>
struct Copy<const double*> : Number<double> {};

template <>
struct Copy<const std::uint8_t*> {
  std::vector<std::uint8_t> bytes;
  void take(const std::uint8_t* given, std::size_t k, std::size_t size) {
    bytes.assign(given + k * size, given + (k + 1) * size);
  }
  const std::uint8_t* argument() { return bytes.data(); }
  void regions(std::string_view name, Regions& all) { all.push_back({name, {}, bytes.data(), bytes.size()}); }
};

/// An answer of `size` bytes an element.
template <class T>
struct Answer {
  T* out = nullptr;
  void take(T* given, std::size_t k, std::size_t size) { out = given + k * size / sizeof(T); }
  T* argument() { return out; }
  void regions(std::string_view, Regions&) {}
};
template <>
struct Copy<std::uint8_t*> : Answer<std::uint8_t> {};
template <>
struct Copy<std::uint32_t*> : Answer<std::uint32_t> {};
template <>
struct Copy<float*> : Answer<float> {};

// A case's words, and what it points to.
#define MMVERIFY_WORD(member) \
  all.push_back({name, #member, reinterpret_cast<std::uint8_t*>(&what.member), sizeof what.member})

template <>
struct Copy<const mmverify_bake_case_t*> {
  mmverify_bake_case_t what{};
  std::vector<std::uint8_t> texels;
  void take(const mmverify_bake_case_t* given, std::size_t, std::size_t) {
    what = *given;
    const std::size_t texel = what.texel == MMVERIFY_UNORM8 ? 1 : what.texel == MMVERIFY_UNORM16 ? 2 : 4;
    std::size_t count = 0;
    const auto side = [](std::uint32_t s, std::uint32_t mip) { return s >> mip == 0 ? 1 : s >> mip; };
    for (std::uint32_t mip = 0; mip < what.mips; ++mip)
      count += std::size_t{side(what.width, mip)} * side(what.height, mip);
    const auto* from = static_cast<const std::uint8_t*>(what.texels);
    texels.assign(from, from + count * texel);
    what.texels = texels.data();
  }
  const mmverify_bake_case_t* argument() { return &what; }
  void regions(std::string_view name, Regions& all) {
    MMVERIFY_WORD(level);
    MMVERIFY_WORD(format);
    MMVERIFY_WORD(width);
    MMVERIFY_WORD(height);
    MMVERIFY_WORD(mips);
    MMVERIFY_WORD(texel);
    MMVERIFY_WORD(border);
    MMVERIFY_WORD(filter);
    MMVERIFY_WORD(wrap_u);
    MMVERIFY_WORD(wrap_v);
    MMVERIFY_WORD(factor);
    MMVERIFY_WORD(vertex_factor);
    MMVERIFY_WORD(alpha_mode);
    MMVERIFY_WORD(cutoff_numerator);
    MMVERIFY_WORD(cutoff_denominator);
    MMVERIFY_WORD(margin);
    MMVERIFY_WORD(uv[0]);
    MMVERIFY_WORD(uv[1]);
    MMVERIFY_WORD(uv[2]);
    MMVERIFY_WORD(uv[3]);
    MMVERIFY_WORD(uv[4]);
    MMVERIFY_WORD(uv[5]);
    all.push_back({name, "texels", texels.data(), texels.size()});
  }
};

template <>
struct Copy<const mmverify_attribute_case_t*> {
  mmverify_attribute_case_t what{};
  std::vector<std::uint8_t> texels;
  void take(const mmverify_attribute_case_t* given, std::size_t, std::size_t) {
    what = *given;
    const auto* from = static_cast<const std::uint8_t*>(what.texels);
    texels.assign(from, from + std::size_t{4} * what.width * what.height);
    what.texels = texels.data();
  }
  const mmverify_attribute_case_t* argument() { return &what; }
  void regions(std::string_view name, Regions& all) {
    MMVERIFY_WORD(level);
    MMVERIFY_WORD(width);
    MMVERIFY_WORD(height);
    MMVERIFY_WORD(texel);
    MMVERIFY_WORD(border[0]);
    MMVERIFY_WORD(border[1]);
    MMVERIFY_WORD(border[2]);
    MMVERIFY_WORD(border[3]);
    MMVERIFY_WORD(filter);
    MMVERIFY_WORD(wrap_u);
    MMVERIFY_WORD(wrap_v);
    MMVERIFY_WORD(meaning);
    MMVERIFY_WORD(uv[0]);
    MMVERIFY_WORD(uv[1]);
    MMVERIFY_WORD(uv[2]);
    MMVERIFY_WORD(uv[3]);
    MMVERIFY_WORD(uv[4]);
    MMVERIFY_WORD(uv[5]);
    all.push_back({name, "texels", texels.data(), texels.size()});
  }
};

template <>
struct Copy<const mmverify_blend_case_t*> {
  mmverify_blend_case_t what{};
  std::vector<mmverify_hit_t> hits;
  void take(const mmverify_blend_case_t* given, std::size_t, std::size_t) {
    what = *given;
    hits.assign(what.hits, what.hits + what.count);
    what.hits = hits.data();
  }
  const mmverify_blend_case_t* argument() { return &what; }
  void regions(std::string_view name, Regions& all) {
    MMVERIFY_WORD(operation);
    MMVERIFY_WORD(payload);
    MMVERIFY_WORD(count);
    all.push_back(
        {name, "hits", reinterpret_cast<std::uint8_t*>(hits.data()), hits.size() * sizeof(mmverify_hit_t)});
  }
};

template <>
struct Copy<const mmverify_array_case_t*> {
  mmverify_array_case_t what{};
  std::vector<mmverify_array_triangle_t> triangles;
  std::vector<std::uint8_t> maps;
  void take(const mmverify_array_case_t* given, std::size_t, std::size_t) {
    what = *given;
    triangles.assign(what.triangles, what.triangles + what.count);
    std::size_t bytes = 0;
    for (const mmverify_array_triangle_t& t : triangles)
      bytes = std::max(bytes, t.map + map_bytes(t.level, t.format));
    maps.assign(what.maps, what.maps + bytes);
    what.triangles = triangles.data();
    what.maps = maps.data();
  }
  const mmverify_array_case_t* argument() { return &what; }
  void regions(std::string_view name, Regions& all) {
    MMVERIFY_WORD(api);
    MMVERIFY_WORD(index_type);
    MMVERIFY_WORD(base_triangle);
    MMVERIFY_WORD(flags);
    MMVERIFY_WORD(bound);
    MMVERIFY_WORD(before);
    MMVERIFY_WORD(count);
    all.push_back({name, "triangles", reinterpret_cast<std::uint8_t*>(triangles.data()),
                   triangles.size() * sizeof(mmverify_array_triangle_t)});
    all.push_back({name, "maps", maps.data(), maps.size()});
  }
};

template <>
struct Copy<const mmverify_mesh_case_t*> {
  mmverify_mesh_case_t what{};
  Copy<const mmverify_bake_case_t*> surface;
  std::vector<std::uint32_t> indices, levels;
  std::vector<float> uvs;
  void take(const mmverify_mesh_case_t* given, std::size_t, std::size_t) {
    what = *given;
    surface.take(what.surface, 0, 0);
    indices.assign(what.indices, what.indices + std::size_t{3} * what.triangles);
    uvs.assign(what.uvs, what.uvs + std::size_t{2} * what.vertices);
    if (what.levels != nullptr) levels.assign(what.levels, what.levels + what.triangles);
    what.indices = indices.data();
    what.uvs = uvs.data();
    if (what.levels != nullptr) what.levels = levels.data();
  }
  const mmverify_mesh_case_t* argument() {
    what.surface = surface.argument();
    return &what;
  }
  void regions(std::string_view name, Regions& all) {
    MMVERIFY_WORD(api);
    MMVERIFY_WORD(index_type);
    surface.regions(name, all);
    const auto numbers = [&](std::string_view member, auto& some) {
      all.push_back(
          {name, member, reinterpret_cast<std::uint8_t*>(some.data()), some.size() * sizeof(some[0])});
    };
    numbers("indices", indices);
    numbers("uvs", uvs);
    numbers("levels", levels);
  }
};
#undef MMVERIFY_WORD

}  // namespace mmverify::independence
