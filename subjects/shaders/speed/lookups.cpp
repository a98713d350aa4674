#include "subjects/shaders/speed/lookups.hpp"

#include <algorithm>
#include <bit>
#include <memory>

#include "impl/attribute/lookup.hpp"
#include "impl/dag/container.hpp"
#include "impl/dag/dag.hpp"
#include "impl/index/index.hpp"
#include "impl/tree/stream.hpp"
#include "impl/tree/tree.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::shaders {
namespace {

using impl::micromap::Format;
using Words = const std::uint32_t*;

float number(std::uint32_t bits) { return std::bit_cast<float>(bits); }

/// A map with O inside a disc, T outside, and unknown along the border.
std::vector<std::uint8_t> disc(std::uint32_t level) {
  std::vector<std::uint8_t> map(std::max<std::size_t>(1, (std::size_t{2} << 2 * level) / 8));
  const auto side = static_cast<float>(1u << level);
  for (std::uint32_t k = 0; k < 1u << 2 * level; ++k) {
    unsigned inside = 0;
    for (const auto& corner : impl::index::corners(k, level)) {
      const float x = static_cast<float>(corner.i) / side - 0.3f,
                  y = static_cast<float>(corner.j) / side - 0.3f;
      inside += x * x + y * y < 0.06f;
    }
    const unsigned state = inside == 3 ? 1 : inside == 0 ? 0 : 2;
    map[k / 4] = static_cast<std::uint8_t>(map[k / 4] | state << 2 * (k % 4));
  }
  return map;
}

/// A square map with O inside a disc, T outside, and C between.
template <class Map>
Map square(std::uint32_t side) {
  Map map{};
  for (std::uint32_t k = 0; k < map.size(); ++k) {
    const auto x = static_cast<float>(k % side) - 0.4f * static_cast<float>(side),
               y = static_cast<float>(k / side) - 0.5f * static_cast<float>(side);
    const float r = (x * x + y * y) / static_cast<float>(side * side);
    map[k] = r < 0.05f ? impl::vq::State::O : r > 0.12f ? impl::vq::State::T : impl::vq::State::C;
  }
  return map;
}

/// Whole words of 32 bits, and one more, which a shader may read.
std::vector<std::uint8_t> padded(std::vector<std::uint8_t> code) {
  constexpr std::size_t word = sizeof(std::uint32_t);
  code.resize((code.size() + word - 1) / word * word + word);
  return code;
}

void add_indices(std::uint32_t level, std::vector<Lookup>& to) {
  to.push_back({.name = "index, exact",
                .level = level,
                .file = "subjects/index.glsl",
                .entry_point = "index_f32",
                .right = [level](Words in, std::uint32_t* out) {
                  *out = impl::index::from_barycentrics(number(in[0]), number(in[1]), level);
                }});
  to.push_back({.name = "index, rows",
                .level = level,
                .file = "subjects/index.glsl",
                .entry_point = "row_index_f32",
                .right = [level](Words in, std::uint32_t* out) {
                  *out = impl::index::w_minor(number(in[0]), number(in[1]), level);
                }});
}

void add_flat_map(std::uint32_t level, std::vector<Lookup>& to) {
  to.push_back({.name = "flat map",
                .level = level,
                .file = "kernels/flat.glsl",
                .entry_point = "tree_lookup_f32",
                .first = 2,
                .random_states_bytes = std::max<std::uint64_t>(4, (std::uint64_t{2} << 2 * level) / 8),
                .right = [level](Words in, std::uint32_t* out) {
                  const std::uint32_t k = impl::index::from_barycentrics(number(in[0]), number(in[1]), level);
                  constexpr std::uint32_t states = 16; /* check-magic: 16 == 32 // 2 */
                  *out = random_states(k / states) >> 2 * (k % states) & 3u;
                }});
}

void add_ranked_tree(std::uint32_t level, const std::vector<std::uint8_t>& map, std::vector<Lookup>& to) {
  const auto tree =
      std::make_shared<impl::tree::Tree>(impl::tree::Tree::encode(level, Format::four_state, map));
  const std::uint8_t* const bytes = tree->memory();
  to.push_back({.name = "tree, ranked",
                .level = level,
                .file = "subjects/tree_ranked.glsl",
                .entry_point = "ranked_lookup",
                .inputs = Inputs::indices,
                .first = 2,
                .words_in = 1,
                .code = padded({bytes, bytes + (tree->bits() + 7) / 8}),
                .right = [tree](Words in, std::uint32_t* out) { *out = (*tree)[in[0]]; }});
}

/// The paper's lookup, which passes bit by bit over the subtrees before a place: a hit costs a walk through half the map's tree,
/// so there are few hits.
void add_walked_tree(std::uint32_t level, bool is_processor, std::vector<Lookup>& to) {
  const auto stream =
      std::make_shared<impl::tree::Stream>(impl::tree::encode_stream(level, Format::four_state, disc(level)));
  std::vector<std::uint8_t> code(stream->tree);
  code.insert(code.end(), stream->data.begin(), stream->data.end());
  const auto code_bytes = static_cast<std::uint32_t>(code.size());
  to.push_back({.name = "tree, bit by bit",
                .level = level,
                .file = "subjects/tree.glsl",
                .entry_point = "tree_lookup",
                .inputs = Inputs::indices,
                .first = 2,
                .words_in = 1,
                .code = padded(std::move(code)),
                .code_bytes = code_bytes,
                .most_hits = std::uint64_t{1} << (is_processor ? 12 : 18),
                .right = [stream, level](Words in, std::uint32_t* out) {
                  *out = impl::tree::lookup_stream(level, Format::four_state, *stream, in[0]);
                }});
}

void add_graph(std::uint32_t level, const std::vector<std::uint8_t>& map, std::vector<Lookup>& to) {
  const auto graph = std::make_shared<impl::dag::Dag>(impl::dag::Format::four_state);
  graph->add(level, map);
  to.push_back({.name = "graph",
                .level = level,
                .file = "subjects/dag.glsl",
                .entry_point = "dag_lookup_f32",
                .inputs = Inputs::points_of_map,
                .first = 2,
                .words_in = 3,
                .code = padded(impl::dag::save(*graph)),
                .right = [graph](Words in, std::uint32_t* out) {
                  *out = graph->at_point(in[0], number(in[1]), number(in[2]));
                }});
}

void add_blocks(std::vector<Lookup>& to) {
  const auto block2 = impl::vq::encode_optimal(square<impl::vq::Map2>(16)).block;
  const auto block4 = impl::vq::encode(square<impl::vq::Map4>(32)).block;
  to.push_back({.name = "VQ2",
                .file = "subjects/vq.glsl",
                .entry_point = "vq2_region",
                .inputs = Inputs::square,
                .side = 4,
                .code = padded({block2.begin(), block2.end()}),
                .right = [block2](Words in, std::uint32_t* out) {
                  *out = static_cast<std::uint32_t>(impl::vq::region(block2, in[0], in[1]));
                }});
  to.push_back({.name = "VQ4",
                .file = "subjects/vq.glsl",
                .entry_point = "vq4_region",
                .inputs = Inputs::square,
                .side = 5,
                .code = padded({block4.begin(), block4.end()}),
                .right = [block4](Words in, std::uint32_t* out) {
                  *out = static_cast<std::uint32_t>(impl::vq::region(block4, in[0], in[1]));
                }});
}

void add_attributes(std::uint32_t level, std::vector<Lookup>& to) {
  using impl::attribute::VertexOrder;
  for (const auto& [name, order] : {std::pair{"triplet, W-minor", VertexOrder::w_minor},
                                    {"triplet, U-major", VertexOrder::u_major},
                                    {"triplet, Bird", VertexOrder::bird}})
    to.push_back({.name = name,
                  .level = level,
                  .file = "subjects/attribute.glsl",
                  .entry_point = "attribute_triplet_f32",
                  .first = static_cast<std::uint32_t>(order),
                  .words_out = 3,
                  .right = [level, o = order](Words in, std::uint32_t* out) {
                    const auto triplet = impl::attribute::triplet(o, number(in[0]), number(in[1]), level);
                    std::copy(triplet.begin(), triplet.end(), out);
                  }});
  to.push_back({.name = "weights",
                .level = level,
                .file = "subjects/attribute.glsl",
                .entry_point = "attribute_weights_f32",
                .words_out = 3,
                .right = [level](Words in, std::uint32_t* out) {
                  for (const float w : impl::attribute::locate(number(in[0]), number(in[1]), level).weights)
                    *out++ = std::bit_cast<std::uint32_t>(w);
                }});
}

}  // namespace

