#include "proofs/dag/laws.hpp"

#include "proofs/dag/induction/provable.hpp"
#include "proofs/dag/law_parts.hpp"

namespace mmverify::proofs::dag {
namespace {

void flip(Map& map, std::size_t bit) {
  map.packed[bit / 8] = static_cast<std::uint8_t>(map.packed[bit / 8] ^ 1u << bit % 8);
}

/// The bug of a builder that takes two tiles for equal if they differ in the last state only.
void merge_near_tiles(Scene& scene) {
  const std::size_t tile = 8 * bits(scene.format);
  const Bytes* first = nullptr;
  std::size_t first_at = 0;
  for (Map& map : scene.maps)
    for (std::size_t at = 0; at + tile <= map.packed.size(); at += tile) {
      const auto here = map.packed.begin() + static_cast<std::ptrdiff_t>(at);
      if (std::all_of(here, here + static_cast<std::ptrdiff_t>(tile), [&](auto x) { return x == *here; }))
        continue;
      if (first == nullptr) {
        first = &map.packed;
        first_at = at;
        continue;
      }
      const auto known = first->begin() + static_cast<std::ptrdiff_t>(first_at);
      if (std::equal(here, here + static_cast<std::ptrdiff_t>(tile) - 1, known))
        std::copy(known, known + static_cast<std::ptrdiff_t>(tile), here);
    }
}

Law round_trip_law() {
  return on_small_scenes(
      {.id = "dag.round_trip",
       .says = "a graph's maps are those that were added, in their order, and their padding bits are zero",
       .source = form,
       .subjects = {"dag-spec", "dag", "dag-loaded"},
       .tiers = {.seconds = 0.8},
       .mutants = {mutant("tiles that differ in the last state are one", "dag", {3, 4},
                          encodes_another(merge_near_tiles)),
                   mutant("the second of two maps is the first", "dag-spec", {1, 1},
                          decodes_wrongly([](Scene& scene) {
                            if (scene.maps.size() == 2 && scene.maps[0].packed[0] == 0x1B)
                              scene.maps[1] = scene.maps[0];
                          })),
                   mutant("a padding bit that is set", "dag", {0, 0}, decodes_wrongly([](Scene& scene) {
                            if (scene.format == Format::four_state && scene.maps.back().packed[0] == 3)
                              scene.maps.back().packed[0] = 7;
                          })),
                   mutant("the third tile of a map is its second", "dag", {4, 4},
                          encodes_another([](Scene& scene) {
                            Bytes& map = scene.maps[1].packed;
                            const auto tile = static_cast<std::ptrdiff_t>(8 * bits(scene.format));
                            if (scene.maps[1].level == 4)
                              std::copy(map.begin() + tile, map.begin() + 2 * tile, map.begin() + 2 * tile);
                          }))}},
      {}, round_trip);
}

Law lookup_law() {
  return on_small_scenes(
      {.id = "dag.lookup_is_decode",
       .says = "a lookup at an index gives the map's state, whatever else is asked with it",
       .source = form,
       .subjects = {"dag-spec", "dag"},
       .tiers = {.seconds = 1.5},
       .mutants = {mutant("the last index of one map", "dag", {2, 2},
                          finds_wrongly(
                              [](const Scene& scene, std::uint32_t, std::uint32_t k, std::uint8_t& state) {
                                if (k == 15 && scene.maps[0].packed == Bytes{0x34, 0x12}) state ^= 1;
                              })),
                   mutant("the second map is looked up in the first", "dag", {3, 4},
                          finds_wrongly([](const Scene& scene, std::uint32_t map, std::uint32_t k,
                                           std::uint8_t& state) {
                            if (map == 1 && k == 63) state = state_at(scene.maps[0], scene.format, k);
                          })),
                   mutant("the high bit of a state of child 3 is lost", "dag-spec", {4, 4},
                          finds_wrongly([](const Scene& scene, std::uint32_t map, std::uint32_t k,
                                           std::uint8_t& state) {
                            if (map == 0 && k == 197 && scene.maps[0].level == 4) state &= 1;
                          }))}},
      {entry::lookup}, [](const DagSubject& s, const Scene& scene) { return lookups(s, scene, 1024); });
}

Law masks_law() {
  return on_masks(
      {.id = "dag.masks",
       .says = "round trip and lookups at both ends of each child, whichever children are mixed",
       .source = form,
       .subjects = {"dag"},
       .tiers = {.seconds = 1.4},
       .mutants = {mutant("child 15 of a full node", "dag", {5, 5}, decodes_wrongly([](Scene& scene) {
                            Map& map = scene.maps[0];
                            if (map.level == 5 && scene.format == Format::two_state && map.packed[0] == 9 &&
                                map.packed.back() == 0x90 && map.packed[8 * 14 + 7] != 0)
                              flip(map, 1023);
                          })),
                   mutant("two children change places", "dag", {4, 5}, encodes_another([](Scene& scene) {
                            Bytes& map = scene.maps[0].packed;
                            const auto tile = static_cast<std::ptrdiff_t>(8 * bits(scene.format));
                            if (scene.maps[0].level == 5 && map[0] == 9)
                              std::swap_ranges(map.end() - 2 * tile, map.end() - tile, map.end() - tile);
                          })),
                   mutant("the last index of child 0", "dag", {6, 6},
                          finds_wrongly(
                              [](const Scene& scene, std::uint32_t, std::uint32_t k, std::uint8_t& state) {
                                if (scene.maps[0].level == 6 && k == 1023) state ^= 1;
                              }))}},
      {entry::lookup}, [](const DagSubject& s, const Scene& scene) {
        const Code code = s.functions.encode(scene);
        const Scene decoded = s.functions.decode(code);
        if (!(decoded == scene)) return round_trip(s, scene);
        const Level n = scene.maps[0].level;
        const std::uint64_t run = spec::micromap::micro_triangles(spec::dag::child_level(n));
        std::vector<std::uint32_t> index;
        for (std::uint64_t c = 0; c < spec::dag::children(n); ++c)
          for (const std::uint64_t k : {std::uint64_t{0}, c * run / 16, run - 1})
            index.push_back(static_cast<std::uint32_t>(c * run + k));
        const std::vector<std::uint32_t> map(index.size(), 0);
        Bytes states(index.size(), 0xFF);
        s.functions.lookup(code, map, index, states);
        for (std::size_t k = 0; k < states.size(); ++k)
          if (states[k] != state_at(scene.maps[0], scene.format, index[k]))
            return lookups(s, scene, ~std::uint64_t{0});
        return Finding{hash_of(states)};
      });
}

Law point_law() {
  return on_samples(
      {.id = "dag.point_is_index",
       .says = "a lookup at barycentrics is that at the reference's index",
       .source = "docs/DAG.md; VK_EXT_opacity_micromap, reference code",
       .subjects = {"dag-spec", "dag"},
       .tiers = {.fast = {0, 10}, .long_run = {0, 12}, .seconds = 1.6},
       .mutants = {mutant("the u-corner of level 5", "dag", {5, 5},
                          [](Functions& f) {
                            f.point = [real = f](const Code& c, Numbers map, std::span<const float> u,
                                                 std::span<const float> v, std::span<std::uint8_t> state) {
                              real.point(c, map, u, v, state);
                              for (std::size_t k = 0; k < state.size(); ++k)
                                if (u[k] > 0.75f) state[k] ^= 1;
                            };
                          }),
                   mutant("u and v exchanged", "dag", {1, 6},
                          [](Functions& f) {
                            f.point = [real = f](const Code& c, Numbers map, std::span<const float> u,
                                                 std::span<const float> v, std::span<std::uint8_t> state) {
                              real.point(c, map, v, u, state);
                            };
                          }),
                   mutant("points of the first map alone", "dag-spec", {2, 6},
                          [](Functions& f) {
                            f.point = [real = f](const Code& c, Numbers map, std::span<const float> u,
                                                 std::span<const float> v, std::span<std::uint8_t> state) {
                              const std::vector<std::uint32_t> first(map.size(), 0);
                              real.point(c, first, u, v, state);
                            };
                          })}},
      {entry::point}, falling({{6, 30}, {8, 6}}, 2),
      [](const DagSubject& s, const Scene& scene) { return points(s, scene, 200); });
}

Law samples_law() {
  return on_samples(
      {.id = "dag.on_samples",
       .says = "round trip and lookups, on scenes of higher levels",
       .source = form,
       .subjects = {"dag", "dag-loaded"},
       .tiers = {.fast = {3, 12}, .long_run = {3, 12}, .seconds = 2.8},
       .mutants = {mutant("tiles that differ in the last state are one", "dag", {3, 7},
                          encodes_another(merge_near_tiles)),
                   mutant("the first index of level 8", "dag", {8, 8},
                          finds_wrongly([](const Scene& scene, std::uint32_t map, std::uint32_t k,
                                           std::uint8_t& state) {
                            if (scene.maps[map].level == 8 && k < 256) state ^= 1;
                          })),
                   mutant("the last byte of level 11", "dag", {11, 11}, decodes_wrongly([](Scene& scene) {
                            if (scene.maps.back().level == 11) scene.maps.back().packed.back() ^= 0x80;
                          }))}},
      {}, falling({{6, 200}, {8, 40}, {10, 10}}, 2), [](const DagSubject& s, const Scene& scene) {
        const Finding found = round_trip(s, scene);
        if (!found.holds || !s.functions.lookup) return found;
        return lookups(s, scene, 3000);
      });
}

Law specified_law() {
  return on_samples(
      {.id = "dag.equals_spec",
       .says = "the container of maps is the specification's, byte by byte",
       .source = form,
       .subjects = {"dag", "dag-loaded"},
       .tiers = {.fast = {0, 10}, .long_run = {0, 12}, .seconds = 2},
       .mutants = {mutant("a tile that is there is stored again", "dag", {4, 7},
                          writes_wrongly([](const Scene&, Bytes& bytes) {
                            if (bytes[12] > 1) bytes.insert(bytes.end(), 8, 0);
                          })),
                   mutant("maps are added last to first", "dag", {2, 6}, encodes_another([](Scene& scene) {
                            std::reverse(scene.maps.begin(), scene.maps.end());
                          })),
                   mutant("a checksum of zero", "dag", {0, 0}, writes_wrongly([](const Scene&, Bytes& bytes) {
                            if (bytes.size() == 40) bytes[28] = bytes[29] = bytes[30] = bytes[31] = 0;
                          }))}},
      {entry::container}, falling({{6, 200}, {8, 30}, {10, 3}}, 1), is_specified);
}

Law records_law() {
  return on_small_scenes({.id = "dag.canonical",
                          .says = "the container of two maps is the specification's; where they are the "
                                  "same, their records are, and else not",
                          .source = form,
                          .subjects = {"dag", "dag-loaded"},
                          .tiers = {.seconds = 2.2},
                          .mutants = {mutant("tiles that differ in the last state are one", "dag", {3, 4},
                                             encodes_another(merge_near_tiles)),
                                      mutant("the second of two maps of level 4 is the first", "dag", {4, 4},
                                             encodes_another([](Scene& scene) {
                                               if (scene.maps.size() == 2 && scene.maps[0].level == 4)
                                                 scene.maps[1] = scene.maps[0];
                                             })),
                                      mutant("level 1 stands in a record as level 0", "dag", {1, 1},
                                             writes_wrongly([](const Scene& scene, Bytes& bytes) {
                                               if (scene.maps[0].level == 1 && scene.maps[0].packed[0] == 0)
                                                 bytes[32] = 0;
                                             })),
                                      mutant("a set bit in a record's zeros", "dag", {2, 2},
                                             writes_wrongly([](const Scene& scene, Bytes& bytes) {
                                               if (scene.maps[0].packed == Bytes{0xFF, 0x7F}) bytes[34] = 1;
                                             }))}},
                         {entry::container}, [](const DagSubject& s, const Scene& scene) {
                           const Finding found = is_specified(s, scene);
                           if (!found.holds || scene.maps.size() != 2) return found;
                           const Finding records = same_records(s, scene);
                           return records.holds ? found : records;
                         });
}

Law append_law() {
  return on_samples(
      {.id = "dag.append",
       .says =
           "a map that is added lets the four arrays grow at their ends, and changes no word that is there",
       .source = form,
       .subjects = {"dag", "dag-loaded"},
       .tiers = {.fast = {0, 10}, .long_run = {0, 12}, .seconds = 0.2},
       .mutants = {mutant("arrays of a scene of three maps begin with the last", "dag", {3, 7},
                          encodes_another([](Scene& scene) {
                            if (scene.maps.size() == 3) std::swap(scene.maps[0], scene.maps[2]);
                          })),
                   mutant("the last word of nodes", "dag", {5, 7},
                          writes_wrongly([](const Scene& scene, Bytes& bytes) {
                            if (scene.maps.size() == 2) bytes.back() ^= 1;
                          })),
                   mutant("a record of its own for two maps", "dag-spec", {4, 6},
                          writes_wrongly([](const Scene& scene, Bytes& bytes) {
                            if (scene.maps.size() == 2) bytes[36] ^= 1;
                          }))}},
      {entry::container}, falling({{6, 100}, {8, 20}, {10, 4}}, 1), appends);
}

Law bound_law() {
  return on_samples(
      {.id = "dag.bound",
       .says = "the arrays take no more than the maps flat with a record of 64 bits each, however alike the "
               "maps are; a map that is there takes a record",
       .source = form,
       .subjects = {"dag", "dag-spec"},
       .tiers = {.fast = {0, 9}, .long_run = {0, 12}, .seconds = 2.4},
       .mutants = {mutant("nodes are kept, however large", "dag", {4, 6},
                          writes_wrongly([](const Scene& scene, Bytes& bytes) {
                            if (scene.maps.back().level >= 4 && bytes[16] != 0) {
                              ++bytes[12];  // one tile more beside maps that lie flat
                              bytes.insert(bytes.end(), 8 * bits(scene.format), 0);
                            }
                          })),
                   mutant("a map that is there has its own tiles", "dag", {3, 6},
                          writes_wrongly([](const Scene& scene, Bytes& bytes) {
                            const std::size_t count = scene.maps.size();
                            if (count >= 2 && scene.maps[count - 1] == scene.maps[count - 2]) {
                              ++bytes[12];
                              bytes.insert(bytes.end(), 8 * bits(scene.format), 0);
                            }
                          })),
                   mutant("a small map has its own tile", "dag", {0, 2},
                          writes_wrongly([](const Scene& scene, Bytes& bytes) {
                            if (scene.maps.size() == 1) {
                              ++bytes[12];
                              bytes.insert(bytes.end(), 8 * bits(scene.format), 0);
                            }
                          }))}},
      {entry::container}, falling({{6, 100}, {8, 20}, {10, 3}}, 1), is_bounded);
}

Change takes_too_much(std::function<bool(const Bytes&)> when) {
  return [=](Functions& functions) {
    functions.open = [when, real = functions](Format f, std::span<const std::uint8_t> bytes) {
      auto code = real.open(f, bytes);
      if (!code && when(Bytes(bytes.begin(), bytes.end()))) code = real.encode({f, {{0, {0}}}});
      return code;
    };
  };
}

Law damage_law() {
  return on_samples(
      {.id = "dag.malformed",
       .says = "a container cut anywhere, longer, or with one bit flipped, its checksum put right, is taken "
               "exactly where the specification takes it",
       .source = form,
       .subjects = {"dag"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 6}, .seconds = 4.6},
       .mutants = {mutant("takes an empty string", "dag", {0, 0},
                          takes_too_much([](const Bytes& b) { return b.empty(); })),
                   mutant("takes bits in a record's zeros", "dag", {1, 3},
                          takes_too_much([](const Bytes& b) { return b.size() > 40 && b[34] == 4; })),
                   mutant("takes nodes of an odd number of words", "dag", {4, 5},
                          takes_too_much([](const Bytes& b) { return b.size() > 32 && b[20] % 2 == 1; })),
                   mutant("does not look at the checksum's last byte", "dag", {2, 4},
                          [](Functions& functions) {
                            functions.open = [real = functions.open](Format f,
                                                                     std::span<const std::uint8_t> bytes) {
                              Bytes b(bytes.begin(), bytes.end());
                              if (b.size() >= 32)
                                b[31] = static_cast<std::uint8_t>(spec::dag::checksum(b) >> 24);
                              return real(f, b);
                            };
                          })}},
      {entry::container, entry::reads}, falling({{4, 60}}, 20), [](const DagSubject& s, const Scene& scene) {
        // Large scenes use their first map only, since every bit of the code makes a case.
        const Scene first{
            scene.format,
            {scene.maps.begin(),
             scene.maps.begin() +
                 (scene.maps.back().level > 4 ? 1 : static_cast<std::ptrdiff_t>(scene.maps.size()))}};
        return damage(s, first, true, 0);
      });
}

Law damage_samples_law() {
  return on_samples(
      {.id = "dag.malformed_on_samples",
       .says = "a container with words changed, moved, copied, added or taken away, its checksum put right, "
               "is taken exactly where the specification takes it",
       .source = form,
       .subjects = {"dag"},
       .tiers = {.fast = {3, 7}, .long_run = {3, 8}, .seconds = 0.9},
       .mutants =
           {mutant("takes any kind of a record", "dag", {3, 6},
                   takes_too_much([](const Bytes& b) { return b.size() > 40 && b[33] > 4 && b[34] == 0; })),
            mutant("takes nodes though the first map has none", "dag", {4, 6},
                   takes_too_much([](const Bytes& b) { return b.size() > 40 && b[20] != 0 && b[33] < 3; })),
            mutant("takes one tile too many", "dag", {3, 6}, takes_too_much([](const Bytes& b) {
                     return b.size() % 8 == 0 && b[12] == 2 && b[32] == 4;
                   })),
            mutant("takes a flat map again whatever came after it", "dag", {4, 6},
                   takes_too_much([](const Bytes& b) {
                     if (b.size() <= 48 || b[8] <= 4 || b[33] != 4) return false;
                     const std::size_t last = 32 + 8 * std::size_t{b[8]} - 8;
                     return b.size() > last + 8 && std::equal(b.begin() + 32, b.begin() + 40,
                                                              b.begin() + static_cast<std::ptrdiff_t>(last));
                   })),
            mutant("refuses what has two tiles", "dag", {3, 6},
                   [](Functions& functions) {
                     functions.open = [real = functions.open](Format f, std::span<const std::uint8_t> bytes) {
                       return bytes[12] == 2 ? std::nullopt : real(f, bytes);
                     };
                   })}},
      {entry::container, entry::reads}, falling({{5, 60}, {6, 20}}, 6),
      [](const DagSubject& s, const Scene& scene) { return damage(s, scene, false, 60); });
}

}  // namespace

std::vector<Law> laws() {
  return {round_trip_law(),    lookup_law(),
          masks_law(),         point_law(),
          samples_law(),       many_maps_law(),
          specified_law(),     records_law(),
          append_law(),        bound_law(),
          damage_law(),        damage_samples_law(),
          damaged_codes_law(), induction::all_levels_law()};
}

}  // namespace mmverify::proofs::dag
