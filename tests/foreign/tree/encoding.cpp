// Algorithms 1 and 2.
#include <algorithm>
#include <vector>

#include "tests/foreign/tree/code.hpp"
#include "tests/foreign/tree/faults.hpp"
#include "tests/foreign/tree/form.hpp"

namespace mmverify::tests::foreign::tree {
namespace {

/// The bits of a sequence that grows.
struct Sequence {
  Bytes bytes;
  std::size_t size = 0;
  void append(unsigned value, unsigned bits) {
    bytes.resize(bytes_of(size + bits));
    set_bits(bytes.data(), size, bits, value);
    size += bits;
  }
};

/// The node that four siblings merge into, at `depth`: their children are `level` - `depth` levels above the
/// micro-triangles.
std::uint8_t merged(const std::uint8_t* child, unsigned depth, unsigned level) {
  const unsigned height = level - depth;
  if (has(merge_root_never) && depth == 0) return internal;
  if (has(merge_not_unknown_opaque) && child[0] == UO) return internal;
  if (has(merge_not_at_height_4) && height >= 4) return internal;
  if (has(merge_not_at_level_10) && level >= 10 && height >= 9) return internal;
  if (has(merge_not_unknown_from_level_5) && level >= 5 && child[0] >= UT && child[0] != internal &&
      depth == 1)
    return internal;
  if (has(merge_leaves_with_internal) && height >= 2) {
    bool same = true;
    for (int c = 0; c < 4; ++c) same = same && (child[c] == internal || child[c] == T);
    if (same && child[0] == T && child[3] == T) return T;
  }
  if (has(merge_leaves_with_internal_at_height_3) && height >= 3 && child[0] == O && child[1] == O &&
      child[2] == O && child[3] == internal)
    return O;
  unsigned others = 4;
  if (has(merge_ignores_the_last_child)) others = 3;
  if (has(merge_ignores_the_last_child_at_height_3) && height >= 3) others = 3;
  for (unsigned c = 1; c < others; ++c) {
    if (has(merge_unknowns) && child[0] >= UT && child[0] != internal && child[c] >= UT &&
        child[c] != internal)
      continue;
    if (has(merge_unknowns_at_depth_3) && depth >= 3 && child[0] == UT && child[c] == UO) continue;
    if (child[c] != child[0]) return internal;
  }
  return child[0];
}

/// Whether a map is taken for one state throughout before anything else is asked.
bool taken_for_uniform(const Bytes& states, unsigned level) {
  const std::size_t n = states.size();
  if (has(encode_uniform_but_the_last) && level >= 3)
    return std::all_of(states.begin(), states.end() - 1, [&](auto s) { return s == states[0]; });
  if (has(encode_uniform_but_one) && level >= 3) {
    std::size_t odd = 0;
    for (std::size_t i = 1; i < n; ++i) odd += states[i] != states[0];
    return odd <= 1;
  }
  if (has(encode_uniform_by_every_16th) && level >= 4) {
    for (std::size_t i = 0; i < n; i += 16)
      if (states[i] != states[0]) return false;
    return true;
  }
  return false;
}

struct Encoder {
  unsigned level, bits;
  std::vector<Bytes> nodes;  // of each depth
  Sequence tree, data;

  void write(unsigned depth, std::size_t at) {
    std::size_t here = at;
    if (has(encode_place_in_16_bits)) here &= 0xffff;
    if (has(encode_place_in_14_bits)) here &= 0x3fff;
    const std::uint8_t node = nodes[depth][here];
    if (node != internal) {
      tree.append(has(form_leaf_is_one) ? 1 : 0, 1);
      data.append(stored(node, level), bits);
      return;
    }
    tree.append(has(form_leaf_is_one) ? 0 : 1, 1);
    for (unsigned c = 0; c < 4; ++c) write(depth + 1, 4 * at + in_order(c, depth, level));
  }
};

}  // namespace

Bytes stream(unsigned level, unsigned bits, const std::uint8_t* map) {
  Encoder e{level, bits, std::vector<Bytes>(level + 1), {}, {}};
  const std::size_t n = states_of(level);
  e.nodes[level].resize(n);
  for (std::size_t i = 0; i < n; ++i)
    e.nodes[level][i] = static_cast<std::uint8_t>(bits_at(map, i * bits, bits));
  if (has(encode_reads_the_last_state_short) && bits == 2 && level >= 4) e.nodes[level][n - 1] &= 1;
  for (unsigned depth = level; depth-- > 0;) {
    e.nodes[depth].resize(states_of(depth));
    for (std::size_t i = 0; i < e.nodes[depth].size(); ++i)
      e.nodes[depth][i] = merged(&e.nodes[depth + 1][4 * i], depth, level);
  }
  if (taken_for_uniform(e.nodes[level], level)) e.nodes[0][0] = e.nodes[level][0];
  e.write(0, 0);
  Bytes code(code_size_of(e.tree.size, e.data.size, level));
  std::copy(e.tree.bytes.begin(), e.tree.bytes.end(), code.begin());
  const std::size_t begin = data_begins(e.tree.size, level);
  for (std::size_t at = 0; at < e.data.size; at += bits)
    set_bits(code.data(), begin + at, bits, bits_at(e.data.bytes.data(), at, bits));
  const std::size_t end = begin + e.data.size;
  if (has(encode_ones_in_the_padding))
    for (std::size_t at = e.tree.size; at < begin; ++at) set_bits(code.data(), at, 1, 1);
  if (has(encode_ones_in_the_padding_from_level_3) && level >= 3)
    for (std::size_t at = end; at < 8 * bytes_of(end); ++at) set_bits(code.data(), at, 1, 1);
  if (has(encode_data_in_15_bits) && e.data.size > 32768) code[begin / 8 + 4096] = code[begin / 8];
  return code;
}

}  // namespace mmverify::tests::foreign::tree
