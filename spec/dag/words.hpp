// The words of a graph, and its container.  docs/DAG.md has both as tables.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "spec/dag/dag.hpp"

namespace mmverify::spec::dag {

/// Writes numbers little-endian, one after another.
class Writer {
 public:
  void put(std::uint64_t x, unsigned bytes) {
    for (unsigned k = 0; k < bytes; ++k) all.push_back(static_cast<std::uint8_t>(x >> 8 * k));
  }
  void put(const States& states, Format f) {
    const Bytes packed = micromap::pack(states, f);
    all.insert(all.end(), packed.begin(), packed.end());
  }
  void pad_to(std::size_t multiple) {
    while (all.size() % multiple != 0) all.push_back(0);
  }
  Bytes all;
};

/// The four arrays as bytes.
struct Words {
  Bytes records, tiles, flat, nodes;
  friend bool operator==(const Words&, const Words&) = default;
};

/// A node in words: its masks, then its children that are mixed.
/// reference: the references of the nodes before it, by their numbers.
inline void put_node(Writer& nodes, const Node& node, Format f, const std::vector<std::uint64_t>& reference) {
  const bool is_wide = wide(node);
  std::uint64_t mask = 0, plane[2] = {0, 0};
  for (std::size_t k = 0; k < node.children.size(); ++k) {
    const Part& child = node.children[k];
    const std::uint64_t state = child.mixed() ? 0 : micromap::code(*child.one_state);
    mask |= std::uint64_t{child.mixed()} << k;
    plane[0] |= (state & 1) << k;
    plane[1] |= (state >> 1) << k;
  }
  nodes.put(mask, 2);
  for (unsigned k = 0; k < micromap::bits(f); ++k) nodes.put(plane[k], 2);
  if (is_wide) nodes.pad_to(4);
  for (const Part& child : node.children)
    if (child.mixed())
      nodes.put(child_level(node.level) == tile_level ? child.number : reference.at(child.number),
                is_wide ? 4 : 2);
  nodes.pad_to(4);
}

/// The last word of a map's record: its states, or where they are.
inline std::uint64_t value_of(const Map& map, Format f, const std::vector<std::uint64_t>& reference) {
  switch (map.kind) {
    case Map::Kind::small: {
      std::uint64_t value = 0;
      const Bytes packed = micromap::pack(map.states, f);
      for (std::size_t k = 0; k < packed.size(); ++k) value |= std::uint64_t{packed[k]} << 8 * k;
      return value;
    }
    case Map::Kind::uniform: return micromap::code(*map.root.one_state);
    case Map::Kind::tile: return map.root.number;
    case Map::Kind::node: return reference.at(map.root.number);
    case Map::Kind::flat: return map.flat_from;
  }
  return 0;
}

inline Words arrays(const Dag& dag) {
  std::vector<std::uint64_t> reference;  // by the number of a node
  Writer nodes, tiles, flat, records;
  for (const Node& node : dag.nodes) {
    reference.push_back(2 * (nodes.all.size() / 4) + (wide(node) ? 1 : 0));
    put_node(nodes, node, dag.format, reference);
  }
  for (const Node& tile : dag.tiles) {
    States states;
    for (const Part& child : tile.children) states.push_back(child.one_state.value());
    tiles.put(states, dag.format);
  }
  for (const auto& [level, states] : dag.flat) flat.put(states, dag.format);
  for (const Map& map : dag.maps) {
    records.put(map.level, 1);
    records.put(static_cast<std::uint8_t>(map.kind), 1);
    records.put(0, 2);
    records.put(value_of(map, dag.format, reference), 4);
  }
  return {records.all, tiles.all, flat.all, nodes.all};
}

/// CRC-32C (Castagnoli), bit by bit: reflected polynomial 0x82f63b78, all ones before and inverted after.
inline std::uint32_t crc32c(std::span<const std::uint8_t> bytes, std::uint32_t before = 0) {
  std::uint32_t crc = ~before;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82f63b78u : 0u);
  }
  return ~crc;
}

inline constexpr std::size_t header_bytes = 32, crc_at = 28;

/// The CRC of a container's bytes but for its own four.  Domain: a header or more.
inline std::uint32_t checksum(std::span<const std::uint8_t> container) {
  return crc32c(container.subspan(header_bytes), crc32c(container.first(crc_at)));
}

inline Bytes container(const Dag& dag) {
  const Words words = arrays(dag);
  Writer out;
  for (const char c : {'m', 'm', 'd', 'g'}) out.put(static_cast<std::uint8_t>(c), 1);
  out.put(1, 1);
  out.put(micromap::bits(dag.format), 1);
  out.put(0, 2);
  out.put(words.records.size() / 8, 4);
  out.put(dag.tiles.size(), 4);
  out.put(words.flat.size() / (8 * micromap::bits(dag.format)), 4);
  out.put(words.nodes.size() / 4, 4);
  out.put(0, 8);
  for (const Bytes* array : {&words.records, &words.tiles, &words.flat, &words.nodes})
    out.all.insert(out.all.end(), array->begin(), array->end());
  const std::uint32_t crc = checksum(out.all);
  for (unsigned k = 0; k < 4; ++k) out.all[crc_at + k] = static_cast<std::uint8_t>(crc >> 8 * k);
  return out.all;
}

