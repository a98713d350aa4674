// Maps as succinct trees and as graphs, their containers, lookups in them, and invalid containers.
#include <algorithm>

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/dag/words.hpp"
#include "spec/tree/tree.hpp"

namespace mmverify::vectors::trees {
namespace {

using spec::Level;
using spec::micromap::Format;
using spec::micromap::State;
using spec::micromap::States;
namespace micromap = spec::micromap;

const Column why{"about", Kind::about, "why the vector is there"};
constexpr std::size_t header_bytes = 16, crc_at = 12;

Bytes codes(const States& states) {
  Bytes all;
  for (const State s : states) all.push_back(micromap::code(s));
  return all;
}

std::uint32_t number(Format f) { return static_cast<std::uint32_t>(f); }

void put_crc(Bytes& container) {
  const std::span all(container);
  const std::uint32_t crc =
      spec::dag::crc32c(all.subspan(header_bytes), spec::dag::crc32c(all.first(crc_at)));
  for (unsigned k = 0; k < 4; ++k) container[crc_at + k] = static_cast<std::uint8_t>(crc >> 8 * k);
}

/// A container of flat states or of a tree: docs/VECTORS.md, "trees".
Bytes container_of(Level n, Format f, bool tree, std::uint32_t internal, const Bytes& content) {
  Bytes all{'m',
            'm',
            't',
            'r',
            1,
            static_cast<std::uint8_t>(n),
            static_cast<std::uint8_t>(number(f)),
            static_cast<std::uint8_t>(tree ? 1 : 0)};
  for (unsigned k = 0; k < 4; ++k) all.push_back(static_cast<std::uint8_t>(internal >> 8 * k));
  all.resize(header_bytes);
  all.insert(all.end(), content.begin(), content.end());
  put_crc(all);
  return all;
}

/// The canonical container of a map: the tree if it takes fewer bytes, else flat.
Bytes container_of(Level n, Format f, const States& map) {
  const spec::tree::Succinct s = spec::tree::encode(map, n);
  const Bytes tree = spec::tree::bytes(s, f), flat = micromap::pack(map, f);
  if (tree.size() >= flat.size()) return container_of(n, f, false, 0, flat);
  return container_of(n, f, true, static_cast<std::uint32_t>(s.tree.size() / 4), tree);
}

/// A map whose state k is state_of(k), k < 4^n.
template <class StateOf>
States map_of(Level n, StateOf state_of) {
  States map;
  for (std::uint32_t k = 0; k < micromap::micro_triangles(n); ++k) map.push_back(State(state_of(k)));
  return map;
}

/// Calls each(about, map) for maps of a level and a format, each with the reason for it.
template <class Each>
void for_each_map(Level n, Format f, Each each) {
  const std::uint32_t states = f == Format::two_state ? 2 : 4;
  const auto last = static_cast<std::uint32_t>(micromap::micro_triangles(n) - 1);
  each("one state: a single leaf", map_of(n, [&](std::uint32_t) { return states - 1; }));
  if (n == 0) return;
  each("the first apart: internal nodes first", map_of(n, [](std::uint32_t k) { return k == 0 ? 1 : 0; }));
  each("the last apart: internal nodes last",
       map_of(n, [&](std::uint32_t k) { return k == last ? 0 : states - 1; }));
  each("no four siblings alike: the largest tree", map_of(n, [&](std::uint32_t k) { return k % states; }));
  each("quarters: leaves below the root",
       map_of(n, [&](std::uint32_t k) { return (k >> 2 * (n - 1)) % states; }));
  if (n < 2) return;
  Mixed mixed(n + states);
  each("mixed", map_of(n, [&](std::uint32_t) { return mixed.bits(states == 2 ? 1 : 2); }));
  each("a contour: leaves of every depth", map_of(n, [&](std::uint32_t k) {
         const auto c = spec::index::corners(k, n);
         const std::uint32_t N = spec::side(n), at = 7 * c[0].i + 3 * c[0].j;
         return at < 2 * N ? 0 : at > 5 * N ? 1 : states == 2 ? at % 2 : 2 + at % 2;
       }));
}

void add_trees(Builder& out) {
  for (const Format f : {Format::two_state, Format::four_state})
    for (const Level n : {0u, 1u, 2u, 3u, 5u})
      for_each_map(n, f, [&](const char* about, const States& map) {
        const spec::tree::Succinct s = spec::tree::encode(map, n);
        out.add({about, n, number(f), codes(map), static_cast<std::uint32_t>(s.tree.size()),
                 static_cast<std::uint32_t>(s.data.size()), spec::tree::bytes(s, f),
                 container_of(n, f, map)});
      });
}

void add_lookups(Builder& out) {
  std::uint32_t tree = 0;
  for (const Format f : {Format::two_state, Format::four_state})
    for (const Level n : {0u, 1u, 2u, 3u, 5u})
      for_each_map(n, f, [&](const char*, const States& map) {
        const spec::tree::Succinct s = spec::tree::encode(map, n);
        const auto last = static_cast<std::uint32_t>(map.size() - 1);
        const auto add = [&](const char* about, std::uint32_t index) {
          const spec::tree::StateAndBits found = spec::tree::at_index(s, n, index);
          out.add(
              {about, tree, index, micromap::code(found.state), static_cast<std::uint32_t>(found.tree_bits)});
        };
        add("the first", 0);
        if (last > 0) add("the last: the longest way", last);
        if (n > 1)
          for (const std::uint32_t index :
               {1u, last / 4, last / 4 + 1, last / 2 + 1, last - 1, 0x5b1u & last})
            add("between", index);
        ++tree;
      });
}

/// Containers of trees and flat maps that have another, canonical one, or are no map's.
void add_not_canonical(Builder& out, const States& apart, const States& full) {
  const Level n = 3;
  const spec::tree::Succinct s = spec::tree::encode(full, n);
  out.add({"a tree where flat takes fewer bytes",
           container_of(n, Format::four_state, true, static_cast<std::uint32_t>(s.tree.size() / 4),
                        spec::tree::bytes(s, Format::four_state))});
  out.add({"flat where a tree takes fewer bytes",
           container_of(n, Format::four_state, false, 0, micromap::pack(apart, Format::four_state))});
  const spec::tree::Succinct alike{{true, false, false, false, false},
                                   {State::O, State::O, State::O, State::O}};
  out.add({"four leaves of one state below a node",
           container_of(n, Format::four_state, true, 1, spec::tree::bytes(alike, Format::four_state))});
  spec::tree::Succinct deep{
      {true, true, true, false, false, false, false, false, false, false, false, false, false},
      States(10, State::T)};
  deep.data[0] = State::O;
  out.add({"a tree deeper than its level",
           container_of(1, Format::four_state, true, 3, spec::tree::bytes(deep, Format::four_state))});
}

void add_broken(Builder& out) {
  const Level n = 3;
  const States apart = map_of(n, [](std::uint32_t k) { return k == 0 ? 1 : 0; });
  const States full = map_of(n, [](std::uint32_t k) { return k % 4; });
  const Bytes tree = container_of(n, Format::four_state, apart),
              flat = container_of(n, Format::four_state, full);
  const auto spoil = [&](const char* about, Bytes bytes, auto how, bool crc) {
    how(bytes);
    if (crc) put_crc(bytes);
    out.add({about, bytes});
  };
  const auto set = [](std::size_t at, std::uint8_t value) {
    return [at, value](Bytes& b) { b[at] = value; };
  };
  out.add({"nothing", Bytes{}});
  for (const Bytes& good : {tree, flat}) {
    spoil(
        "cut short by a byte", good, [](Bytes& b) { b.pop_back(); }, true);
    spoil(
        "a byte too many", good, [](Bytes& b) { b.push_back(0); }, true);
    spoil(
        "a header alone", good, [](Bytes& b) { b.resize(header_bytes); }, true);
    spoil(
        "half a header", good, [](Bytes& b) { b.resize(header_bytes / 2); }, false);
    spoil("other letters", good, set(3, 'x'), true);
    spoil("version 2", good, set(4, 2), true);
    spoil("level 13", good, set(5, 13), true);
    spoil("format 0", good, set(6, 0), true);
    spoil("format 3", good, set(6, 3), true);
    spoil("kind 2", good, set(7, 2), true);
    spoil(
        "the other kind", good, [](Bytes& b) { b[7] ^= 1; }, true);
    spoil(
        "one internal node more", good, [](Bytes& b) { ++b[8]; }, true);
    spoil(
        "a checksum that is not its own", good, [](Bytes& b) { b[crc_at] ^= 1; }, false);
    spoil(
        "a bit of the content turned", good, [](Bytes& b) { b.back() ^= 1; }, false);
  }
  spoil(
      "a bit set after the last state", tree, [](Bytes& b) { b.back() |= 0x80; }, true);
  spoil(
      "2^32 - 1 internal nodes", tree,
      [](Bytes& b) { std::fill(b.begin() + 8, b.begin() + 12, std::uint8_t{0xff}); }, true);
  add_not_canonical(out, apart, full);
}

/// The maps of a graph, in the order of their addition.
std::vector<std::pair<Level, States>> maps_of(Format f) {
  std::vector<std::pair<Level, States>> all;
  for (const Level n : {0u, 2u, 3u, 4u, 5u})
    for_each_map(n, f, [&](const char*, const States& map) { all.emplace_back(n, map); });
  return all;
}

void add_graphs(Builder& out) {
  const auto add = [&](const char* about, Format f, auto taken) {
    spec::dag::Builder graph(f);
    std::vector<std::uint32_t> levels;
    Bytes states;
    for (const auto& [n, map] : maps_of(f)) {
      if (!taken(n)) continue;
      graph.add(n, map);
      levels.push_back(n);
      const Bytes more = codes(map);
      states.insert(states.end(), more.begin(), more.end());
    }
    out.add({about, number(f), levels, states, spec::dag::container(graph.dag())});
  };
  for (const Format f : {Format::two_state, Format::four_state}) {
    add("no map", f, [](Level) { return false; });
    add("small maps, in their records", f, [](Level n) { return n <= 2; });
    add("tiles", f, [](Level n) { return n == 3; });
    add("nodes of 4 and of 16 children", f, [](Level n) { return n >= 4; });
    add("maps of all kinds", f, [](Level) { return true; });
  }
}

}  // namespace

Family family() {
  Builder out("trees", 1,
              "maps as succinct trees and as graphs; the containers are mmverify's own, mmtr and mmdg");
  out.table("trees", "Maps and their trees.",
            {why,
             {"level", Kind::number, "n; 4^n states"},
             {"format", Kind::number, "1: 2-state, 2: 4-state"},
             {"states", Kind::digits, "codes: T 0, O 1, UT 2, UO 3"},
             {"nodes", Kind::number, "bits of the tree"},
             {"leaves", Kind::number, "states in the tree"},
             {"bytes", Kind::bytes, "the tree's bits in whole bytes, then the leaves' states"},
             {"container", Kind::bytes, "the map's one container"}});
  add_trees(out);
  out.table("lookups", "The state of one micro-triangle, by Algorithm 3.",
            {why,
             {"tree", Kind::number, "id in table trees"},
             {"index", Kind::number, "of the micro-triangle"},
             {"state", Kind::number, "its code"},
             {"read", Kind::number, "bits of the tree that the algorithm reads"}});
  add_lookups(out);
  out.table("broken", "What no map's container is: a reader has to refuse it, and may crash on none.",
            {why, {"bytes", Kind::bytes, "no container"}});
  add_broken(out);
  out.table("graphs", "Several maps in one graph.",
            {why,
             {"format", Kind::number, "1: 2-state, 2: 4-state"},
             {"levels", Kind::words, "of each map"},
             {"states", Kind::digits, "of all maps, one after another"},
             {"container", Kind::bytes, "the one container of these maps in this order"}});
  add_graphs(out);
  return out.take();
}

}  // namespace mmverify::vectors::trees
