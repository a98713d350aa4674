// Succinct trees of opacity micromaps, written from the paper (Algorithms 1 to 3), the header and Vulkan's rule of
// ties alone.  Each fault of the table is one slip inside this code.
//
// MMVERIFY_FOREIGN_TREE chooses what of it is handed over, none of it wrong: nothing, the paper's two bit sequences
// and all four entry points; "private", a code of our own without the flag; "encode", "decode", "lookup" and "point",
// the paper's sequences and one entry point alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

#include "sdk/mmverify_subject.h"
#include "tests/foreign/fault.hpp"

namespace {

using mmverify::tests::foreign::chosen_fault;

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/tree_faults.def"
#undef MMVERIFY_FAULT
};

constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/tree_faults.def"
#undef MMVERIFY_FAULT
};

const std::optional<int> fault = chosen_fault(fault_names);
bool has(Fault f) { return fault == f; }

const std::string_view variant = [] {
  const char* name = std::getenv("MMVERIFY_FOREIGN_TREE");
  return std::string_view(name == nullptr ? "" : name);
}();

enum State : unsigned { T = 0, O = 1, UT = 2, UO = 3 };
constexpr std::uint8_t internal = 4;  // of a node that is no leaf; a leaf has its state

using Bytes = std::vector<std::uint8_t>;

std::size_t states_of(unsigned level) { return std::size_t{1} << (2 * level); }
std::size_t bytes_of(std::size_t bits) { return (bits + 7) / 8; }

unsigned bit_at(const std::uint8_t* bytes, std::size_t at) { return (bytes[at / 8] >> (at % 8)) & 1u; }

unsigned bits_at(const std::uint8_t* bytes, std::size_t at, unsigned bits) {
  unsigned value = 0;
  for (unsigned b = 0; b < bits; ++b) value |= bit_at(bytes, at + b) << b;
  return value;
}

void set_bits(std::uint8_t* bytes, std::size_t at, unsigned bits, unsigned value) {
  for (unsigned b = 0; b < bits; ++b)
    if ((value >> b & 1u) != 0)
      bytes[(at + b) / 8] = static_cast<std::uint8_t>(bytes[(at + b) / 8] | 1u << (at + b) % 8);
}

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

// ---- the form, where the faults change encoder, decoder and lookups alike

/// The child that comes c-th; its own inverse.
unsigned in_order(unsigned c, unsigned depth, unsigned level) {
  if (has(form_stack_order)) return 3 - c;
  if (has(form_stack_order_from_level_4) && level >= 4) return 3 - c;
  if (has(form_stack_order_at_depth_3) && depth >= 3) return 3 - c;
  return c;
}

unsigned stored(unsigned state, unsigned level) {
  return has(form_exchanges_unknowns_from_level_3) && level >= 3 && state >= UT ? state ^ 1u : state;
}

std::size_t data_begins(std::size_t tree_bits, unsigned level) {
  if (has(form_data_at_once_from_level_3) && level >= 3) return tree_bits;
  return 8 * bytes_of(tree_bits);
}

std::size_t code_size_of(std::size_t tree_bits, std::size_t data_bits, unsigned level) {
  std::size_t size = bytes_of(data_begins(tree_bits, level) + data_bits);
  if (has(form_a_spare_byte) && level >= 2 && data_bits % 8 == 0) ++size;
  if (has(form_a_spare_byte_from_level_5) && level >= 5 && data_bits % 8 == 0) ++size;
  if (has(form_data_of_whole_words) && level >= 3)
    size = bytes_of(tree_bits) + (bytes_of(data_bits) + 3) / 4 * 4;
  return size;
}

// ---- Algorithms 1 and 2

/// What four siblings become, at `depth`, the children of level `level` - `depth` above the micro-triangles.
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

// ---- what a code holds, and whether it is one

/// The tree's bits, cut into nodes.
struct Tree {
  unsigned level = 0, bits = 0;
  const std::uint8_t* code = nullptr;
  std::size_t size = 0;  // nodes
  std::size_t leaves = 0;
  std::size_t data = 0;               // where they begin, in bits
  std::vector<std::uint32_t> end;     // of each node, the node after its last descendant
  std::vector<std::uint32_t> before;  // of each node, the leaves before it

