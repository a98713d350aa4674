#include "impl/tree/recursion.hpp"

#include <cstring>

namespace mmverify::impl::tree::detail {
namespace {

/// The states of the four children of node k of depth n-1.
std::uint64_t last_states(const SequenceWriter& from, std::uint64_t k) noexcept {
  return from.b == 1 ? from.map[k / 2] >> (4 * (k % 2)) & 15u : from.map[k];
}

/// Writes node k of depth n-2, which is internal, with all below it at once: most of a tree is there, and branches on
/// which children are internal would be mispredicted.
void write_sixteen(SequenceWriter& to, std::uint64_t k, std::uint32_t children) noexcept {
  const std::uint32_t b = to.b;
  std::uint64_t states = 0, nodes = 1, out = 0;
  std::memcpy(&states, to.map.data() + k * 2 * b, 2 * b);
  std::uint32_t node_bits = 1, out_bits = 0;
  for (std::uint32_t c = 0; c < 4; ++c, children >>= 1, states >>= 4 * b) {
    const std::uint32_t internal = children & 1, width = internal != 0 ? 4 * b : b;
    nodes |= std::uint64_t{internal} << node_bits;
    node_bits += 1 + 4 * internal;
    out |= (states & low_bits(width)) << out_bits;
    out_bits += width;
  }
  to.tree.put(nodes, node_bits);
  to.data.put(out, out_bits);
}

/// The sixteen states below an internal node of depth n-2, from the next bits of the two sequences.
struct Sixteen {
  bool good;  ///< false: the bits are no such subtree; the fault is not reported
  std::uint32_t tree_bits, data_bits;
  std::uint64_t states;
};

Sixteen next_sixteen(std::uint64_t tree, std::uint64_t data, std::uint32_t b) noexcept {
  Sixteen r{true, 0, 0, 0};
  std::uint64_t below = 0, alike = 0, any = 0;
  for (std::uint32_t c = 0; c < 4; ++c) {
    const std::uint64_t internal = tree & 1, mask = 0 - internal;
    const std::uint64_t four = data & low_bits(4 * b),
                        leaf = repeated(data & low_bits(b), b) & low_bits(4 * b);
    below |= tree & mask & 0b11110;
    alike |= internal & static_cast<std::uint64_t>(four == leaf);
    any |= internal;
    r.states |= ((four & mask) | (leaf & ~mask)) << (4 * b * c);
    const std::uint32_t more = static_cast<std::uint32_t>(internal);
    tree >>= 1 + 4 * more;
    data >>= b + 3 * b * more;
    r.tree_bits += 1 + 4 * more;
    r.data_bits += b + 3 * b * more;
  }
  const bool one_state = any == 0 && r.states == (repeated(r.states & low_bits(b), b) & low_bits(16 * b));
  r.good = below == 0 && alike == 0 && !one_state;
  return r;
}

bool fails(SequenceReader& from, std::uint64_t bit, const char* found) noexcept {
  from.fault = {Fault::In::tree, bit, found};
  return false;
}

/// Reads the sixteen states below an internal node of depth n-2.  False: they are to be read bit by bit.
bool reads_sixteen(SequenceReader& from, std::uint64_t bit) noexcept {
  constexpr std::uint64_t most = 20;  // nodes below
  if (from.nodes - from.tree.place() < most) return false;
  const Sixteen below = next_sixteen(from.tree.peek(), from.data.peek(), from.b);
  if (!below.good) return false;
  from.tree.skip(below.tree_bits);
  from.data.skip(below.data_bits);
  std::memcpy(from.map + bit / 8, &below.states, 2 * from.b);
  return true;
}

}  // namespace

void write_node(SequenceWriter& to, Level d, std::uint64_t k) noexcept {
  const std::uint32_t b = to.b;
  if (d + 1 == to.n) {
    to.tree.put(0b00001, 5);
    to.data.put(last_states(to, k), 4 * b);
    return;
  }
  const std::uint32_t children = to.pyramid.children(d + 1, k);
  if (d + 2 == to.n) {
    write_sixteen(to, k, children);
    return;
  }
  to.tree.put(1, 1);
  std::uint32_t states = to.pyramid.first_states(d + 1, k);
  for (std::uint32_t c = 0; c < 4; ++c, states >>= b) {
    if ((children >> c & 1) != 0) {
      write_node(to, d + 1, 4 * k + c);
    } else {
      to.tree.put(0, 1);
      to.data.put(states & low_bits(b), b);
    }
  }
}

bool read_node(SequenceReader& from, Level d, std::uint64_t bit) noexcept {
  if (d + 2 == from.n && reads_sixteen(from, bit)) return true;
  const std::uint64_t run = std::uint64_t{from.b} << (2 * (from.n - d - 1));
  // The state of the leaves so far.
  constexpr std::uint32_t none = 4, mixed = 5;
  std::uint32_t state = none;
  for (std::uint32_t c = 0; c < 4; ++c, bit += run) {
    const std::uint64_t place = from.tree.place();
    if (place >= from.nodes) return fails(from, from.nodes, "an end before the last subtree");
    const bool internal = from.tree.within_byte(1) != 0;
    from.tree.skip(1);
    if (internal) {
      if (d + 1 == from.n) return fails(from, place, "an internal node on the last level");
      if (!read_node(from, d + 1, bit)) return false;
      state = mixed;
      continue;
    }
    // It exists: of so many nodes, no more than (3 nodes + 1) / 4 are leaves before the last subtree has ended.
    const std::uint32_t value = from.data.within_byte(from.b);
    from.data.skip(from.b);
    state = state == none || state == value ? value : mixed;
    fill_run(from.map, bit, run, repeated(value, from.b));
  }
  if (state == mixed) return true;
  return fails(from, from.tree.place() - 1, "the last of four sibling leaves of one state");
}

bool pass_subtrees(const std::uint8_t* tree, std::uint64_t nodes, std::uint64_t count, Place& at) noexcept {
  Place next = at;  // in registers: bytes of a tree might be those of a place
  while (count > 0)
    if (!pass_one(tree, nodes, next, count)) return false;
  at = next;
  return true;
}

bool find_leaf(const std::uint8_t* tree, std::uint64_t nodes, Level levels, std::uint64_t index,
               Place& at) noexcept {
  if (at.node >= nodes) return false;
  if (!bit_at(tree, at.node++)) return true;
  if (levels == 0) return false;
  if (!pass_subtrees(tree, nodes, index >> (2 * (levels - 1)) & 3, at)) return false;
  return find_leaf(tree, nodes, levels - 1, index, at);
}

}  // namespace mmverify::impl::tree::detail
