#include "impl/dag/container.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "impl/common/crc32c.hpp"
#include "impl/dag/known.hpp"
#include "impl/dag/node.hpp"

namespace mmverify::impl::dag {

using namespace detail;

namespace {

constexpr std::array<std::uint8_t, 4> magic{'m', 'm', 'd', 'g'};
constexpr std::uint8_t version = 1;
constexpr std::size_t crc_at = 28;

template <class Word>
Word word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  Word word;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

/// The CRC of all bytes but its own four.  Domain: a header's bytes or more.
std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  return crc32c(bytes.subspan(container_header), crc32c(bytes.first(crc_at)));
}

std::string number(std::uint64_t x) { return std::to_string(x); }

std::string hex(std::uint32_t x) {
  std::string text = "0x";
  for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[x >> shift & 15];
  return text;
}

/// The places of a container's arrays.
struct Sections {
  std::uint64_t maps = 0, tiles = 0, flat = 0, nodes = 0;  ///< numbers of entries
  std::uint64_t tiles_at = 0, flat_at = 0, nodes_at = 0, end = 0;

  Sections(std::span<const std::uint8_t> header, std::uint64_t b)
      : maps(word_at<std::uint32_t>(header, 8)),
        tiles(word_at<std::uint32_t>(header, 12)),
        flat(word_at<std::uint32_t>(header, 16)),
        nodes(word_at<std::uint32_t>(header, 20)),
        tiles_at(container_header + 8 * maps),
        flat_at(tiles_at + 8 * b * tiles),
        nodes_at(flat_at + 8 * b * flat),
        end(nodes_at + 4 * nodes) {}
};

}  // namespace

/// Adds the maps of a container to a graph, one by one: every new tile and node must lie where adding the map would put
/// it.
class Replay {
 public:
  Replay(std::span<const std::uint8_t> bytes, Dag& dag)
      : bytes_(bytes), in_(bytes, dag.b_), dag_(dag), b_(dag.b_), known_(in_.nodes) {}

  void all() {
    for (std::uint64_t k = 0; k < in_.maps; ++k) map(k);
    dag_.known_->added = {};
    if (dag_.tiles_.size() != b_ * in_.tiles)
      bad(in_.tiles_at + 8 * dag_.tiles_.size(), "tile " + number(dag_.tiles_.size() / b_),
          "a tile that no map has", "the end of the tiles");
    if (dag_.flat_.size() != b_ * in_.flat)
      bad(in_.flat_at + 8 * dag_.flat_.size(), "flat " + number(dag_.flat_.size() / b_),
          "states that no map has", "the end of the flat maps");
    if (dag_.nodes_.size() != in_.nodes)
      bad(in_.nodes_at + 4 * dag_.nodes_.size(), "word " + number(dag_.nodes_.size()),
          "a node that no map has", "the end of the nodes");
  }

 private:
  [[noreturn]] static void bad(std::uint64_t byte, const std::string& where, const std::string& found,
                               const std::string& would_do) {
    throw BadContainer(static_cast<std::size_t>(byte), where, found, would_do);
  }

  // ---- Records

  [[noreturn]] void bad_record(const std::string& found, const std::string& would_do,
                               std::uint64_t field = 4) const {
    bad(record_at_ + field, "record " + number((record_at_ - container_header) / 8), found, would_do);
  }

  void map(std::uint64_t k) {
    record_at_ = container_header + 8 * k;
    const Level n = bytes_[record_at_];
    const std::uint32_t kind = bytes_[record_at_ + 1], value = word_at<std::uint32_t>(bytes_, record_at_ + 4);
    if (n > max_level) bad_record("level " + number(n), "0 to 12", 0);
    if (word_at<std::uint16_t>(bytes_, record_at_ + 2) != 0) bad_record("bits that are set", "zeros", 2);
    switch (kind) {
      case 0:
        if (n >= tile_level) bad_record("a small map of level " + number(n), "level 0 to 2", 1);
        if (const std::uint32_t used = b_ << (2 * n); used < 32 && value >> used != 0)
          bad_record("a padding bit that is set", "zeros");
        break;
      case 1:
        if (n < tile_level) bad_record("a uniform map of level " + number(n), "a small one", 1);
        if (value >= (std::uint32_t{1} << b_)) bad_record("state " + number(value), "a state of the format");
        break;
      case 2: {
        if (n != tile_level) bad_record("a tile of level " + number(n), "level 3", 1);
        std::uint64_t end = tiles();
        tile(value, end, record_at_ + 4);
        if (end > tiles()) new_tile();
        break;
      }
      case 3:
        if (n <= tile_level) bad_record("nodes of level " + number(n), "level 4 to 12", 1);
        root(n, value);
        break;
      case 4:
        if (n <= tile_level) bad_record("a flat map of level " + number(n), "level 4 to 12", 1);
        flat(n, value);
        return;  // its record is there already
      default: bad_record("kind " + number(kind), "0 to 4", 1);
    }
    dag_.records_.push_back({static_cast<std::uint8_t>(n), Kind{static_cast<std::uint8_t>(kind)}, 0, value});
  }