  bool is_internal(std::size_t t) const { return bit_at(code, t) == (has(form_leaf_is_one) ? 0u : 1u); }
  unsigned state(std::size_t d) const {
    if (has(lookup_leaf_in_8_bits)) d &= 0xff;
    return stored(bits_at(code, data + d * bits, bits), level);
  }
};

/// Whether the code begins with a tree that is no deeper than its level, and then that tree.
bool cut(Tree& tree, std::size_t code_size) {
  std::vector<std::uint32_t> open;  // how many children of each node on the path are still to come
  std::vector<std::uint32_t> path;
  std::size_t t = 0;
  for (;;) {
    if (t >= 8 * code_size) return false;
    tree.end.push_back(0);
    tree.before.push_back(static_cast<std::uint32_t>(tree.leaves));
    if (tree.is_internal(t)) {
      bool too_deep = path.size() >= tree.level;
      if (has(decode_takes_deeper_trees) && tree.level >= 3 && path.size() == tree.level) too_deep = false;
      if (too_deep) return false;
      path.push_back(static_cast<std::uint32_t>(t));
      open.push_back(4);
      ++t;
      continue;
    }
    ++tree.leaves;
    ++t;
    tree.end[t - 1] = static_cast<std::uint32_t>(t);
    while (!open.empty() && --open.back() == 0) {
      tree.end[path.back()] = static_cast<std::uint32_t>(t);
      path.pop_back();
      open.pop_back();
    }
    if (open.empty()) break;
  }
  tree.size = t;
  tree.data = data_begins(tree.size, tree.level);
  return true;
}

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
  // Of one internal node a depth: a map that is uniform but for one state, or nearly so.
  if (has(decode_background_is_the_first_leaf) && level >= 3 && tree.leaves == 3 * level + 1) {
    const unsigned first = bits_at(map, 0, bits);
    if (bits_at(map, bits, bits) != first) {
      std::memset(map, 0, bytes_of(states_of(level) * bits));
      for (std::size_t k = 0; k < states_of(level); ++k) set_bits(map, k * bits, bits, first);
    }
  }
  return 1;
}

// ---- Algorithm 3

/// A lookup's tree: that of the code, or one kept from an earlier call.
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

// ---- the index of a point

/// Algorithm 4 as printed, in the given arithmetic.
template <class Real>
std::uint32_t stepped(unsigned level, Real u, Real v, bool ties = true) {
  Real w = 1 - u - v;
  std::uint32_t index = 0;
  bool mid = false, top = false;
  for (unsigned depth = 0; depth < level; ++depth) {
    const std::uint32_t left = top ? 2 : 0, right = top ? 0 : 2;
    const Real half = Real(1) / 2;
    if (w > half) {
      const Real next = w - u - v;
      u = 2 * u, v = 2 * v, w = next, index = 4 * index + left;
    } else if (v >= half && !(ties && v == half && mid)) {
      const Real next = v - u - w;
      u = 2 * u, w = 2 * w, v = next, index = 4 * index + 3, top = !top;
    } else if (u >= half && !(ties && v == half && mid)) {
      const Real next = u - v - w;
      v = 2 * v, w = 2 * w, u = next, index = 4 * index + right;
    } else {
      const Real nu = u + v - w, nv = w + u - v, nw = v + w - u;
      u = nu, v = nv, w = nw, index = 4 * index + 1, mid = !mid;
    }
  }
  return index;
}

std::uint32_t spread(std::uint32_t x) {
  std::uint32_t wide = 0;
  for (unsigned b = 0; b < 16; ++b) wide |= (x >> b & 1u) << (2 * b);
  return wide;
}

/// A number cut to `bits` significant bits.
float shortened(float x, int bits) {
  int exponent = 0;
  const float significand = std::frexp(x, &exponent);
  return std::ldexp(std::trunc(std::ldexp(significand, bits)), exponent - bits);
}

