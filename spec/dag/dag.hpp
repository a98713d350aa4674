// The graph of a scene's maps, with equal subtrees over the curve stored once.  docs/DAG.md describes the form.
//
// Here a stored subtree has its children as they are, so that equal ones are found by comparing; the sizes are those of
// the words, which spec/dag/words.hpp writes.  A tile is a subtree like the others, with 64 children that are states.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "spec/index/index.hpp"
#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::dag {

using micromap::Bytes;
using micromap::Format;
using micromap::State;
using micromap::States;

inline constexpr Level tile_level = 3;

/// A tile has 64 states; a subtree of odd level has 16 children two levels below, one of even level 4 one level below.
constexpr Level child_level(Level m) { return m == tile_level ? 0 : m % 2 == 0 ? m - 1 : m - 2; }
constexpr std::uint64_t children(Level m) { return micromap::micro_triangles(m - child_level(m)); }

// ---- Stored subtrees

/// A subtree: one state for all of it, or the number of a stored one, a tile at level 3, a node above.
struct Part {
  std::optional<State> one_state = {};
  std::uint64_t number = 0;
  bool mixed() const { return !one_state; }
  friend bool operator==(const Part&, const Part&) = default;
  friend bool operator<(const Part& a, const Part& b) {
    return std::tie(a.one_state, a.number) < std::tie(b.one_state, b.number);
  }
};
using Children = std::vector<Part>;

/// A larger subtree of more than one state: its children, in the order of the curve.
struct Node {
  Level level = 0;
  Children children;
  friend bool operator==(const Node&, const Node&) = default;
  friend bool operator<(const Node& a, const Node& b) {
    return std::tie(a.level, a.children) < std::tie(b.level, b.children);
  }
};

/// A map of the graph.
struct Map {
  enum class Kind : std::uint8_t { small, uniform, tile, node, flat } kind = Kind::small;
  Level level = 0;
  States states = {};           ///< for a small map
  Part root = {};               ///< for a uniform map, a tile, a node
  std::uint64_t flat_from = 0;  ///< for a flat map: tiles' worth of states before it
  friend bool operator==(const Map&, const Map&) = default;
};

/// The graph of a scene's maps.
struct Dag {
  Format format = Format::two_state;
  std::vector<Node> tiles, nodes;  ///< in the order of adding
  std::vector<Map> maps;
  std::vector<std::pair<Level, States>> flat;
  friend bool operator==(const Dag&, const Dag&) = default;
};

// ---- Adding a map

/// The part for a subtree with these children: their state if all have one, and it is the same; else stored(children),
/// the one stored subtree with these children.
template <class Part, class Stored>
Part parent(std::span<const Part> children, const Stored& stored) {
  for (const Part& child : children)
    if (child.mixed() || !(child == children[0])) return stored(children);
  return children[0];
}

/// Whether tiles and nodes that take `grown` words more are kept, instead of the map laid flat.
template <class Count>
bool kept(const Count& grown, const Count& flat) {
  return !(flat < grown);
}

/// The words of 32 bits of a node.
///   narrow ceil((1 + b + r) / 2), wide b + r, with r mixed children
inline std::uint64_t references(const Node& node) {
  std::uint64_t r = 0;
  for (const Part& child : node.children) r += child.mixed() ? 1 : 0;
  return r;
}
inline bool wide(const Node& node) {
  for (const Part& child : node.children)
    if (child.mixed() && (child_level(node.level) != tile_level || child.number >= 65536)) return true;
  return child_level(node.level) != tile_level;
}
inline std::uint64_t words(const Node& node, Format f) {
  const std::uint64_t b = micromap::bits(f), r = references(node);
  return wide(node) ? b + r : (1 + b + r + 1) / 2;
}

/// The two decisions of adding, so that a prover can be given the same.
struct Rules {
  template <class Part, class Stored>
  static Part parent(std::span<const Part> children, const Stored& stored) {
    return dag::parent(children, stored);
  }
  template <class Count>
  static bool kept(const Count& grown, const Count& flat) {
    return dag::kept(grown, flat);
  }
};

/// Adds maps to a graph.  A stored subtree is found again by its children.
template <class Rules>
class BuilderBy {
 public:
  explicit BuilderBy(Format f) { dag_.format = f; }
  const Dag& dag() const { return dag_; }

  /// Adds a map.  Domain: 4^n states of the format, n in 0..12.
  void add(Level n, const States& map) {
    Map added{.level = n};
    if (n < tile_level) {
      added.states = map;
    } else {
      const std::size_t tiles = dag_.tiles.size(), nodes = dag_.nodes.size();
      added.root = part(n, map);
      added.kind = !added.root.mixed() ? Map::Kind::uniform
                   : n == tile_level   ? Map::Kind::tile
                                       : Map::Kind::node;
      const std::uint64_t flat = flat_words(n);
      if (!Rules::kept(grown(tiles, nodes), flat)) {
        forget(tiles, nodes);
        added = {.kind = Map::Kind::flat, .level = n, .flat_from = laid_flat(n, map)};
      }
    }
    dag_.maps.push_back(std::move(added));
  }

