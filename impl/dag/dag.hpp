// The maps of a scene in one directed acyclic graph, in which common parts are stored once.  docs/DAG.md
//
// The form.  A graph has maps of one format, b bits a state, and four arrays to which maps are added at the end:
//   tiles    the distinct subtrees of level 3 that are not of one state: 64 states, b words of 64 bits
//   nodes    the distinct larger ones, in words of 32 bits.  A node of level m has 16 children of level m-2, or, at the
//            top of a map of an even level, 4 of level m-1.  It begins with halfwords: a mask of the children that are
//            mixed, and b planes with the states of the others.  Then there is a reference for each mixed child, in
//            order.  A reference to a tile is its number, in 16 bits if all of the node's are below 2^16 (a narrow
//            node), else in 32 bits.  A reference to a node that begins at word a is 2 a + 1 if it is wide, 2 a if
//            narrow.
//   flat     maps that are smaller unchanged than as tiles and nodes
//   records  8 bytes a map: level, kind, and place; instead of a place the states, up to level 2 or if all are equal
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace mmverify::impl::dag {

using Level = std::uint32_t;

/// The highest supported level.
inline constexpr Level max_level = 12;

/// The format of maps: the bits of one state.
enum class Format : std::uint32_t { two_state = 1, four_state = 2 };

/// The storage of a map, which decides the meaning of its record's `value`.
enum class Kind : std::uint8_t {
  small = 0,    ///< level 0 to 2: the packed states
  uniform = 1,  ///< the one state of the map
  tile = 2,     ///< level 3: the number of the tile
  node = 3,     ///< a reference to the root node
  flat = 4,     ///< the place of its first word, in units of a tile
};

/// The level, the storage and the place of one map.
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
  /// An empty graph of maps in format b.
  /// Domain: a format that exists, else std::invalid_argument.
  /// Law: dag.equals_spec
  explicit Dag(Format b);
  ~Dag();
  Dag(Dag&&) noexcept;
  Dag& operator=(Dag&&) noexcept;

  /// Adds a map, and returns its number: 0, 1, ...  Stored words do not move or change.  The same maps in the same
  /// order give the same words.
  ///   bits() grows by 64 + 64 ceil(4^n b / 64) at most; by 64 only, up to level 2 or if the graph has the map already.
  /// Domain: n in 0..12 and a map of ceil(4^n b / 8) bytes, or std::invalid_argument is thrown; bits after the last
  /// state may be anything.  std::length_error if an array would pass 2^31 words.
  /// Law: dag.equals_spec, dag.append, dag.bound
  std::uint32_t add(Level n, std::span<const std::uint8_t> map);

  std::uint32_t maps() const noexcept { return static_cast<std::uint32_t>(records_.size()); }
  Format format() const noexcept { return Format{b_}; }
  /// Domain: map < maps().
  Level level(std::uint32_t map) const noexcept { return records_[map].level; }

  /// The state of a micro-triangle.  It reads a record; in a node two words for each 4 bits of the index; in a tile one
  /// word for the last 6 bits.  Domain: map < maps(); the low 2 level bits of the index count.
  /// Law: dag.lookup_is_decode, dag.on_samples
  std::uint8_t at(std::uint32_t map, std::uint64_t index) const noexcept;

  /// The state at barycentrics (u, v): at(map, index::from_barycentrics(u, v, level(map))).
  /// Domain: every bit pattern, as there; map < maps().
  /// Law: dag.point_is_index
  std::uint8_t at_point(std::uint32_t map, float u, float v) const noexcept;

  /// state[k] = at(map[k], index[k]).
  /// Domain: spans of one length and map[k] < maps(), or std::invalid_argument is thrown and nothing is written; no overlap.
  /// Law: dag.lookup_is_decode, dag.on_samples
  void lookup(std::span<const std::uint32_t> map, std::span<const std::uint32_t> index,
              std::span<std::uint8_t> state) const;

  /// The map again, padding bits zero.
  /// Domain: map < maps() and bytes of its level's size, or std::invalid_argument is thrown.
  /// Law: dag.round_trip, dag.on_samples
  void decode(std::uint32_t map, std::span<std::uint8_t> bytes) const;

  /// The size of all four arrays in bits, which is all that lookups need.  The tables for adding are not counted.
  /// Law: dag.bound
  std::uint64_t bits() const noexcept;

  // The arrays, to copy to the place of lookups.
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

  struct HashTables;  // hash tables, for adding alone
  std::unique_ptr<HashTables> known_;
};

}  // namespace mmverify::impl::dag
