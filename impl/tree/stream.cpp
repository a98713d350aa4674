#include "impl/tree/stream.hpp"

#include <algorithm>

#include "impl/tree/recursion.hpp"

namespace mmverify::impl::tree {
namespace {

using namespace detail;

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
  SequenceWriter writer{pyramid, map, n, bits(b), BitWriter(s.tree.data()), BitWriter(s.data.data())};
  if (internal > 0)
    write_node(writer, 0, 0);
  else
    s.data[0] = static_cast<std::uint8_t>(pyramid.first_state(0, 0));
  s.tree.resize(bytes_for(s.nodes));
  s.data.resize(bytes_for(data_bits));
  return s;
}

namespace detail {
namespace {

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

}  // namespace

std::optional<Fault> decode(Level n, Format b, std::span<const std::uint8_t> tree_bytes, std::uint64_t nodes,
                            std::span<const std::uint8_t> data_bytes, std::uint64_t leaves,
                            std::span<std::uint8_t> map) {
  using In = Fault::In;
  require_map(n, b, map.size());
  if (const auto fault = fault_of_sizes(n, b, tree_bytes, nodes, data_bytes, leaves)) return fault;
  std::memset(map.data(), 0, map.size());
  SequenceReader reader{n, bits(b), BitReader(tree_bytes), BitReader(data_bytes), nodes, map.data(), {}};
  const bool internal = reader.tree.within_byte(1) != 0;
  reader.tree.skip(1);
  if (!internal) {
    fill_run(map.data(), 0, std::uint64_t{bits(b)} << (2 * n),
             repeated(reader.data.within_byte(bits(b)), bits(b)));
  } else {
    if (n == 0) return Fault{In::tree, 0, "an internal node on the last level"};
    if (!read_node(reader, 0, 0)) return reader.fault;
  }
  if (reader.tree.place() == nodes) return std::nullopt;
  return Fault{In::tree, reader.tree.place(), "nodes after the end of the tree"};
}

std::uint8_t lookup(Level n, Format b, std::span<const std::uint8_t> tree, std::uint64_t nodes,
                    std::span<const std::uint8_t> data, std::uint64_t index) noexcept {
  Place at;
  if (!find_leaf(tree.data(), std::min<std::uint64_t>(nodes, 8 * tree.size()), n, index, at)) return 0;
  const std::uint64_t bit = at.leaf * bits(b);
  if (bit / 8 >= data.size()) return 0;
  return static_cast<std::uint8_t>(data[bit / 8] >> bit % 8 & low_bits(bits(b)));
}

}  // namespace detail

bool decode_stream(Level n, Format b, const Stream& s, std::span<std::uint8_t> map) {
  return !detail::decode(n, b, s.tree, s.nodes, s.data, s.leaves, map);
}

std::uint8_t lookup_stream(Level n, Format b, const Stream& s, std::uint64_t index) {
  return detail::lookup(n, b, s.tree, s.nodes, s.data, index);
}

}  // namespace mmverify::impl::tree
