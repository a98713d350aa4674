// Graphs of so many maps that a map's number has two bytes, or three.
#include "proofs/dag/law_parts.hpp"

namespace mmverify::proofs::dag {
namespace {

/// Lookups that take one map for another.
Change takes_for(std::function<std::uint32_t(std::uint32_t map)> other) {
  return [other](Functions& f) {
    f.lookup = [other, real = f.lookup](const Code& code, Numbers map, Numbers index,
                                        std::span<std::uint8_t> state) {
      std::vector<std::uint32_t> others;
      for (const std::uint32_t m : map) others.push_back(other(m));
      real(code, others, index, state);
    };
  };
}

}  // namespace

Law many_maps_law() {
  return on_many_maps(
      {.id = "dag.many_maps",
       .says = "round trip and lookups, on scenes of more than 256 maps, and of more than 2^16",
       .source = form,
       .subjects = {"dag-spec", "dag"},
       .tiers = {.seconds = 0.6},
       .mutants = {mutant("the 257th map answers as the first", "dag", {0, 0},
                          takes_for([](std::uint32_t m) { return m == 256 ? 0 : m; })),
                   mutant("the last of more than 2^16 maps is another one", "dag-spec", {0, 0},
                          decodes_wrongly([](Scene& scene) {
                            if (scene.maps.size() > 65'536) scene.maps.back().packed[0] ^= 1;
                          })),
                   mutant("numbers of maps have 16 bits", "dag", {0, 0},
                          takes_for([](std::uint32_t m) { return m & 0xFFFF; })),
                   mutant("maps from number 300 on are encoded anew from the first", "dag", {0, 3},
                          encodes_another([](Scene& scene) {
                            for (std::size_t m = 300; m < scene.maps.size(); ++m)
                              if (scene.maps[m].level == scene.maps[m - 300].level)
                                scene.maps[m] = scene.maps[m - 300];
                          }))}},
      {}, [](const DagSubject& s, const Scene& scene) {
        const Finding found = round_trip(s, scene);
        if (!found.holds || !s.functions.lookup) return found;
        return lookups(s, scene, 3000);
      });
}

}  // namespace mmverify::proofs::dag