  void flat(Level n, std::uint64_t value) {
    const std::uint64_t units = subtrees(n, tile_level);
    if (value < dag_.flat_.size() / b_) {
      again(n, value);
      return;
    }
    if (value != dag_.flat_.size() / b_)
      bad_record("a flat map at " + number(value), number(dag_.flat_.size() / b_) + ", the next one's place");
    if (value + units > in_.flat) bad_record("a flat map that goes beyond the array", "one within it");
    const std::uint64_t at = in_.flat_at + 8 * b_ * value;
    const std::uint32_t added = dag_.add(n, bytes_.subspan(at, 8 * b_ * units));
    if (dag_.records_[added].kind != Kind::flat || dag_.records_[added].value != value)
      bad(at, "flat " + number(value), "a map that takes less as tiles and nodes, or is there already",
          "a map that adding lays flat");
    flats_.push_back({value, n, grown_to()});
  }

  /// Takes a reference to a map laid flat before.  Tiles and nodes added since may mean that it should be nodes now.
  void again(Level n, std::uint64_t value) {
    const auto there = std::lower_bound(flats_.begin(), flats_.end(), value,
                                        [](const Flat& f, std::uint64_t v) { return f.value < v; });
    if (there == flats_.end() || there->value != value || there->level != n)
      bad_record("a place in the midst of a flat map or one of another level", "where one begins");
    if (there->grown_to == grown_to()) {
      dag_.records_.push_back(
          {static_cast<std::uint8_t>(n), Kind::flat, 0, static_cast<std::uint32_t>(value)});
      return;
    }
    const std::uint64_t units = subtrees(n, tile_level), at = in_.flat_at + 8 * b_ * value;
    const std::uint32_t added = dag_.add(n, bytes_.subspan(at, 8 * b_ * units));
    if (dag_.records_[added].kind != Kind::flat)
      bad_record("a flat map whose tiles and nodes are there by now", "a reference to its root", 1);
    there->grown_to = grown_to();
  }

  /// A measure of all tiles and nodes, which only grows.
  std::uint64_t grown_to() const { return dag_.tiles_.size() + dag_.nodes_.size(); }

  // ---- Tiles

  std::uint64_t tiles() const { return dag_.tiles_.size() / b_; }

  /// Checks a reference to tile t.  Tiles below `end` are there or met; t may be the next, and then raises `end`.
  void tile(std::uint64_t t, std::uint64_t& end, std::uint64_t referred_at) const {
    if (t < end) return;
    if (t > end || t >= in_.tiles)
      bad(referred_at, "a reference", "tile " + number(t),
          end < in_.tiles ? "one up to " + number(end) + ", the next one" : "one below " + number(in_.tiles));
    ++end;
  }

  void new_tile() {
    const std::uint64_t t = tiles(), at = in_.tiles_at + 8 * b_ * t;
    std::uint64_t words[2] = {};
    std::memcpy(words, bytes_.data() + at, 8 * b_);
    const std::uint32_t part = dag_.part_of_tile(words);
    if (!mixed(part)) bad(at, "tile " + number(t), "64 times one state", "two states");
    if (part != t) bad(at, "tile " + number(t), "the same as tile " + number(part), "another one");
  }

  // ---- Nodes

  std::uint64_t byte_of(std::uint64_t word) const { return in_.nodes_at + 4 * word; }

  [[noreturn]] void bad_node(std::uint64_t word, const std::string& found,
                             const std::string& would_do) const {
    bad(byte_of(word), "the node at word " + number(word), found, would_do);
  }

  /// The mark in known_ of a node that begins at a word: its level and whether it is wide; 0 if none begins there.
  static std::uint8_t mark(Level m, std::uint32_t reference) {
    return static_cast<std::uint8_t>(2 * m + reference % 2);
  }

