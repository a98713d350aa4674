#include "impl/tree/container.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "impl/tree/bits.hpp"
#include "impl/tree/decode.hpp"
#include "impl/tree/pyramid.hpp"

namespace mmverify::impl::tree {
namespace {

constexpr std::array<std::uint8_t, 4> magic{'m', 'm', 't', 'r'};
constexpr std::uint8_t version = 1;
enum Kind : std::uint8_t { flat = 0, tree = 1 };
constexpr std::size_t crc_at = 12;

/// CRC-32C (Castagnoli): reflected polynomial 0x82f63b78, a byte at a time.
constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82f63b78u : 0u);
    table[byte] = crc;
  }
  return table;
}();

constexpr std::uint32_t crc_over(std::uint32_t crc, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) crc = crc >> 8 ^ crc_table[(crc ^ byte) & 255];
  return crc;
}

/// The CRC of all bytes but its own four.  Domain: at least a header's bytes.
std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  return ~crc_over(crc_over(~std::uint32_t{0}, bytes.first(crc_at)), bytes.subspan(container_header));
}

std::uint32_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint32_t>(detail::load_word(bytes.data() + at, 4));
}

void set_word(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t word) {
  std::memcpy(bytes.data() + at, &word, sizeof word);
}

/// The sizes in bytes of a map and of its tree's two sequences.
struct Sizes {
  std::uint64_t map, tree, data;
  bool flat() const { return tree + data >= map; }
};

Sizes sizes(Level n, Format b, std::uint64_t internal) {
  const std::uint64_t width = static_cast<std::uint32_t>(b);
  return {detail::bytes_for((std::uint64_t{1} << (2 * n)) * width), detail::bytes_for(4 * internal + 1),
          detail::bytes_for((3 * internal + 1) * width)};
}

std::string number(std::uint64_t x) { return std::to_string(x); }

std::string hex(std::uint32_t x) {
  std::string text = "0x";
  for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[x >> shift & 15];
  return text;
}

/// The greatest number of internal nodes of a level: all nodes above the micro-triangles.
std::uint64_t most_internal(Level n) { return ((std::uint64_t{1} << (2 * n)) - 1) / 3; }

/// The text of a refusal: the fault, and values that would do.
using Complaint = std::pair<std::string, std::string>;

/// The flat map of the payload, or refuse(byte, complain), as read_or() has it.
template <class Refuse>
std::optional<Contents> flat_map_or(std::span<const std::uint8_t> bytes, Level n, Format b,
                                    const Refuse& refuse) {
  const auto payload = bytes.subspan(container_header);
  Contents contents{n, b, {}};
  const std::uint64_t used = (std::uint64_t{1} << (2 * n)) * static_cast<std::uint32_t>(b);
  if (used < 8 && payload.back() >> used != 0)
    return refuse(bytes.size() - 1, [] { return Complaint("a padding bit that is set", "zeros"); });
  contents.map.assign(payload.begin(), payload.end());
  const std::uint64_t nodes = detail::Pyramid(n, b, contents.map).internal();
  if (!sizes(n, b, nodes).flat())
    return refuse(7, [&] {
      return Complaint("a flat map whose tree is smaller",
                       "the tree of " + number(nodes) + " internal nodes");
    });
  return contents;
}

/// The map of the payload's tree.
template <class Refuse>
std::optional<Contents> tree_map_or(std::span<const std::uint8_t> bytes, Level n, Format b,
                                    std::uint64_t internal, const Refuse& refuse) {
  const auto payload = bytes.subspan(container_header);
  const Sizes size = sizes(n, b, internal);
  Contents contents{n, b, {}};
  contents.map.resize(size.map);
  const auto fault = detail::decode(n, b, payload.first(size.tree), 4 * internal + 1,
                                    payload.subspan(size.tree), 3 * internal + 1, contents.map);
  if (!fault) return contents;
  const bool in_data = fault->in == detail::Fault::In::data;
  return refuse(container_header + static_cast<std::size_t>((in_data ? size.tree : 0) + fault->bit / 8), [&] {
    return Complaint(std::string(fault->found) + ", bit " + number(fault->bit) + " of the " +
                         (in_data ? "states" : "tree"),
                     "the tree of a map");
  });
}

