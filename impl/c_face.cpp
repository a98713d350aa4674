#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "impl/mmverify.h"
#include "impl/mmverify.hpp"

struct mmverify_tree {
  mmverify::impl::tree::Tree tree;
};

struct mmverify_baker {
  mmverify::impl::bake::TriangleBaker baker;
};

struct mmverify_array {
  mmverify::impl::array::Built built;
  std::vector<mmverify_record> records;
  std::vector<mmverify_usage> array_usage, geometry_usage;
};

namespace {

using namespace mmverify::impl;
using micromap::Format, micromap::State;

thread_local std::string last_error;

/// 1 where `work` returns, 0 where it throws; its words are kept.
template <class Work>
int done(Work work) noexcept {
  try {
    work();
    return 1;
  } catch (const std::exception& error) {
    try {
      last_error = error.what();
    } catch (...) {
      last_error.clear();
    }
  }
  return 0;
}

void need(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

Format format_of(std::uint32_t format) {
  need(format == 1 || format == 2, "a format is 1, of 2-state maps, or 2, of 4-state maps");
  return static_cast<Format>(format);
}

std::uint64_t states_of(std::uint32_t level, std::uint32_t least = 0) {
  need(level >= least && level <= tree::max_level,
       "a level of maps is 0 to 12, and has one below it to go down");
  return micromap::micro_triangles(level);
}

std::size_t bytes(std::uint64_t states, Format format) {
  return static_cast<std::size_t>(micromap::packed_bytes(states, format));
}

std::uint32_t index_level(std::uint32_t level) {
  need(level <= index::max_level, "a level of indices is 0 to 16");
  return level;
}

/// The corners of a batch, piece by piece: six lists made into one.
template <class Corners>
void interleave(const std::uint32_t* index, std::uint32_t* corners, std::size_t count,
                const Corners& corners_of) {
  constexpr std::size_t piece = 256;
  std::array<std::array<std::uint32_t, piece>, 6> lists;
  for (std::size_t at = 0; at < count; at += piece) {
    const std::size_t size = std::min(piece, count - at);
    const auto list = [&](std::size_t c) { return std::span(lists[c]).first(size); };
    corners_of({index + at, size}, index::CornerSpans{list(0), list(1), list(2), list(3), list(4), list(5)});
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t c = 0; c < 6; ++c) corners[6 * (at + k) + c] = lists[c][k];
  }
}

template <class Block>
Block block_of(const std::uint8_t* from) {
  Block block;
  std::copy_n(from, block.size(), block.begin());
  return block;
}

template <class Map>
Map map_of(const std::uint8_t* from) {
  Map map;
  for (std::size_t k = 0; k < map.size(); ++k) {
    need(from[k] <= 2, "a region is T 0, C 1 or O 2");
    map[k] = static_cast<vq::State>(from[k]);
  }
  return map;
}

template <class Block>
void regions(const std::uint8_t* from, const std::uint32_t* x, const std::uint32_t* y, std::uint8_t* state,
             std::size_t count) {
  const auto block = block_of<Block>(from);
  for (std::size_t k = 0; k < count; ++k) state[k] = static_cast<std::uint8_t>(vq::region(block, x[k], y[k]));
}

void write_states(const auto& states, std::uint8_t* to) {
  for (std::size_t k = 0; k < states.size(); ++k) to[k] = static_cast<std::uint8_t>(states[k]);
}

template <class Texel>
bake::Texels view(const mmverify_texture& mip) {
  return bake::TexelView<Texel>{static_cast<const Texel*>(mip.texels), mip.width, mip.height, mip.width};
}

bake::Texels view(const mmverify_texture& mip, std::uint32_t texel) {
  switch (texel) {
    case MMVERIFY_TEXEL_UNORM8: return view<std::uint8_t>(mip);
    case MMVERIFY_TEXEL_UNORM16: return view<std::uint16_t>(mip);
    case MMVERIFY_TEXEL_FLOAT32: return view<float>(mip);
    default: throw std::invalid_argument("texels are of 1, 8 bits, 2, 16 bits, or 3, float32");
  }
}

bake::Wrap wrap_of(std::uint32_t wrap) {
  need(wrap <= MMVERIFY_WRAP_MIRROR_CLAMP_TO_EDGE, "an address mode is 0 to 4");
  return static_cast<bake::Wrap>(wrap);
}

std::vector<bake::Texels> levels_of(std::span<const mmverify_texture> mips, std::uint32_t texel) {
  std::vector<bake::Texels> levels;
  for (const mmverify_texture& mip : mips) levels.push_back(view(mip, texel));
  return levels;
}

std::vector<bake::PixelView> levels_of(std::span<const mmverify_pixels> mips, std::uint32_t texel) {
  need(texel == MMVERIFY_TEXEL_UNORM8, "texels of interleaved pixels are of 1, 8 bits");
  std::vector<bake::PixelView> levels;
  for (const mmverify_pixels& m : mips)
    levels.push_back({m.bytes, m.width, m.height, m.pitch, m.channels, m.channel});
  return levels;
}

bake::BlockFormat block_format_of(std::uint32_t format) {
  switch (format) {
    case MMVERIFY_BLOCKS_BC1: return bake::BlockFormat::bc1;
    case MMVERIFY_BLOCKS_BC2: return bake::BlockFormat::bc2;
    case MMVERIFY_BLOCKS_BC3: return bake::BlockFormat::bc3;
    case MMVERIFY_BLOCKS_BC4: return bake::BlockFormat::bc4;
    case MMVERIFY_BLOCKS_BC7: return bake::BlockFormat::bc7;
    default: throw std::invalid_argument("blocks are of format 1, 2, 3, 4 or 7, as BC1 to BC4 and BC7");
  }
}

std::vector<bake::BlockView> levels_of(std::span<const mmverify_blocks> mips, std::uint32_t texel) {
  need(texel == MMVERIFY_TEXEL_UNORM16, "texels of blocks are of 2, 16 bits");
  std::vector<bake::BlockView> levels;
  for (const mmverify_blocks& m : mips)
    levels.push_back({block_format_of(m.format), m.bytes, m.width, m.height, m.pitch});
  return levels;
}

template <class Mip>
mmverify_baker* baker_of(std::span<const Mip> mips, const mmverify_sampling& how) {
  need(how.filter <= MMVERIFY_FILTER_NEAREST, "a filter is 0, bilinear, or 1, nearest");
  bake::Sampling sampling;
  sampling.u = wrap_of(how.wrap_u);
  sampling.v = wrap_of(how.wrap_v);
  sampling.filter = how.filter == MMVERIFY_FILTER_NEAREST ? bake::Filter::nearest : bake::Filter::bilinear;
  sampling.border = how.border;
  need(
      how.factor != 0 || how.vertex_factor != 0,
      "factor and vertex_factor are both 0, as in a zeroed mmverify_sampling; write 1 in both for no factor");
  sampling.factors = {how.factor, how.vertex_factor};
  sampling.margin = how.margin;
  const bake::AlphaMode mode =
      how.blend != 0 ? bake::AlphaMode(bake::Blend{})
                     : bake::AlphaMode(bake::Cutoff{how.cutoff_numerator, how.cutoff_denominator});
  return new mmverify_baker{bake::TriangleBaker(levels_of(mips, how.texel), mode, sampling)};
}

bake::BaseTriangle triangle_of(const float* uv) {
  bake::BaseTriangle triangle;
  for (std::size_t k = 0; k < 3; ++k) triangle[k] = {uv[2 * k], uv[2 * k + 1]};
  return triangle;
}

mmverify_array built_array(std::span<const mmverify_map> maps, std::uint32_t index_bits) {
  need(index_bits == 8 || index_bits == 16 || index_bits == 32, "indices have 8, 16 or 32 bits");
  std::vector<micromap::PackedMap> packed;
  for (const mmverify_map& m : maps) {
    const Format f = format_of(m.format);
    packed.push_back({m.level, f, {m.bytes, bytes(states_of(m.level), f)}});
  }
  using enum micromap::Encoding;
  mmverify_array made{array::build({}, packed,
                                   {.encoding = index_bits == 8    ? u8
                                                : index_bits == 16 ? u16
                                                                   : u32}),
                      {},
                      {},
                      {}};
  const auto& [records, data] = made.built.array;
  made.records = array::copied_as<mmverify_record>(records);
  made.array_usage = array::copied_as<mmverify_usage>(made.built.array_counts);
  made.geometry_usage = array::copied_as<mmverify_usage>(array::geometry_counts(records, made.built.part));
  return made;
}

}  // namespace

