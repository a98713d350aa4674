// The maps of a scene in one directed acyclic graph: what they have in common is stored once.  docs/DAG.md
//
// The form.  A graph has maps of one format, b bits a state, and four arrays to which maps are added at the end:
//   tiles    the distinct subtrees of level 3 that are not of one state: 64 states, b words of 64 bits
//   nodes    the distinct larger ones, in words of 32 bits.  A node of level m has 16 children of level m-2, or, at the top
//            of a map of an even level, 4 of level m-1.  It begins with halfwords: a mask of the children that are mixed,
//            and b planes with the states of the others.  Then there is a reference for each mixed child, in order: the
//            number of a tile, in 16 bits where all of the node's are below 2^16 (a narrow node) and in 32 bits otherwise;
//            or the place of a node, 2 a + 1 of a wide node and 2 a of a narrow one that begins at word a.
//   flat     maps that would take more as tiles and nodes, as they are
//   records  8 bytes a map: level, kind, and where it is; up to level 2 and where all states are one, the states themselves
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace mmverify::impl::dag {

using Level = std::uint32_t;

/// Highest level that is supported.
inline constexpr Level max_level = 12;

/// Bits of one state.
enum class Format : std::uint32_t { two_state = 1, four_state = 2 };

/// How a map is held.  What `value` of its record is:
enum class Kind : std::uint8_t {
  small = 0,    ///< level 0 to 2: the packed states
  uniform = 1,  ///< the one state of all
  tile = 2,     ///< level 3: the number of the tile
  node = 3,     ///< a reference to the root
  flat = 4,     ///< where its words begin, in units of a tile
};

/// Where a map is.
struct Record {
  std::uint8_t level = 0;
  Kind kind = Kind::small;
  std::uint16_t reserved = 0;
  std::uint32_t value = 0;
  friend bool operator==(const Record&, const Record&) = default;
};
static_assert(sizeof(Record) == 8);

/// The graph of a scene's maps: maps are added, and looked up at any time.
class Dag {
 public:
  explicit Dag(Format b);
  ~Dag();
  Dag(Dag&&) noexcept;
  Dag& operator=(Dag&&) noexcept;

  /// Adds a map, and returns its number: 0, 1, ...  Nothing that is there moves or changes.  The same maps in the same order
  /// give the same words.
  ///   bits() grows by 64 + 64 ceil(4^n b / 64) at most, by 64 alone up to level 2 and for a map that is there.
  /// Domain: n in 0..12 and a map of ceil(4^n b / 8) bytes, or std::invalid_argument is thrown; bits after the last state may
  /// be anything.  std::length_error where an array would pass 2^31 words.
  std::uint32_t add(Level n, std::span<const std::uint8_t> map);

  std::uint32_t maps() const noexcept { return static_cast<std::uint32_t>(records_.size()); }
  Format format() const noexcept { return Format{b_}; }
  /// Domain: map < maps().
  Level level(std::uint32_t map) const noexcept { return records_[map].level; }

  /// The state of a micro-triangle.  Reads a record; two words for each 4 bits of the index, in a node; one word for the last
  /// 6 bits, in a tile.  Domain: map < maps(); the low 2 level bits of the index count.
  std::uint8_t at(std::uint32_t map, std::uint64_t index) const noexcept;

  /// The state at barycentrics (u, v): at(map, index::from_barycentrics(u, v, level(map))).
  /// Domain: every bit pattern, as there; map < maps().
  std::uint8_t at_point(std::uint32_t map, float u, float v) const noexcept;

  /// state[k] = at(map[k], index[k]).
  /// Domain: spans of one length and map[k] < maps(), or std::invalid_argument is thrown and nothing is written; no overlap.
  void lookup(std::span<const std::uint32_t> map, std::span<const std::uint32_t> index,
              std::span<std::uint8_t> state) const;

  /// The map again, padding bits zero.
  /// Domain: map < maps() and bytes of its level's size, or std::invalid_argument is thrown.
  void decode(std::uint32_t map, std::span<std::uint8_t> bytes) const;

  /// All four arrays, in bits: what a lookup needs.  What adding needs besides is not counted.
  std::uint64_t bits() const noexcept;

  // The arrays, to copy to where lookups are made.
  std::span<const Record> records() const noexcept { return records_; }
  std::span<const std::uint64_t> tiles() const noexcept { return tiles_; }
  std::span<const std::uint32_t> nodes() const noexcept { return nodes_; }
  std::span<const std::uint64_t> flat() const noexcept { return flat_; }

 private:
  friend class Replay;

  std::uint32_t part_of_tile(const std::uint64_t* words);
  std::uint32_t part_of_children(Level m, const std::uint32_t* parts);
  std::uint32_t intern_node(Level m, std::span<const std::uint32_t> words, bool wide);
  std::uint32_t number_of_flat(Level n, std::span<const std::uint64_t> words);
  void forget(std::size_t tiles, std::size_t nodes);

  std::uint32_t b_;
  std::vector<Record> records_;
  std::vector<std::uint64_t> tiles_, flat_;
  std::vector<std::uint32_t> nodes_;

  struct Known;  // what is there already, for adding alone
  std::unique_ptr<Known> known_;
};

}  // namespace mmverify::impl::dag