/// The contents, or refuse(byte, complain); complain() makes the Complaint.
template <class Refuse>
std::optional<Contents> read_or(std::span<const std::uint8_t> bytes, const Refuse& refuse) {
  if (bytes.size() < container_header)
    return refuse(bytes.size(), [] { return Complaint("the end of the input", "a header of 16 bytes"); });
  if (!std::equal(magic.begin(), magic.end(), bytes.begin()))
    return refuse(0, [&] { return Complaint(hex(word_at(bytes, 0)), "\"mmtr\""); });
  if (bytes[4] != version)
    return refuse(4, [&] { return Complaint("version " + number(bytes[4]), "version 1"); });
  const Level n = bytes[5];
  if (n > max_level) return refuse(5, [&] { return Complaint("level " + number(n), "0 to 12"); });
  if (bytes[6] != 1 && bytes[6] != 2)
    return refuse(
        6, [&] { return Complaint("format " + number(bytes[6]), "1 (two states) or 2 (four states)"); });
  const Format b{bytes[6]};
  if (bytes[7] != Kind::flat && bytes[7] != Kind::tree)
    return refuse(7, [&] { return Complaint("kind " + number(bytes[7]), "0 (flat) or 1 (tree)"); });
  const bool is_flat = bytes[7] == Kind::flat;
  const std::uint64_t internal = word_at(bytes, 8);
  if (is_flat && internal != 0)
    return refuse(8, [&] { return Complaint(number(internal) + " internal nodes of a flat map", "0"); });
  if (internal > most_internal(n))
    return refuse(8, [&] {
      return Complaint(number(internal) + " internal nodes", "at most " + number(most_internal(n)));
    });
  const Sizes size = sizes(n, b, internal);
  if (!is_flat && size.flat())
    return refuse(8, [&] {
      return Complaint(number(internal) + " internal nodes, more bytes than the map", "the flat map");
    });
  const std::uint64_t length = container_header + (is_flat ? size.map : size.tree + size.data);
  if (bytes.size() != length)
    return refuse(static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), length)), [&] {
      return Complaint(bytes.size() < length ? "the end of the input" : "bytes after the end",
                       number(length) + " bytes");
    });
  const std::uint32_t crc = checksum(bytes);
  if (word_at(bytes, crc_at) != crc)
    return refuse(crc_at, [&] {
      return Complaint("checksum " + hex(word_at(bytes, crc_at)), "for these bytes " + hex(crc));
    });
  return is_flat ? flat_map_or(bytes, n, b, refuse) : tree_map_or(bytes, n, b, internal, refuse);
}

}  // namespace

BadContainer::BadContainer(std::size_t byte, const std::string& found, const std::string& would_do)
    : std::runtime_error("byte " + number(byte) + ": " + found + "; " + would_do + " would do"),
      byte_(byte) {}

std::vector<std::uint8_t> write(Level n, Format b, std::span<const std::uint8_t> map) {
  detail::require_map(n, b, map.size());
  const Stream s = encode_stream(n, b, map);
  const std::uint64_t internal = s.nodes / 4;
  const bool is_flat = sizes(n, b, internal).flat();

  std::vector<std::uint8_t> bytes(container_header);
  bytes.reserve(container_header + (is_flat ? map.size() : s.tree.size() + s.data.size()));
  std::copy(magic.begin(), magic.end(), bytes.begin());
  bytes[4] = version;
  bytes[5] = static_cast<std::uint8_t>(n);
  bytes[6] = static_cast<std::uint8_t>(b);
  bytes[7] = is_flat ? Kind::flat : Kind::tree;
  if (is_flat) {
    bytes.insert(bytes.end(), map.begin(), map.end());
    const std::uint64_t used = (std::uint64_t{1} << (2 * n)) * static_cast<std::uint32_t>(b);
    if (used < 8)
      bytes.back() &= static_cast<std::uint8_t>(detail::low_bits(static_cast<std::uint32_t>(used)));
  } else {
    set_word(bytes, 8, static_cast<std::uint32_t>(internal));
    bytes.insert(bytes.end(), s.tree.begin(), s.tree.end());
    bytes.insert(bytes.end(), s.data.begin(), s.data.end());
  }
  set_word(bytes, crc_at, checksum(bytes));
  return bytes;
}

Contents read(std::span<const std::uint8_t> bytes) {
  return *read_or(bytes, [](std::size_t byte, const auto& complain) -> std::optional<Contents> {
    const auto [found, would_do] = complain();
    throw BadContainer(byte, found, would_do);
  });
}

std::optional<Contents> try_read(std::span<const std::uint8_t> bytes) {
  return read_or(bytes, [](std::size_t, const auto&) { return std::optional<Contents>(); });
}

}  // namespace mmverify::impl::tree