 private:
  /// The part of a map: all subtrees of a level come before any of the next, each in the order of the curve.
  Part part(Level n, const States& map) {
    Children parts;
    for (const State s : map) parts.push_back({s});
    for (Level below = 0; below < n;) {
      const Level m = below == 0 ? tile_level : std::min<Level>(n, below + 2);
      const std::uint64_t each = children(m);
      Children above;
      for (std::size_t k = 0; k < parts.size(); k += each)
        above.push_back(
            Rules::parent(std::span<const Part>(parts).subspan(k, each), [&](std::span<const Part> of) {
              return Part{{}, stored({m, Children(of.begin(), of.end())})};
            }));
      parts = std::move(above);
      below = m;
    }
    return parts[0];
  }

  std::uint64_t stored(Node node) {
    std::vector<Node>& all = node.level == tile_level ? dag_.tiles : dag_.nodes;
    const auto [at, is_new] = number_.try_emplace(node, all.size());
    if (is_new) all.push_back(std::move(node));
    return at->second;
  }

  std::uint64_t flat_words(Level n) const {
    return micromap::micro_triangles(n) * micromap::bits(dag_.format) / 32;
  }

  std::uint64_t grown(std::size_t tiles, std::size_t nodes) const {
    std::uint64_t sum = (dag_.tiles.size() - tiles) * flat_words(tile_level);
    for (std::size_t k = nodes; k < dag_.nodes.size(); ++k) sum += words(dag_.nodes[k], dag_.format);
    return sum;
  }

  void forget(std::size_t tiles, std::size_t nodes) {
    for (; dag_.tiles.size() > tiles; dag_.tiles.pop_back()) number_.erase(dag_.tiles.back());
    for (; dag_.nodes.size() > nodes; dag_.nodes.pop_back()) number_.erase(dag_.nodes.back());
  }

  std::uint64_t laid_flat(Level n, const States& map) {
    std::uint64_t from = 0;
    for (const auto& [level, states] : dag_.flat) {
      if (level == n && states == map) return from;
      from += micromap::micro_triangles(level - tile_level);
    }
    dag_.flat.emplace_back(n, map);
    return from;
  }

  Dag dag_;
  std::map<Node, std::uint64_t> number_;
};
using Builder = BuilderBy<Rules>;

// ---- Lookups

/// One turn of a lookup, to the child of the next digit; false if the part has one state.
template <class Store, class Part, class NextDigit>
bool lookup_turn(const Store& store, Part& at, const NextDigit& next_digit) {
  if (!at.mixed()) return false;
  at = store.child(at, next_digit());
  return true;
}

/// The subtrees of a graph, by level.
struct Store {
  const Dag& dag;
  Level level;  ///< level of the part that child() takes
  Part child(const Part& at, std::uint64_t digit) const {
    return (level == tile_level ? dag.tiles : dag.nodes).at(at.number).children.at(digit);
  }
};

/// The state at an index < 4^n of a map.
template <class Turn>
State at_index_by(const Turn& turn, const Dag& dag, std::uint64_t map, std::uint64_t index) {
  const Map& m = dag.maps.at(map);
  if (m.kind == Map::Kind::small) return m.states.at(index);
  if (m.kind == Map::Kind::flat) {
    std::uint64_t from = 0, k = 0;
    for (; from != m.flat_from; ++k) from += micromap::micro_triangles(dag.flat.at(k).first - tile_level);
    return dag.flat.at(k).second.at(index);
  }
  Part at = m.root;
  Store store{dag, m.level};
  Level below = m.level;
  const auto next_digit = [&] {
    below = child_level(store.level);
    return index >> 2 * below & (children(store.level) - 1);
  };
  while (turn(store, at, next_digit)) store.level = below;
  return *at.one_state;
}
inline State at_index(const Dag& dag, std::uint64_t map, std::uint64_t index) {
  return at_index_by(
      [](const auto& store, auto& at, const auto& next) { return lookup_turn(store, at, next); }, dag, map,
      index);
}

inline States decode(const Dag& dag, std::uint64_t map) {
  States states;
  for (std::uint64_t k = 0; k < micromap::micro_triangles(dag.maps.at(map).level); ++k)
    states.push_back(at_index(dag, map, k));
  return states;
}

/// The bits of the arrays: 64 maps + 64 b tiles + 32 (words of nodes) + 64 b (units of flat).
inline std::uint64_t bits(const Dag& dag) {
  const std::uint64_t b = micromap::bits(dag.format);
  std::uint64_t sum = 64 * dag.maps.size() + 64 * b * dag.tiles.size();
  for (const Node& node : dag.nodes) sum += 32 * words(node, dag.format);
  for (const auto& [level, states] : dag.flat) sum += b * states.size();
  return sum;
}

/// The bound of bits(): 64 a map, and 4^n b for each map of level 3 or more.
inline std::uint64_t most_bits(const Dag& dag) {
  std::uint64_t sum = 0;
  for (const Map& map : dag.maps)
    sum +=
        64 + (map.level < tile_level ? 0 : micromap::bits(dag.format) * micromap::micro_triangles(map.level));
  return sum;
}

}  // namespace mmverify::spec::dag