std::uint32_t random_states(std::uint32_t k) {
  k = (k ^ k >> 16) * 0x7feb352du;
  k = (k ^ k >> 15) * 0x846ca68bu;
  return k ^ k >> 16;
}

std::vector<Lookup> lookups(const std::vector<std::uint32_t>& levels, bool is_processor) {
  constexpr std::uint32_t walked = 8, beyond_caches = 15;
  std::vector<Lookup> all;
  for (const std::uint32_t level : levels) {
    add_indices(level, all);
    add_flat_map(level, all);
    const std::vector<std::uint8_t> map = disc(level);
    add_ranked_tree(level, map, all);
    add_graph(level, map, all);
    add_attributes(level, all);
  }
  if (!is_processor) add_flat_map(beyond_caches, all);
  add_walked_tree(std::min(levels.back(), walked), is_processor, all);
  add_blocks(all);
  return all;
}

Lookup copy_of(std::uint32_t words_in, std::uint32_t words_out) {
  constexpr std::uint32_t deepest = 16;
  return {.name = "copy kernel",
          .level = deepest,
          .file = "kernels/copy.glsl",
          .entry_point = words_in == 1    ? "ranked_lookup"
                         : words_in == 3  ? "dag_lookup_f32"
                         : words_out == 3 ? "attribute_triplet_f32"
                                          : "index_f32",
          .inputs = words_in == 1   ? Inputs::indices
                    : words_in == 2 ? Inputs::points
                                    : Inputs::points_of_map,
          .words_in = words_in,
          .words_out = words_out,
          .right = [=](Words in, std::uint32_t* out) {
            std::uint32_t x = 0;
            for (std::uint32_t k = 0; k < words_in; ++k) x ^= in[k];
            for (std::uint32_t k = 0; k < words_out; ++k) out[k] = x + k;
          }};
}

}  // namespace mmverify::shaders