const char* mmverify_error(void) { return last_error.c_str(); }

int mmverify_index(uint32_t level, const float* u, const float* v, uint32_t* out, size_t count) {
  return done([&] { index::from_barycentrics({u, count}, {v, count}, index_level(level), {out, count}); });
}

int mmverify_corners(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count) {
  return done([&] {
    const std::uint32_t n = index_level(level);
    interleave(index, corners, count,
               [&](std::span<const std::uint32_t> piece, const index::CornerSpans& out) {
                 index::corners(piece, n, out);
               });
  });
}

int mmverify_row_index(uint32_t level, const float* u, const float* v, uint32_t* out, size_t count) {
  return done([&] { index::w_minor({u, count}, {v, count}, index_level(level), {out, count}); });
}

int mmverify_row_corners(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count) {
  return done([&] {
    index_level(level);
    interleave(index, corners, count,
               [&](std::span<const std::uint32_t> piece, const index::CornerSpans& out) {
                 index::w_minor_corners(piece, out);
               });
  });
}

int mmverify_pack(uint32_t format, const uint8_t* states, size_t count, uint8_t* map) {
  return done([&] {
    const Format f = format_of(format);
    for (std::size_t k = 0; k < count; ++k) need(states[k] < 1u << format, "a state beyond its format");
    micromap::pack({reinterpret_cast<const State*>(states), count}, f, {map, bytes(count, f)});
  });
}

