#include "impl/tree/stream.hpp"

#include <algorithm>
#include <array>

#include "impl/tree/bits.hpp"
#include "impl/tree/decode.hpp"
#include "impl/tree/pyramid.hpp"

namespace mmverify::impl::tree {
namespace {

using namespace detail;

/// Algorithm 2 on the pyramid.
struct Encoder {
  const Pyramid& pyramid;
  std::span<const std::uint8_t> map;
  Level n;
  std::uint32_t b;
  BitWriter tree, data;

  /// The states of the four children of node k of depth n-1.
  std::uint64_t last_states(std::uint64_t k) const noexcept {
    return b == 1 ? map[k / 2] >> (4 * (k % 2)) & 15u : map[k];
  }

  /// Writes node k of depth n-2, which is internal, with all below it at once: most of a tree is there, and branches on
  /// which children are internal would be mispredicted.
  void sixteen(std::uint64_t k, std::uint32_t children) noexcept {
    std::uint64_t states = 0, nodes = 1, out = 0;
    std::memcpy(&states, map.data() + k * 2 * b, 2 * b);
    std::uint32_t node_bits = 1, out_bits = 0;
    for (std::uint32_t c = 0; c < 4; ++c, children >>= 1, states >>= 4 * b) {
      const std::uint32_t internal = children & 1, width = internal != 0 ? 4 * b : b;
      nodes |= std::uint64_t{internal} << node_bits;
      node_bits += 1 + 4 * internal;
      out |= (states & low_bits(width)) << out_bits;
      out_bits += width;
    }
    tree.put(nodes, node_bits);
    data.put(out, out_bits);
  }

