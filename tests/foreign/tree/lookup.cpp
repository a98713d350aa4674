// Algorithm 3.
#include "tests/foreign/tree/lookup.hpp"

#include <algorithm>

#include "tests/foreign/tree/faults.hpp"
#include "tests/foreign/tree/form.hpp"

namespace mmverify::tests::foreign::tree {

const Tree& tree_of(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size) {
  thread_local Tree tree;
  thread_local Bytes kept;
  if (has(lookup_keeps_a_tree_by_its_first_bytes) && tree.size != 0 && tree.level == level &&
      tree.bits == bits && kept.size() == size && level >= 3 &&
      std::equal(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(size, 8)),
                 code)) {
    tree.code = kept.data();
    return tree;
  }
  tree = Tree{};
  tree.level = level;
  tree.bits = bits;
  tree.code = code;
  cut(tree, size);
  if (has(lookup_keeps_a_tree_by_its_first_bytes)) kept.assign(code, code + size);
  return tree;
}

unsigned looked_up(const Tree& tree, std::uint32_t index, bool by_point) {
  std::size_t t = 0;
  unsigned depth = 0;
  if (has(lookup_index_in_16_bits)) index &= 0xffff;
  if (has(lookup_index_in_12_bits)) index &= 0xfff;
  if (has(lookup_index_in_8_bits)) index &= 0xff;
  if (has(lookup_last_index) && tree.level >= 3 && index == states_of(tree.level) - 1) --index;
  if (has(lookup_middle_index_of_level_6) && tree.level >= 6 && index == 1365) ++index;
  if (has(point_middle_of_middles) && by_point && tree.level >= 5 && index == (states_of(tree.level) - 1) / 3)
    ++index;
  while (tree.is_internal(t)) {
    unsigned digit = index >> (2 * (tree.level - depth - 1)) & 3u;
    if (has(lookup_last_child_at_depth_3) && depth >= 3 && digit == 3 && depth + 1 == tree.level) digit = 2;
    const unsigned skips = in_order(digit, depth, tree.level);
    ++t;
    for (unsigned c = 0; c < skips; ++c) {
      std::size_t next = tree.end[t];
      if (has(lookup_skips_in_8_bits)) next = t + static_cast<std::uint8_t>(next - t);
      if (has(lookup_skips_in_16_bits)) next = t + static_cast<std::uint16_t>(next - t);
      if (has(lookup_node_in_16_bits)) next &= 0xffff;
      if (has(lookup_node_in_17_bits)) next &= 0x1ffff;
      t = next;
    }
    ++depth;
    if (depth == tree.level) break;
  }
  std::size_t d = tree.before[t];
  if (has(lookup_leaf_in_15_bits)) d &= 0x7fff;
  if (has(lookup_leaf_in_16_bits)) d &= 0xffff;
  unsigned state = tree.state(d);
  if (has(lookup_uniform_loses_a_bit) && tree.size == 1) state &= 1;
  if (has(lookup_uniform_loses_a_bit_from_level_3) && tree.size == 1 && tree.level >= 3) state &= 1;
  if (has(lookup_largest_tree) && tree.level >= 3 && tree.leaves == states_of(tree.level) && index % 64 == 63)
    state ^= 1;
  return state;
}

}  // namespace mmverify::tests::foreign::tree