int mmverify_unpack(uint32_t format, const uint8_t* map, size_t count, uint8_t* states) {
  return done([&] {
    const Format f = format_of(format);
    micromap::unpack({map, bytes(count, f)}, f, {reinterpret_cast<State*>(states), count});
  });
}

int mmverify_force2(uint32_t level, const uint8_t* four_state, uint8_t* two_state) {
  return done([&] {
    const std::uint64_t count = states_of(level);
    micromap::force2({four_state, bytes(count, Format::four_state)}, count,
                     {two_state, bytes(count, Format::two_state)});
  });
}

int mmverify_widen(uint32_t level, const uint8_t* two_state, uint8_t* four_state) {
  return done([&] {
    const std::uint64_t count = states_of(level);
    micromap::widen({two_state, bytes(count, Format::two_state)}, count,
                    {four_state, bytes(count, Format::four_state)});
  });
}

int mmverify_map_up(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* above) {
  return done([&] {
    const Format f = format_of(format);
    const std::uint64_t count = states_of(level);
    micromap::up({map, bytes(count, f)}, f, count, {above, bytes(4 * count, f)});
  });
}

int mmverify_map_down(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* below) {
  return done([&] {
    const Format f = format_of(format);
    const std::uint64_t count = states_of(level, 1) / 4;
    micromap::down({map, bytes(4 * count, f)}, f, count, {below, bytes(count, f)});
  });
}

size_t mmverify_tree_encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code,
                            size_t capacity) {
  std::size_t size = 0;
  const int ok = done([&] {
    const Format f = format_of(format);
    const tree::Stream stream = tree::encode_stream(level, f, {map, bytes(states_of(level), f)});
    const std::size_t needed = stream.tree.size() + stream.data.size();
    if (needed <= capacity)
      std::copy(stream.data.begin(), stream.data.end(),
                std::copy(stream.tree.begin(), stream.tree.end(), code));
    size = needed;
  });
  return ok != 0 ? size : 0;
}

mmverify_tree* mmverify_tree_new(uint32_t level, uint32_t format, const uint8_t* map) {
  mmverify_tree* made = nullptr;
  done([&] {
    const Format f = format_of(format);
    made = new mmverify_tree{tree::Tree::encode(level, f, {map, bytes(states_of(level), f)})};
  });
  return made;
}

void mmverify_tree_free(mmverify_tree* tree) { delete tree; }

int mmverify_tree_lookup(const mmverify_tree* tree, const uint32_t* index, uint8_t* state, size_t count) {
  return done([&] { tree->tree.lookup({index, count}, {state, count}); });
}

int mmverify_tree_decode(const mmverify_tree* tree, uint8_t* map) {
  return done([&] {
    const tree::Tree& t = tree->tree;
    t.decode({map, bytes(micromap::micro_triangles(t.level()), t.format())});
  });
}

int mmverify_vq2_decode(const uint8_t* block, uint8_t* map) {
  return done([&] { write_states(vq::decode(block_of<vq::Block2>(block)), map); });
}

int mmverify_vq4_decode(const uint8_t* block, uint8_t* map) {
  return done([&] { write_states(vq::decode(block_of<vq::Block4>(block)), map); });
}