  std::span<const std::uint32_t> node(Level m, std::uint32_t reference, std::uint32_t (&words)[18]) const {
    const std::uint64_t at = reference / 2;
    const auto word = [&](std::uint64_t k) {
      if (at + k >= in_.nodes) bad_node(at, "the end of the nodes", "a whole node");
      return word_at<std::uint32_t>(bytes_, byte_of(at + k));
    };
    words[0] = word(0);
    const std::uint32_t mask = mask_of(words[0]);
    if (mask >> children(m) != 0) bad_node(at, "a child beyond the last", number(children(m)) + " children");
    const std::uint32_t size = node_words(b_, ones(mask), reference % 2 == 1);
    for (std::uint32_t k = 1; k < size; ++k) words[k] = word(k);
    return {words, size};
  }

  /// Checks a reference to a node of level m.  If it is met for the first time, it joins the nodes to follow.
  void refer(Level m, std::uint32_t reference, std::uint64_t referred_at) {
    const std::uint64_t at = reference / 2;
    if (at >= in_.nodes)
      bad(referred_at, "a reference", "word " + number(at), "one below " + number(in_.nodes));
    if (known_[at] == mark(m, reference)) return;
    if (known_[at] != 0 || at < dag_.nodes_.size())
      bad(referred_at, "a reference", "word " + number(at),
          "where a node of level " + number(m) + " begins, wide or narrow as it says");
    known_[at] = mark(m, reference);
    fresh_[m].push_back(reference);
  }

  void root(Level n, std::uint32_t reference) {
    for (auto& of_level : fresh_) of_level.clear();
    const std::uint64_t tiles_before = tiles(), nodes_before = dag_.nodes_.size();
    refer(n, reference, record_at_ + 4);
    // From the root down, nodes come in the order in which the curve first meets them.
    std::uint64_t tiles_end = tiles();
    for (Level m = n; m > tile_level; m = child_level(m))
      for (std::size_t k = 0; k < fresh_[m].size(); ++k) follow(m, fresh_[m][k], tiles_end);
    // Upwards they come in the order in which they were added.
    while (tiles() < tiles_end) new_tile();
    for (Level m = tile_level + 1; m <= n; ++m)
      for (const std::uint32_t r : fresh_[m]) place(m, r);
    const std::uint64_t grown = 2 * b_ * (tiles() - tiles_before) + dag_.nodes_.size() - nodes_before;
    if (grown > 2 * b_ * subtrees(n, tile_level))
      bad_record("tiles and nodes of " + number(grown) + " words", "the map laid flat");
  }

  void follow(Level m, std::uint32_t reference, std::uint64_t& tiles_end) {
    std::uint32_t words[18];
    const auto all = node(m, reference, words);
    const Level below = child_level(m);
    const bool is_wide = reference % 2 == 1;
    const std::uint64_t at = reference / 2;
    const std::uint32_t used = ones(mask_of(words[0]));
    std::uint32_t greatest = 0;
    for (std::uint32_t k = 0; k < used; ++k) {
      const std::uint32_t next = is_wide ? words[b_ + k] : half(words, 1 + b_ + k);
      const std::uint64_t referred_at = byte_of(at) + (is_wide ? 4 * (b_ + k) : 2 * (1 + b_ + k));
      greatest = std::max(greatest, next);
      if (below == tile_level)
        tile(next, tiles_end, referred_at);
      else
        refer(below, next, referred_at);
    }
    if (is_wide != (below > tile_level || greatest >= narrow_tiles))
      bad_node(at, is_wide ? "a wide node of tiles below 65536" : "a narrow node of nodes",
               is_wide ? "a narrow one" : "a wide one");
    header(m, all, at);
  }

  /// Checks the bits of a header beside the mask, and the padding.
  void header(Level m, std::span<const std::uint32_t> words, std::uint64_t at) const {
    const std::uint32_t mask = mask_of(words[0]), all = (std::uint32_t{1} << children(m)) - 1,
                        states = all & ~mask, low = words[0] >> 16, high = b_ == 2 ? words[1] & 0xFFFF : 0;
    if (((low | high) & ~states) != 0)
      bad_node(at, "a state of a child that is mixed or beyond the last", "zeros");
    if (mask == 0 && (low == 0 || low == all) && (high == 0 || high == all))
      bad_node(at, "children of one state", "two states, or a mixed child");
    const bool is_wide = known_[at] % 2 == 1;
    const std::uint32_t halves = is_wide ? (b_ == 2 ? 3 : 2) : 1 + b_ + ones(mask);
    const std::uint32_t padded = is_wide ? 2 * b_ : 2 * static_cast<std::uint32_t>(words.size());
    if (halves < padded && half(words.data(), halves) != 0)
      bad_node(at, "a padding bit that is set", "zeros");
  }

