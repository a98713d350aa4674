#include "proofs/tree/laws.hpp"

#include "proofs/tree/checks.hpp"
#include "proofs/tree/induction/provable.hpp"
#include "proofs/tree/mutants.hpp"

namespace mmverify::proofs::tree {
namespace {

bool is(const Map& map, const char* text) { return map.level <= 2 && text_of_states(map) == text; }

void flip(Bytes& packed, std::size_t bit) {
  packed[bit / 8] = static_cast<std::uint8_t>(packed[bit / 8] ^ 1u << bit % 8);
}

Law round_trip_law() {
  return on_all_maps(
      {.id = "tree.round_trip",
       .says = "a decoded code is the map that was encoded, and its padding bits are zero",
       .source = succinct_4_2,
       .subjects = {"tree-spec", "tree-stream", "tree-ranked", "tree-stepwise", "tree-container"},
       .tiers = {.seconds = 1},
       .mutants = {mutant("one state of one map of level 2", "tree-stream", {2, 2},
                          decodes_wrongly([](const Map& map, Bytes& packed) {
                            if (is(map, "2-state:0000000000000001")) flip(packed, 0);
                          }))}},
      {}, round_trip);
}

Law lookup_law() {
  return on_all_maps(
      {.id = "tree.lookup_is_decode",
       .says = "a lookup at any index gives the state that the map has there",
       .source = succinct_4_2,
       .subjects = {"tree-spec", "tree-stream", "tree-ranked", "tree-stepwise"},
       .tiers = {.seconds = 2},
       .mutants = {mutant("the last index of one map", "tree-ranked", {2, 2},
                          finds_wrongly([](const Map& map, std::uint32_t k, std::uint8_t& state) {
                            if (k == 15 && is(map, "2-state:0111111111111110")) state ^= 1;
                          }))}},
      {entry::lookup}, [](const TreeSubject& s, const Map& map) { return lookups(s, map); });
}

Law point_law() {
  return on_all_maps(
      {.id = "tree.point_is_index",
       .says = "a lookup by barycentrics gives the state at the reference's index, on lines and corners too",
       .source = succinct_4_2,
       .subjects = {"tree-spec", "tree-ranked", "tree-stepwise"},
       .tiers = {.seconds = 6},
       .mutants = {mutant("a tie of one map", "tree-ranked", {2, 2},
                          finds_points_wrongly([](const Map& map, float u, float v, std::uint8_t& state) {
                            if (u == 0.5f && v == 0.25f && is(map, "2-state:0000000000000010")) state ^= 1;
                          }))}},
      {entry::point}, [](const TreeSubject& s, const Map& map) { return points(s, map); });
}

Law stream_law() {
  return on_all_maps({.id = "tree.equals_spec",
                      .says = "the encoder's bytes are those of Algorithms 1 and 2",
                      .source = succinct_4_1,
                      .subjects = {"tree-stream"},
                      .tiers = {.seconds = 1},
                      .mutants = {mutant("a bit after the last value", "tree-stream", {2, 2},
                                         writes_wrongly([](const Map& map, Bytes& bytes) {
                                           if (is(map, "2-state:1000000000000000")) bytes.back() ^= 0x80;
                                         }))}},
                     {entry::stream}, stream_is_specified);
}

Law sizes_law() {
  return on_all_maps(
      {.id = "tree.sizes",
       .says = "leaves = 3 internal + 1, no more than (4^(n+1)-1)/3 nodes, and no byte more than they need",
       .source = succinct_6_2,
       .subjects = {"tree-spec", "tree-stream"},
       .tiers = {.seconds = 1},
       .mutants = {mutant("the tree of one map ends early", "tree-spec", {1, 1},
                          writes_wrongly([](const Map& map, Bytes& bytes) {
                            if (is(map, "4-state:0123")) bytes = {0x03, 0x00};
                          }))}},
      {entry::stream}, sizes);
}

Law damage_law() {
  const auto takes_all = [](Format format, Level level, Bytes sent) {
    return opens_wrongly([=](const Functions& real, Level n, Format f, auto bytes, std::optional<Code> code) {
      if (!code && n == level && f == format && bytes.size() == sent.size() &&
          std::equal(sent.begin(), sent.end(), bytes.begin()))
        code = real.encode({n, f, Bytes(1, 0)});
      return code;
    });
  };
  return on_all_maps({.id = "tree.malformed",
                      .says = "a code cut anywhere, longer by a byte, two, or itself, or with one bit "
                              "flipped is refused or is another map's",
                      .source = succinct_4_2,
                      .subjects = {"tree-spec", "tree-stream", "tree-container"},
                      .tiers = {.seconds = 6},
                      .mutants = {mutant("takes a set byte after the end of one code", "tree-stream", {1, 1},
                                         takes_all(Format::two_state, 1, {0x00, 0x01, 0xFF}))}},
                     {entry::bytes}, damage);
}

Law four_state_law() {
  return on_four_state_maps_of_level_2(
      {.id = "tree.four_state_level_2",
       .says = "round trip and every lookup, for each of the 4^16 4-state maps of level 2",
       .source = succinct_4_2,
       .subjects = {"tree-stream", "tree-stepwise"},
       .mutants = {mutant("one map", "tree-stepwise", {2, 2},
                          decodes_wrongly([](const Map& map, Bytes& packed) {
                            if (map.packed == Bytes{0xE4, 0x1B, 0xE4, 0x1B}) flip(packed, 31);
                          })),
                   mutant("the first map", "tree-stream", {2, 2},
                          decodes_wrongly([](const Map& map, Bytes& packed) {
                            if (map.packed == Bytes(4, 0)) flip(packed, 1);
                          })),
                   mutant("index 9 of one map", "tree-stepwise", {2, 2},
                          finds_wrongly([](const Map& map, std::uint32_t k, std::uint8_t& state) {
                            if (k == 9 && map.packed == Bytes{0, 0, 1, 0}) state ^= 2;
                          }))}},
      {entry::lookup}, round_trip_and_lookups_of_level_2);
}

Law samples_law() {
  const auto at = [](Level n, std::uint32_t index) {
    return finds_wrongly([=](const Map& map, std::uint32_t k, std::uint8_t& state) {
      if (map.level == n && k == index && map.format == Format::four_state) state ^= 1;
    });
  };
  return on_samples(
      {.id = "tree.on_samples",
       .says = "round trip, lookups by index and by point, and the paper's bytes, on maps of higher levels",
       .source = succinct_4_2,
       .subjects = {"tree-stream", "tree-ranked", "tree-stepwise", "tree-container"},
       .tiers = {.fast = {2, 12}, .long_run = {2, 12}, .seconds = 12},
       .mutants = {mutant("the last index of level 8", "tree-ranked", {8, 8}, at(8, 65535))}},
      {}, [](const TreeSubject& s, const Map& map) {
        // A lookup in the paper's form passes every node before its leaf.
        const bool walks = entry::stream.there(s.functions);
        const std::uint64_t most = map.level <= 6 ? 4096 : walks && map.level > 10 ? 16 : 64;
        Finding found = round_trip(s, map);
        const auto also = [&](const Finding& more) {
          if (!found.holds) return;
          const std::uint64_t so_far = found.answer;
          found = more;
          found.answer += 3 * so_far;
        };
        if (s.functions.lookup) also(lookups(s, map, most));
        if (s.functions.point) also(points(s, map, most));
        if (entry::stream.there(s.functions)) also(stream_is_specified(s, map));
        if (map.level <= 8) also(asked_in_turn(s, map));
        return found;
      });
}

}  // namespace

std::vector<Law> laws() {
  return {round_trip_law(),
          lookup_law(),
          with_points_on_floats(point_law()),
          point_exact_on_floats_law(),
          stream_law(),
          canonical_law(),
          sizes_law(),
          damage_law(),
          damage_samples_law(),
          one_apart_law(),
          one_apart_samples_law(),
          with_points_on_floats(samples_law()),
          four_state_law(),
          worst_size_law(),
          bits_read_law(),
          induction::all_levels_law()};
}

}  // namespace mmverify::proofs::tree