/// Vulkan's index of (u, v); its one sum is asked so that nothing rounds: 1 - u is exact in binary64 unless u is
/// below 2^-29, and then no binary32 number below 1 reaches it, rounded or not.
std::uint32_t index_of(unsigned level, float u, float v) {
  if (has(point_of_16_bits)) u = std::floor(u * 65536) / 65536, v = std::floor(v * 65536) / 65536;
  if (has(point_of_binary16)) u = shortened(u, 11), v = shortened(v, 11);
  if (has(point_of_20_significant_bits)) u = shortened(u, 20), v = shortened(v, 20);
  if (has(point_nudged)) u += 1.0f / 16777216, v += 1.0f / 16777216;
  if (has(point_by_steps_in_binary32)) return stepped<float>(level, u, v);
  if (has(point_by_steps_in_binary32_from_level_4) && level >= 4) return stepped<float>(level, u, v);
  if (has(point_by_steps_without_ties)) return stepped<double>(level, u, v, false);
  const std::uint32_t n = 1u << level;
  const double un = std::clamp<double>(u, 0, 1) * n, vn = std::clamp<double>(v, 0, 1) * n;
  std::uint32_t iu = std::min(static_cast<std::uint32_t>(un), n - 1);
  std::uint32_t iv = std::min(static_cast<std::uint32_t>(vn), n - 1);
  const double uf = un - std::floor(un), vf = vn - std::floor(vn);
  const std::uint32_t sum = iu + iv;
  if (sum >= n) {
    if (has(point_lowers_v))
      iv -= std::min(iv, sum - n + 1);
    else if (!has(point_leaves_the_triangle))
      iu -= std::min(iu, sum - n + 1);
  }
  bool beyond = vf >= 1 - uf;
  if (has(point_sum_in_binary32)) beyond = static_cast<float>(uf) + static_cast<float>(vf) >= 1;
  if (has(point_diagonal_is_below)) beyond = uf + vf > 1;
  if (has(point_diagonal_is_below_from_level_3) && level >= 3) beyond = uf + vf > 1;
  if (has(point_w_in_binary32))
    beyond = n - 1 - sum != static_cast<std::uint32_t>(std::max(0.0f, (1 - u - v) * static_cast<float>(n)));
  std::uint32_t iw = ~(iu + iv);
  const bool on_hypotenuse = has(point_hypotenuse_as_inside) ? sum < n : sum < n - 1;
  if (beyond && on_hypotenuse) --iw;
  const std::uint32_t b0 = ~(iu ^ iw) & (n - 1), t = (iu ^ iv) & b0;
  std::uint32_t f = t;
  f ^= f >> 1;
  f ^= f >> 2;
  f ^= f >> 4;
  if (!has(point_prefix_of_8_bits)) f ^= f >> 8;
  const std::uint32_t b1 = ((f ^ iu) & ~b0 & (n - 1)) | t;
  return spread(b0) | spread(b1) << 1;
}

// ---- a code of our own: a byte that says how, then the map as it is, or the tree's and the leaves' bits

Bytes private_code(unsigned level, unsigned bits, const std::uint8_t* map) {
  const std::size_t flat = bytes_of(states_of(level) * bits);
  Bytes code{1};
  const Bytes tree = stream(level, bits, map);
  if (tree.size() < flat || level == 0) {
    code.insert(code.end(), tree.begin(), tree.end());
    return code;
  }
  code[0] = 0;
  code.insert(code.end(), map, map + flat);
  return code;
}

int decode_private(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size,
                   std::uint8_t* map) {
  const std::size_t flat = bytes_of(states_of(level) * bits);
  Bytes got(flat);
  if (size == 0) return 0;
  if (code[0] == 0) {
    if (size < flat + 1) return 0;
    if (size > flat + 1 && !(has(private_takes_longer_flat_from_level_3) && level >= 3)) return 0;
    got.assign(code + 1, code + 1 + flat);
  } else if (decode_stream(level, bits, code + 1, size - 1, got.data()) == 0) {
    return 0;
  }
  const Bytes again = private_code(level, bits, got.data());
  bool same = again.size() == size && std::equal(again.begin(), again.end(), code);
  if (has(private_takes_any_first_byte) && code[0] != 0) same = true;
  if (has(private_takes_flat_where_a_tree_is_due) && code[0] == 0) same = true;
  if (has(private_takes_a_tree_where_flat_is_due) && code[0] == 1) same = true;
  if (has(private_takes_longer_flat_from_level_3) && code[0] == 0 && level >= 3) same = true;
  if (!same) return 0;
  std::copy(got.begin(), got.end(), map);
  return 1;
}