int mmverify_vq2_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                        size_t count) {
  return done([&] { regions<vq::Block2>(block, x, y, state, count); });
}

int mmverify_vq4_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                        size_t count) {
  return done([&] { regions<vq::Block4>(block, x, y, state, count); });
}

int mmverify_vq2_encode(const uint8_t* map, uint8_t* block) {
  return done([&] { write_states(vq::encode_optimal(map_of<vq::Map2>(map)).block, block); });
}

int mmverify_vq4_encode(const uint8_t* map, uint8_t* block) {
  return done([&] { write_states(vq::encode(map_of<vq::Map4>(map)).block, block); });
}

mmverify_baker* mmverify_baker_new(const mmverify_texture* mips, size_t count,
                                   const mmverify_sampling* sampling) {
  mmverify_baker* made = nullptr;
  done([&] { made = baker_of(std::span(mips, count), *sampling); });
  return made;
}

mmverify_baker* mmverify_baker_of_pixels(const mmverify_pixels* mips, size_t count,
                                         const mmverify_sampling* sampling) {
  mmverify_baker* made = nullptr;
  done([&] { made = baker_of(std::span(mips, count), *sampling); });
  return made;
}

mmverify_baker* mmverify_baker_of_blocks(const mmverify_blocks* mips, size_t count,
                                         const mmverify_sampling* sampling) {
  mmverify_baker* made = nullptr;
  done([&] { made = baker_of(std::span(mips, count), *sampling); });
  return made;
}

void mmverify_baker_free(mmverify_baker* baker) { delete baker; }

int mmverify_bake(const mmverify_baker* baker, const float* uv, uint32_t level, uint8_t* map) {
  return done([&] {
    baker->baker.bake(triangle_of(uv), level, {map, bytes(states_of(level), Format::four_state)});
  });
}

int mmverify_useful_level(const float* uv, uint32_t width, uint32_t height, uint32_t limit, uint32_t* level) {
  return done([&] {
    for (std::size_t k = 0; k < 6; ++k) need(std::isfinite(uv[k]), "a texture coordinate that is not finite");
    need(width >= 1 && width <= 16384 && height >= 1 && height <= 16384,
         "a texture has 1 to 16384 texels along each side");
    *level = bake::useful_level(triangle_of(uv), width, height, limit).level;
  });
}

mmverify_array* mmverify_array_new(const mmverify_map* maps, size_t count, uint32_t index_bits) {
  mmverify_array* made = nullptr;
  done([&] { made = new mmverify_array(built_array({maps, count}, index_bits)); });
  return made;
}

void mmverify_array_free(mmverify_array* array) { delete array; }

void mmverify_array_buffers(const mmverify_array* array, mmverify_buffers* buffers) {
  const auto& [encoding, base, indices] = array->built.part;
  const std::vector<std::uint8_t>& data = array->built.array.data;
  *buffers = {array->records.data(),
              array->records.size(),
              data.data(),
              data.size(),
              indices.data(),
              indices.size() / (micromap::width(encoding) / 8),
              array->array_usage.data(),
              array->array_usage.size(),
              array->geometry_usage.data(),
              array->geometry_usage.size()};
}

int mmverify_array_geometry_counts(const mmverify_array* array, size_t first, size_t count,
                                   mmverify_usage* usage, size_t capacity, size_t* found) {
  return done([&] {
    const auto& [encoding, base, indices] = array->built.part;
    const std::size_t width = micromap::width(encoding) / 8, triangles = indices.size() / width;
    need(first <= triangles && count <= triangles - first, "triangles that the array does not have");
    const auto begin = indices.begin() + static_cast<std::ptrdiff_t>(first * width);
    const array::Part part{encoding, base, {begin, begin + static_cast<std::ptrdiff_t>(count * width)}};
    const auto counts =
        array::copied_as<mmverify_usage>(array::geometry_counts(array->built.array.records, part));
    need(usage == nullptr || counts.size() <= capacity,
         "there are more usage counts than usage has room for");
    *found = counts.size();
    if (usage != nullptr) std::copy(counts.begin(), counts.end(), usage);
  });
}

int mmverify_array_state(const mmverify_array* array, size_t triangle, float u, float v, uint8_t* state) {
  return done([&] {
    const auto found = array::state_at(array->built.array, array->built.part, triangle, u, v);
    need(found.has_value(), "a triangle that the array does not have");
    *state = static_cast<std::uint8_t>(*found);
  });
}