  /// Writes node k of depth d, which is internal, and all below it.
  void internal(Level d, std::uint64_t k) noexcept {
    if (d + 1 == n) {
      tree.put(0b00001, 5);
      data.put(last_states(k), 4 * b);
      return;
    }
    const std::uint32_t children = pyramid.children(d + 1, k);
    if (d + 2 == n) {
      sixteen(k, children);
      return;
    }
    tree.put(1, 1);
    std::uint32_t states = pyramid.first_states(d + 1, k);
    for (std::uint32_t c = 0; c < 4; ++c, states >>= b) {
      if ((children >> c & 1) != 0) {
        internal(d + 1, 4 * k + c);
      } else {
        tree.put(0, 1);
        data.put(states & low_bits(b), b);
      }
    }
  }
};

/// Whether no bit at or above `bits` is set in the last byte.
bool clear_beyond(std::span<const std::uint8_t> bytes, std::uint64_t bits) noexcept {
  return bits % 8 == 0 || bytes.back() >> (bits % 8) == 0;
}

}  // namespace

Stream encode_stream(Level n, Format b, std::span<const std::uint8_t> map) {
  require_map(n, b, map.size());
  const Pyramid pyramid(n, b, map);
  const std::uint64_t internal = pyramid.internal();
  Stream s;
  s.nodes = 4 * internal + 1;
  s.leaves = 3 * internal + 1;
  const std::uint64_t data_bits = s.leaves * bits(b);
  // Writers store whole words beyond the last bit.
  s.tree.resize(bytes_for(s.nodes) + 8);
  s.data.resize(bytes_for(data_bits) + 8);
  Encoder encoder{pyramid, map, n, bits(b), BitWriter(s.tree.data()), BitWriter(s.data.data())};
  if (internal > 0)
    encoder.internal(0, 0);
  else
    s.data[0] = static_cast<std::uint8_t>(pyramid.first_state(0, 0));
  s.tree.resize(bytes_for(s.nodes));
  s.data.resize(bytes_for(data_bits));
  return s;
}

namespace detail {
namespace {

/// The sixteen states below an internal node of depth n-2, from the next bits of the two sequences.
struct Sixteen {
  bool good;  ///< false: the bits are no such subtree; the fault is not reported
  std::uint32_t tree_bits, data_bits;
  std::uint64_t states;
};

Sixteen sixteen(std::uint64_t tree, std::uint64_t data, std::uint32_t b) noexcept {
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

/// The fault of the sequences' lengths and of their last bytes.
std::optional<Fault> fault_of_sizes(Level n, Format b, std::span<const std::uint8_t> tree_bytes,
                                    std::uint64_t nodes, std::span<const std::uint8_t> data_bytes,
                                    std::uint64_t leaves) {
  using In = Fault::In;
  const std::uint64_t most = ((std::uint64_t{4} << (2 * n)) - 1) / 3;
  if (nodes > most) return Fault{In::counts, 0, "more nodes than the level has"};
  if (nodes % 4 != 1) return Fault{In::counts, 0, "a number of nodes that is not 4 i + 1"};
  if (leaves != (3 * nodes + 1) / 4)
    return Fault{In::counts, 0, "a number of leaves that is not (3 nodes + 1) / 4"};
  const std::uint64_t data_bits = leaves * bits(b);
  if (tree_bytes.size() != bytes_for(nodes)) return Fault{In::tree, nodes, "a sequence of another length"};
  if (data_bytes.size() != bytes_for(data_bits))
    return Fault{In::data, data_bits, "a sequence of another length"};
  if (!clear_beyond(tree_bytes, nodes)) return Fault{In::tree, nodes, "a padding bit that is set"};
  if (!clear_beyond(data_bytes, data_bits)) return Fault{In::data, data_bits, "a padding bit that is set"};
  return std::nullopt;
}

/// The fault of a tree whose last node is read; place: that of the next bit.
std::optional<Fault> fault_at_end(std::uint64_t place, std::uint64_t nodes) {
  if (place == nodes) return std::nullopt;
  return Fault{Fault::In::tree, place, "nodes after the end of the tree"};
}

}  // namespace

std::optional<Fault> decode(Level n, Format b, std::span<const std::uint8_t> tree_bytes, std::uint64_t nodes,
                            std::span<const std::uint8_t> data_bytes, std::uint64_t leaves,
                            std::span<std::uint8_t> map) {
  using In = Fault::In;
  require_map(n, b, map.size());
  if (const auto fault = fault_of_sizes(n, b, tree_bytes, nodes, data_bytes, leaves)) return fault;
  std::memset(map.data(), 0, map.size());
  BitReader tree(tree_bytes), data(data_bytes);
  // The siblings at each depth: how many are still to come, and their state so far, none or mixed.
  std::array<std::uint32_t, max_level + 2> left{}, state{};
  constexpr std::uint32_t none = 4, mixed = 5;
  left[0] = 1;
  state[0] = none;
  Level d = 0;
  std::uint64_t bit = 0;  // next bit of the map
  const std::uint64_t all_bits = (std::uint64_t{1} << (2 * n)) * bits(b);
  while (true) {
    const std::uint64_t place = tree.place();
    if (place >= nodes) return Fault{In::tree, nodes, "an end before the last subtree"};
    const bool internal = (tree.peek() & 1) != 0;
    tree.skip(1);
    if (internal) {
      if (d == n) return Fault{In::tree, place, "an internal node on the last level"};
      state[d] = mixed;
      if (d + 2 == n && nodes - place > 20) {
        const Sixteen below = sixteen(tree.peek(), data.peek(), bits(b));
        // The single-bit path below finds the fault, and its place.
        if (below.good) {
          tree.skip(below.tree_bits);
          data.skip(below.data_bits);
          std::memcpy(map.data() + bit / 8, &below.states, 2 * bits(b));
          bit += 16 * bits(b);
          while (--left[d] == 0) {
            if (d == 0) return fault_at_end(tree.place(), nodes);
            --d;
          }
          continue;
        }
      }
      left[++d] = 4;
      state[d] = none;
      continue;
    }
    const auto value = static_cast<std::uint32_t>(data.peek() & low_bits(bits(b)));
    data.skip(bits(b));
    state[d] = state[d] == none || state[d] == value ? value : mixed;
    const std::uint64_t run = all_bits >> (2 * d);
    fill_run(map.data(), bit, run, repeated(value, bits(b)));
    bit += run;
    while (--left[d] == 0) {
      if (d == 0) return fault_at_end(tree.place(), nodes);
      if (state[d] != mixed) return Fault{In::tree, place, "the last of four sibling leaves of one state"};
      --d;
    }
  }
}

}  // namespace detail

bool decode_stream(Level n, Format b, const Stream& s, std::span<std::uint8_t> map) {
  return !detail::decode(n, b, s.tree, s.nodes, s.data, s.leaves, map);
}

std::uint8_t lookup_stream(Level n, Format b, const Stream& s, std::uint64_t index) {
  const std::uint64_t length = std::min<std::uint64_t>(s.nodes, 8 * s.tree.size());
  const auto internal = [&s](std::uint64_t t) { return (s.tree[t >> 3] >> (t & 7) & 1) != 0; };
  std::uint64_t t = 0, d = 0;
  for (Level depth = 0;; ++depth) {
    if (t >= length) return 0;
    if (!internal(t)) break;
    if (depth == n) return 0;
    ++t;
    // bitscan: passes the subtrees of the children before the one named by the index.
    std::uint64_t child = index >> (2 * (n - depth - 1)) & 3;
    while (t < length && child > 0) {
      if (internal(t))
        child += 4;
      else
        ++d;
      --child;
      ++t;
    }
  }
  const std::uint64_t bit = d * bits(b);
  if (bit / 8 >= s.data.size()) return 0;
  return static_cast<std::uint8_t>(s.data[bit >> 3] >> (bit & 7) & low_bits(bits(b)));
}

}  // namespace mmverify::impl::tree
