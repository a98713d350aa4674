// The map that a code holds, if it is one.
#include <cstring>

#include "tests/foreign/tree/code.hpp"
#include "tests/foreign/tree/cut.hpp"
#include "tests/foreign/tree/faults.hpp"
#include "tests/foreign/tree/form.hpp"

namespace mmverify::tests::foreign::tree {
namespace {

struct Decoder {
  Tree tree;
  std::uint8_t* map;
  std::size_t t = 0, d = 0;

  void fill(unsigned depth, std::size_t at, unsigned state) {
    const std::size_t run = states_of(tree.level - depth), first = at * run;
    std::size_t count = run;
    if (has(decode_run_in_16_bits)) count = static_cast<std::uint16_t>(run);
    if (has(decode_run_in_12_bits)) count = run & 0xfff;
    if (has(decode_run_in_20_bits)) count = run & 0xfffff;
    if (has(decode_run_short_by_one) && depth == 1 && tree.level >= 4 && at == 3) count = run - 1;
    for (std::size_t i = 0; i < count; ++i) {
      unsigned s = state;
      if (has(decode_uniform_unknown_transparent) && depth == 0 && tree.level >= 3 && state == UT &&
          i % 4 == 3)
        s = T;
      if (has(decode_uniform_of_level_3) && depth == 0 && tree.level >= 3 && state == O && tree.bits == 2 &&
          i >= 32)
        s = UO;
      set_bits(map, (first + i) * tree.bits, tree.bits, s);
    }
  }

  /// Decodes the node at t; its state if it is a leaf.
  std::uint8_t node(unsigned depth, std::size_t at) {
    const bool deepest = depth == tree.level;
    if (!tree.is_internal(t++)) {
      std::size_t place = d++;
      if (has(decode_leaf_in_8_bits)) place &= 0xff;
      if (has(decode_leaf_in_16_bits)) place &= 0xffff;
      unsigned state = stored(bits_at(tree.code, tree.data + place * tree.bits, tree.bits), tree.level);
      if (has(decode_last_leaf_of_many) && d == tree.leaves && d > 64) state &= 1;
      fill(depth, at, state);
      return static_cast<std::uint8_t>(state);
    }
    if (deepest) {  // only with decode_takes_deeper_trees
      std::uint8_t last = 0;
      for (int c = 0; c < 4; ++c, ++t)
        last = static_cast<std::uint8_t>(bits_at(tree.code, tree.data + d++ * tree.bits, tree.bits));
      fill(depth, at, last);
      return last;
    }
    std::uint8_t child[4];
    for (unsigned c = 0; c < 4; ++c) {
      const unsigned which = in_order(c, depth, tree.level);
      std::size_t below = 4 * at + which;
      if (has(decode_place_in_16_bits)) below &= 0xffff;
      if (has(decode_child_3_at_depth_4) && depth >= 4 && which == 3 && c == 3 && tree.is_internal(t))
        below ^= 1;
      child[which] = node(depth + 1, below);
    }
    bool four_alike =
        child[0] != internal && child[0] == child[1] && child[0] == child[2] && child[0] == child[3];
    if (has(decode_takes_mergeable)) four_alike = false;
    if (has(decode_takes_mergeable_at_depth_3) && depth >= 3) four_alike = false;
    if (has(decode_takes_mergeable_above_the_last) && depth + 1 < tree.level && tree.level >= 3)
      four_alike = false;
    if (has(decode_takes_mergeable_root) && depth == 0 && tree.level >= 3) four_alike = false;
    if (has(decode_takes_mergeable_unknown) && child[0] == UO) four_alike = false;
    if (has(decode_takes_mergeable_unknown_from_level_3) && child[0] >= UT && tree.level >= 3)
      four_alike = false;
    if (four_alike) refused = true;
    return internal;
  }

  bool refused = false;
};

bool zero(const std::uint8_t* code, std::size_t begin, std::size_t end) {
  for (std::size_t at = begin; at < end; ++at)
    if (bit_at(code, at) != 0) return false;
  return true;
}

}  // namespace

int decode_stream(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size,
                  std::uint8_t* map) {
  Tree tree;
  tree.level = level;
  tree.bits = bits;
  tree.code = code;
  if (!cut(tree, size)) return 0;
  const std::size_t end = tree.data + tree.leaves * bits,
                    due = code_size_of(tree.size, tree.leaves * bits, level);
  Bytes longer;
  if (size < due) {
    const bool takes =
        (has(decode_takes_a_byte_less) || (has(decode_takes_a_byte_less_from_level_3) && level >= 3)) &&
        size + 1 == due && size * 8 >= tree.data;
    if (!takes) return 0;
    longer.assign(code, code + size);
    longer.resize(due);
    tree.code = longer.data();
  }
  if (size > due) {
    const bool zeros = zero(code, 8 * due, 8 * size);
    bool takes = false;
    if (has(decode_takes_longer)) takes = true;
    if (has(decode_takes_longer_from_level_3)) takes = level >= 3;
    if (has(decode_takes_zeros_after_the_end)) takes = zeros;
    if (has(decode_takes_zeros_after_the_end_from_level_3)) takes = zeros && level >= 3;
    if (has(decode_takes_two_bytes_more)) takes = size >= due + 2;
    if (has(decode_takes_padding_to_words)) takes = zeros && size % 4 == 0 && size < due + 4 && level >= 3;
    if (has(decode_takes_longer_uniform)) takes = tree.leaves == 1 && level >= 3;
    if (!takes) return 0;
  }
  const bool looks_at_tree = !(has(decode_ignores_padding) || has(decode_ignores_padding_of_the_tree) ||
                               (has(decode_ignores_padding_of_the_tree_from_level_3) && level >= 3));
  const bool looks_at_data =
      !(has(decode_ignores_padding) || (has(decode_ignores_padding_from_level_3) && level >= 3) ||
        (has(decode_ignores_highest_padding_bit) && level >= 3 && (code[due - 1] & 0x80u) != 0));
  if (looks_at_tree && !zero(tree.code, tree.size, tree.data)) return 0;
  if (looks_at_data && !zero(tree.code, end, 8 * due)) return 0;
  std::memset(map, 0, bytes_of(states_of(level) * bits));
  Decoder decoder{tree, map};
  const bool uniform = decoder.node(0, 0) != internal;
  if (decoder.refused) return 0;
  if (has(decode_ones_in_the_map_padding) && uniform && level == 0) set_bits(map, bits, 8 - bits, 0xff);
  // A tree with one internal node a depth: only a few micro-triangles may differ from the rest.
  if (has(decode_background_is_the_first_leaf) && level >= 3 && tree.leaves == 3 * level + 1) {
    const unsigned first = bits_at(map, 0, bits);
    if (bits_at(map, bits, bits) != first) {
      std::memset(map, 0, bytes_of(states_of(level) * bits));
      for (std::size_t k = 0; k < states_of(level); ++k) set_bits(map, k * bits, bits, first);
    }
  }
  return 1;
}

}  // namespace mmverify::tests::foreign::tree