// ---- entry points

/// A fault of the private form asks for it.
bool is_private() {
  return variant == "private" || has(private_takes_any_first_byte) ||
         has(private_takes_flat_where_a_tree_is_due) || has(private_takes_a_tree_where_flat_is_due) ||
         has(private_takes_longer_flat_from_level_3);
}

std::size_t tree_encode(std::uint32_t level, std::uint32_t format, const std::uint8_t* map,
                        std::uint8_t* code, std::size_t capacity) {
  const Bytes found = is_private() ? private_code(level, format, map) : stream(level, format, map);
  const std::size_t size = found.size();
  if (has(encode_gives_up_at_level_11) && level >= 11) return 0;
  bool fits = capacity >= size;
  if (has(encode_wants_a_byte_to_spare)) fits = capacity > size;
  if (has(encode_wants_a_byte_to_spare_from_level_3)) fits = capacity >= size + (level >= 3 ? 1 : 0);
  if (has(encode_writes_one_byte_too_many)) fits = capacity + 1 >= size;
  if (!fits && has(encode_says_what_fitted)) return std::max<std::size_t>(capacity, 1);
  if (!fits && has(encode_says_a_bound_without_room)) return size + 1;
  if (!fits && has(encode_says_nothing_without_room) && capacity == 0) return 0;
  if (!fits) return size;
  for (std::size_t k = 0; k < size; ++k)
    code[k] = has(encode_leaves_old_bits) ? static_cast<std::uint8_t>(code[k] | found[k]) : found[k];
  return size;
}

int tree_decode(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
                std::uint8_t* map) {
  return is_private() ? decode_private(level, format, code, size, map)
                      : decode_stream(level, format, code, size, map);
}

/// A lookup in any of the two forms.
template <class IndexOf>
void look_up(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size, std::uint8_t* state,
             std::size_t count, bool by_point, IndexOf index) {
  if (is_private() && code[0] == 0) {
    for (std::size_t k = 0; k < count; ++k)
      state[k] = static_cast<std::uint8_t>(bits_at(code + 1, std::size_t{index(k)} * bits, bits));
    return;
  }
  const Tree& tree =
      is_private() ? tree_of(level, bits, code + 1, size - 1) : tree_of(level, bits, code, size);
  for (std::size_t k = 0; k < count; ++k)
    state[k] = static_cast<std::uint8_t>(looked_up(tree, index(k), by_point));
  if (has(lookup_rest_of_a_batch) && count > 64 && count % 64 != 0) state[count - 1] = state[0];
}

void tree_lookup(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
                 const std::uint32_t* index, std::uint8_t* state, std::size_t count) {
  look_up(level, format, code, size, state, count, false, [&](std::size_t k) { return index[k]; });
}

void tree_lookup_f32(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
                     const float* u, const float* v, std::uint8_t* state, std::size_t count) {
  look_up(level, format, code, size, state, count, true, [&](std::size_t k) {
    if (has(point_exchanges_axes)) return index_of(level, v[k], u[k]);
    return index_of(level, u[k], v[k]);
  });
}

mmverify_subject_t make() {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "foreign tree";
  s.max_level = 12;
  s.flags = is_private() ? 0u : MMVERIFY_TREE_STREAM;
  const bool all = variant.empty() || is_private();
  if (all || variant == "encode") s.tree_encode = tree_encode;
  if (all || variant == "decode") s.tree_decode = tree_decode;
  if (all || variant == "lookup") s.tree_lookup = tree_lookup;
  if (all || variant == "point") s.tree_lookup_f32 = tree_lookup_f32;
  return s;
}

const mmverify_subject_t subject = make();

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) { return fault ? &subject : nullptr; }
