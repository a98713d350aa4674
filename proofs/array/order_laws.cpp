// Builders on one triangle of one state but for one node of the curve: where the order within a map shows.
#include "proofs/array/law_parts.hpp"
#include "proofs/array/laws.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::array {
namespace {

constexpr Level highest = 5;

BuildCase apart(Level n, std::uint64_t k) {
  const micromap::Map map = micromap::map_of(n, micromap::one_apart_number(n, k));
  BuildCase c;
  c.maps = {{map.level, map.format, map.packed}};
  c.options.encoding = Encoding::u8;
  c.options.special = false;
  return c;
}

/// A recursion that visits children 1 and 3 in each other's place below the second level.
void turn_from_level_2(BuildCase& c) {
  for (PackedMap& m : c.maps) {
    if (m.level < 2) continue;
    States s = states_of(m);
    for (std::size_t i = 0; i + 4 <= s.size(); i += 4) std::swap(s[i + 1], s[i + 3]);
    m = packed(m.level, m.format, s);
  }
}

}  // namespace

std::vector<Law> order_laws() {
  return {on_cases(
      {.id = "array.order",
       .says = "a triangle's micro-triangles come out in the order of the index, at every level",
       .source = array_source,
       .subjects = {"array-spec", "array"},
       .tiers = {.fast = {0, highest}, .long_run = {0, highest}, .seconds = 3},
       .domain =
           [](Level n) {
             return fmt::format(
                 "one triangle: all maps of level {} of one state but for one node of the curve", n);
           },
       .mutants = {mutant("order wrong from level 2 on", "array", {0, 3}, building(turn_from_level_2)),
                   mutant("bits from the most significant on", "array-spec", {1, 2},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps[0].format != Format::two_state || c.maps[0].level < 2) return;
                            for (std::uint8_t& b : a.data) {
                              std::uint8_t turned = 0;
                              for (unsigned j = 0; j < 8; ++j)
                                turned = static_cast<std::uint8_t>(turned | (b >> j & 1) << (7 - j));
                              b = turned;
                            }
                          })),
                   mutant("the last micro-triangle of level 5 is the first", "array", {5, 5},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps[0].level == 5 && c.maps[0].format == Format::four_state)
                              a.data.back() =
                                  static_cast<std::uint8_t>((a.data.back() & 0x3f) | a.data.front() << 6);
                          }))}},
      {entry::build},
      {[](Level n) { return n > highest ? 0 : micromap::one_apart_count(n); },
       [](const ArraySubject& s, Level n, std::uint64_t k, const Run&) {
         return built(s, apart(n, k), resolves);
       },
       [](Level n, std::uint64_t k, const Run&) {
         return micromap::text_of(micromap::one_apart_number(n, k));
       },
       [](const ArraySubject& s, Level n, const std::string& at) {
         const auto which = micromap::apart_from_text(n, at);
         if (!which) throw BadCase("'" + at.substr(0, 60) + "': write 4-state:0+2@3:17");
         const micromap::Map map = micromap::map_of(n, *which);
         BuildCase c = apart(0, 0);
         c.maps = {{map.level, map.format, map.packed}};
         return built(s, c, resolves);
       }})};
}

}  // namespace mmverify::proofs::array