// ---- Back from bytes

/// The maps of a container's bytes, or nothing for a map if a place is outside the arrays, or if its record's kind does
/// not exist at its level.
class Reader {
 public:
  Reader(std::span<const std::uint8_t> bytes, unsigned b) : bytes_(bytes), b_(b) {
    records_ = header_bytes;
    tiles_ = records_ + 8 * number(8, 4).value_or(0);
    flat_ = tiles_ + 8 * b * number(12, 4).value_or(0);
    nodes_ = flat_ + 8 * b * number(16, 4).value_or(0);
    end_ = nodes_ + 4 * number(20, 4).value_or(0);
  }
  bool whole() const { return bytes_.size() == end_; }
  std::uint64_t maps() const { return (tiles_ - records_) / 8; }
  std::uint64_t level(std::uint64_t map) const { return number(records_ + 8 * map, 1).value_or(0xFF); }

  std::optional<States> map(std::uint64_t map) const {
    const Level n = static_cast<Level>(level(map));
    const std::uint64_t kind = bytes_[records_ + 8 * map + 1], value = *number(records_ + 8 * map + 4, 4);
    const std::uint64_t all = micromap::micro_triangles(n);
    if (kind == 0 && n < tile_level) return states(records_ + 8 * map + 4, all, tiles_);
    if (kind == 1) return States(all, State(value & 3));
    if (kind == 2 && n == tile_level) return states(tiles_ + 8 * b_ * value, all, flat_);
    if (kind == 3 && n > tile_level) return node(value, n);
    if (kind == 4 && n > tile_level) return states(flat_ + 8 * b_ * value, all, nodes_);
    return std::nullopt;
  }

 private:
  std::optional<std::uint64_t> number(std::uint64_t at, unsigned bytes) const {
    if (at + bytes > bytes_.size()) return std::nullopt;
    std::uint64_t x = 0;
    for (unsigned k = 0; k < bytes; ++k) x |= std::uint64_t{bytes_[at + k]} << 8 * k;
    return x;
  }
  std::optional<States> states(std::uint64_t at, std::uint64_t count, std::uint64_t end) const {
    const std::uint64_t size = micromap::packed_bytes(count, format());
    if (at + size > end) return std::nullopt;
    return micromap::unpack(bytes_.subspan(at, size), format(), count);
  }
  std::optional<States> node(std::uint64_t reference, Level m) const {
    const std::uint64_t at = nodes_ + 4 * (reference / 2);
    const bool is_wide = reference % 2 == 1;
    const Level below = child_level(m);
    const auto mask = number(at, 2), low = number(at + 2, 2), high = b_ == 2 ? number(at + 4, 2) : 0;
    if (!mask || !low || !high) return std::nullopt;
    std::uint64_t next = at + (is_wide ? 4 * b_ : 2 + 2 * b_);
    States out;
    for (std::uint64_t k = 0; k < children(m); ++k) {
      if ((*mask >> k & 1) == 0) {
        out.insert(out.end(), micromap::micro_triangles(below),
                   State((*low >> k & 1) | (*high >> k & 1) << 1));
        continue;
      }
      const auto child = number(next, is_wide ? 4 : 2);
      next += is_wide ? 4 : 2;
      if (!child) return std::nullopt;
      const auto found =
          below == tile_level ? states(tiles_ + 8 * b_ * *child, 64, flat_) : node(*child, below);
      if (!found) return std::nullopt;
      out.insert(out.end(), found->begin(), found->end());
    }
    return out;
  }
  Format format() const { return b_ == 1 ? Format::two_state : Format::four_state; }

  std::span<const std::uint8_t> bytes_;
  unsigned b_;
  std::uint64_t records_, tiles_, flat_, nodes_, end_;
};

/// The graph of a container; none if adding the maps that the bytes mean does not give these very bytes.
/// Time: linear in the size of the maps.
inline std::optional<Dag> from_container(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < header_bytes || (bytes[5] != 1 && bytes[5] != 2)) return std::nullopt;
  const Reader reader(bytes, bytes[5]);
  if (!reader.whole()) return std::nullopt;
  Builder again(bytes[5] == 1 ? Format::two_state : Format::four_state);
  for (std::uint64_t k = 0; k < reader.maps(); ++k) {
    if (reader.level(k) > 12) return std::nullopt;
    const auto map = reader.map(k);
    if (!map) return std::nullopt;
    for (const State s : *map)
      if (!micromap::holds(again.dag().format, s)) return std::nullopt;
    again.add(static_cast<Level>(reader.level(k)), *map);
  }
  const Bytes same = container(again.dag());
  if (!std::equal(bytes.begin(), bytes.end(), same.begin(), same.end())) return std::nullopt;
  return again.dag();
}

}  // namespace mmverify::spec::dag