  void place(Level m, std::uint32_t reference) {
    const std::uint64_t at = reference / 2;
    if (at != dag_.nodes_.size())
      bad_node(at, "a node out of order", "word " + number(dag_.nodes_.size()) + ", the next one's place");
    std::uint32_t words[18];
    const std::uint32_t there = dag_.intern_node(m, node(m, reference, words), reference % 2 == 1);
    if (there != reference) bad_node(at, "the same as the node at word " + number(there / 2), "another one");
  }

  std::span<const std::uint8_t> bytes_;
  Sections in_;
  Dag& dag_;
  std::uint32_t b_;
  std::vector<std::uint8_t> known_;  // marks, by the word at which a node begins
  std::array<std::vector<std::uint32_t>, max_level + 1> fresh_;
  /// A map that was laid flat, and the graph's size when adding it last laid it so.
  struct Flat {
    std::uint64_t value;
    Level level;
    std::uint64_t grown_to;
  };
  std::vector<Flat> flats_;  // ascending
  std::uint64_t record_at_ = 0;
};

BadContainer::BadContainer(std::size_t byte, const std::string& where, const std::string& found,
                           const std::string& would_do)
    : std::runtime_error("byte " + number(byte) + ", " + where + ": " + found + "; " + would_do +
                         " would do"),
      byte_(byte) {}

std::vector<std::uint8_t> save(const Dag& dag) {
  std::vector<std::uint8_t> bytes(container_header);
  const std::uint64_t b = static_cast<std::uint32_t>(dag.format());
  std::copy(magic.begin(), magic.end(), bytes.begin());
  bytes[4] = version;
  bytes[5] = static_cast<std::uint8_t>(b);
  const std::uint32_t counts[] = {dag.maps(), static_cast<std::uint32_t>(dag.tiles().size() / b),
                                  static_cast<std::uint32_t>(dag.flat().size() / b),
                                  static_cast<std::uint32_t>(dag.nodes().size())};
  std::memcpy(bytes.data() + 8, counts, sizeof counts);
  bytes.reserve(container_header + dag.bits() / 8);
  const auto append = [&](const auto& array) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(array.data());
    bytes.insert(bytes.end(), from, from + array.size_bytes());
  };
  append(dag.records());
  append(dag.tiles());
  append(dag.flat());
  append(dag.nodes());
  const std::uint32_t crc = checksum(bytes);
  std::memcpy(bytes.data() + crc_at, &crc, sizeof crc);
  return bytes;
}

Dag load(std::span<const std::uint8_t> bytes) {
  const auto bad = [](std::size_t byte, const std::string& found, const std::string& would_do) {
    throw BadContainer(byte, "the header", found, would_do);
  };
  if (bytes.size() < container_header) bad(bytes.size(), "the end of the input", "32 bytes");
  if (!std::equal(magic.begin(), magic.end(), bytes.begin()))
    bad(0, hex(word_at<std::uint32_t>(bytes, 0)), "\"mmdg\"");
  if (bytes[4] != version) bad(4, "version " + number(bytes[4]), "version 1");
  if (bytes[5] != 1 && bytes[5] != 2)
    bad(5, "format " + number(bytes[5]), "1 (two states) or 2 (four states)");
  if (word_at<std::uint16_t>(bytes, 6) != 0) bad(6, "bits that are set", "zeros");
  if (word_at<std::uint32_t>(bytes, 24) != 0) bad(24, "bits that are set", "zeros");
  const std::uint64_t length = Sections(bytes, bytes[5]).end;
  if (bytes.size() != length)
    bad(static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), length)),
        bytes.size() < length ? "the end of the input" : "bytes after the end", number(length) + " bytes");
  const std::uint32_t crc = checksum(bytes);
  if (word_at<std::uint32_t>(bytes, crc_at) != crc)
    bad(crc_at, "checksum " + hex(word_at<std::uint32_t>(bytes, crc_at)), "for these bytes " + hex(crc));
  Dag dag(Format{bytes[5]});
  Replay(bytes, dag).all();
  return dag;
}

}  // namespace mmverify::impl::dag
