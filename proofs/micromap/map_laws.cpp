// Laws of packed maps.  Each oracle works state by state, without words.
#include "proofs/engine/spoils.hpp"
#include "proofs/micromap/law_parts.hpp"
#include "proofs/micromap/laws.hpp"
#include "spec/micromap/lossy.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace slow = mmverify::spec::micromap;
using slow::micro_triangles;
using enum State;

constexpr Format two = Format::two_state, four = Format::four_state;

States states_of(const PackedMap& map) {
  return slow::unpack(map.bytes, map.format, micro_triangles(map.level));
}

Bytes codes(const States& states) {
  Bytes out;
  for (const State s : states) out.push_back(slow::code(s));
  return out;
}

// Flips a bit of the packed bytes, if they have it.
void flip(Bytes& bytes, std::size_t bit) {
  if (bit / 8 < bytes.size()) bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
}

// Mutants recognize the map that they spoil.
bool is(Level n, std::span<const std::uint8_t> in, Level level, std::initializer_list<std::uint8_t> bytes) {
  return n == level && std::equal(in.begin(), in.end(), bytes.begin(), bytes.end());
}

// The result of `make` is `expected` for any padding.
Finding always(const char* what, const PackedMap& map, const Bytes& expected,
               const std::function<Bytes(const Bytes&)>& make) {
  Finding found;
  for (const Bytes& bytes : with_paddings(map)) {
    found = same(what, expected, make(bytes));
    if (!found.holds) return found;
  }
  return found;
}

Finding packs(const MicromapSubject& s, const PackedMap& map) {
  const States states = states_of(map);
  return all(always("states", map, codes(states),
                    [&](const Bytes& b) { return codes(s.functions.unpack(map.format, states.size(), b)); }),
             same("packed", map.bytes, s.functions.pack(map.format, states)));
}

Finding forces(const MicromapSubject& s, const PackedMap& map) {
  const States states = states_of(map);
  if (map.format == four)
    return always("force-2-state", map, slow::pack(slow::force2(states), two),
                  [&](const Bytes& b) { return s.functions.force2(map.level, b); });
  const Bytes wide = slow::pack(states, four);
  return all(always("4-state", map, wide, [&](const Bytes& b) { return s.functions.widen(map.level, b); }),
             same("and back", map.bytes, s.functions.force2(map.level, wide)));
}

Finding rises(const MicromapSubject& s, const PackedMap& map) {
  States expected;
  for (const State state : states_of(map)) expected.insert(expected.end(), 4, state);
  return always("children's states", map, slow::pack(expected, map.format),
                [&](const Bytes& b) { return s.functions.up(map.level, map.format, b); });
}

Finding rises_and_falls(const MicromapSubject& s, const PackedMap& map) {
  return always("down(up(map))", map, map.bytes, [&](const Bytes& b) {
    return s.functions.down(map.level + 1, map.format, s.functions.up(map.level, map.format, b));
  });
}

// The parent of four children, by the promises only.
State parent_of(Format f, std::span<const State> children) {
  unsigned T_count = 0, O_count = 0, opaque = 0;
  for (const State child : children) {
    T_count += child == T;
    O_count += child == O;
    opaque += slow::force2(child) == O;
  }
  const State forced = opaque >= 2 ? O : T;
  return f == four && T_count != 4 && O_count != 4 ? slow::as_unknown(forced) : forced;
}

States parents_of(Format f, const States& children) {
  States parents;
  for (std::size_t i = 0; i < children.size(); i += 4)
    parents.push_back(parent_of(f, std::span(children).subspan(i, 4)));
  return parents;
}

Finding falls(const MicromapSubject& s, const PackedMap& map) {
  const States parents = parents_of(map.format, states_of(map));
  Finding found;
  for (const Bytes& bytes : with_paddings(map)) {
    const Bytes down = s.functions.down(map.level, map.format, bytes);
    if (down.size() != slow::packed_bytes(parents.size(), map.format))
      return wrong("a map of the level below", fmt::format("{} bytes", down.size()));
    const States got = slow::unpack(down, map.format, parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i)
      if (got[i] != parents[i])
        return wrong(fmt::format("parent {} state {}", i, slow::code(parents[i])),
                     fmt::format("{}", slow::code(got[i])));
    found = same("packed", slow::pack(parents, map.format), down);
    if (!found.holds) return found;
  }
  return found;
}

// Both orders of operations against the expected map, not only against each other.
Finding forces_and_falls(const MicromapSubject& s, const PackedMap& map) {
  const States states = states_of(map);
  const Bytes wide = map.format == four ? map.bytes : slow::pack(states, four),
              expected = slow::pack(slow::force2(parents_of(four, states)), two);
  return all(always("down of force-2-state", {map.level, four, wide}, expected,
                    [&](const Bytes& b) {
                      return s.functions.down(map.level, two, s.functions.force2(map.level, b));
                    }),
             always("force-2-state of down", {map.level, four, wide}, expected, [&](const Bytes& b) {
               return s.functions.force2(map.level - 1, s.functions.down(map.level, four, b));
             }));
}

// T/O forces.  T/C and O/C keep one state, and all other states become one unknown state, since one bit cannot tell
// them apart.
Finding goes_through(const MicromapSubject& s, const PackedMap& map, const States& was, Mode mode) {
  const State kept = mode == Mode::T_C ? T : O;
  Finding found;
  for (const Bytes& given : with_paddings(map)) {
    const Bytes bytes = s.functions.through(map.level, mode, given);
    if (bytes.size() != map.bytes.size())
      return wrong(fmt::format("{} bytes through mode {}", map.bytes.size(), static_cast<int>(mode)),
                   fmt::format("{}", bytes.size()));
    const States is = slow::unpack(bytes, four, was.size());
    std::optional<State> rest;
    for (std::size_t i = 0; i < was.size(); ++i) {
      const char* should = "forced";
      bool holds = is[i] == slow::force2(was[i]);
      if (mode != Mode::T_O) {
        should = was[i] == kept ? "kept" : rest ? "the unknown of the others" : "unknown";
        holds = was[i] == kept ? is[i] == kept : slow::unknown(is[i]) && is[i] == rest.value_or(is[i]);
        if (was[i] != kept) rest = is[i];
      }
      if (!holds)
        return wrong(fmt::format("state {} {} through mode {}", i, should, static_cast<int>(mode)),
                     fmt::format("{} from {}", slow::code(is[i]), slow::code(was[i])));
    }
    found = same("packed", slow::pack(is, four), bytes);
    if (!found.holds) return found;
  }
  return found;
}

Finding goes_through_modes(const MicromapSubject& s, const PackedMap& map) {
  const States was = states_of(map);
  return all(goes_through(s, map, was, Mode::T_O), goes_through(s, map, was, Mode::T_C),
             goes_through(s, map, was, Mode::O_C));
}

// Every entry point that the subject has.  Level 12 is the highest: up does not start from there.
Finding everything(const MicromapSubject& s, const PackedMap& map) {
  Finding found;
  const auto also = [&](bool asked, Finding (*check)(const MicromapSubject&, const PackedMap&)) {
    if (!asked || !found.holds) return;
    const std::uint64_t so_far = found.answer;
    found = check(s, map);
    found.answer += 31 * so_far;
  };
  const bool up = s.functions.up && map.level < 12, down = s.functions.down && map.level > 0,
             force = bool{s.functions.force2};
  also(bool{s.functions.pack}, packs);
  also(force, forces);
  also(up, rises);
  also(up && s.functions.down, rises_and_falls);
  also(down, falls);
  also(down && force, forces_and_falls);
  also(s.functions.through && map.format == four, goes_through_modes);
  return found;
}

const std::vector<std::string> both{"micromap-spec", "micromap"};

Law packing() {
  return on_all_maps(
      {.id = "micromap.packing",
       .says = "unpacking gives each state whatever the padding holds; packing gives zeros there",
       .source = packing_source,
       .subjects = both,
       .tiers = {.seconds = 1},
       .mutants = {mutant("the last bit of one 2-state map of level 2 is lost", "micromap-spec", {2, 2},
                          spoils(&Functions::pack,
                                 [](Format f, const States& s, Bytes& out) {
                                   if (f == two && s.size() == 16 && out == Bytes{0x01, 0x80}) out[1] = 0;
                                 }))}},
      {entry::pack}, Maps::both_formats, 0, packs);
}

Law force2() {
  return on_all_maps(
      {.id = "micromap.force2",
       .says =
           "force-2-state is T for T and UT, O for O and UO; a 2-state map made 4-state and forced is itself",
       .source = "Vulkan's Opacity Micromaps (Vulkanised 2026), force2state",
       .subjects = both,
       .tiers = {.seconds = 1},
       .mutants = {mutant("one O of level 2 is widened to UO", "micromap-spec", {2, 2},
                          spoils(&Functions::widen,
                                 [](Level n, auto in, Bytes& out) {
                                   if (is(n, in, 2, {0x00, 0x80})) flip(out, 31);
                                 }))}},
      {entry::force2}, Maps::both_formats, 0, forces);
}

Law up_law() {
  return on_all_maps(
      {.id = "micromap.up",
       .says = "one level up, each state is that of its four children: up commutes with packing",
       .source = design_source,
       .subjects = both,
       .tiers = {.seconds = 1},
       .mutants = {mutant("the last child of one map is T", "micromap", {2, 2},
                          spoils(&Functions::up,
                                 [](Level n, Format, auto in, Bytes& out) {
                                   if (is(n, in, 2, {0xff, 0xff})) flip(out, 63);
                                 }))}},
      {entry::up}, Maps::both_formats, 0, rises);
}

Law down_up() {
  return on_all_maps({.id = "micromap.down_up",
                      .says = "one level up and down again is the map itself",
                      .source = design_source,
                      .subjects = both,
                      .tiers = {.seconds = 1},
                      .mutants = {mutant("the last of 64 is lost", "micromap-spec", {2, 2},
                                         spoils(&Functions::down,
                                                [](Level n, Format f, auto in, Bytes& out) {
                                                  if (f == two && n == 3 && in[7] == 0xf0 && in[0] == 0)
                                                    flip(out, 15);
                                                }))}},
                     {entry::up, entry::down}, Maps::both_formats, 0, rises_and_falls);
}

Law down_law() {
  return on_all_maps({.id = "micromap.down",
                      .says = "one level down, T stands for four T and O for four O only; else 4-state is "
                              "unknown; force-2-state is the children's majority, a tie opaque",
                      .source = design_source,
                      .subjects = both,
                      .tiers = {.seconds = 1},
                      .mutants = {mutant("three O of the last four, 2-state, are T", "micromap-spec", {2, 2},
                                         spoils(&Functions::down,
                                                [](Level n, Format f, auto in, Bytes& out) {
                                                  if (f == two && is(n, in, 2, {0x00, 0xe0})) flip(out, 3);
                                                }))}},
                     {entry::down}, Maps::both_formats, 1, falls);
}

Law down_force2() {
  return on_all_maps({.id = "micromap.down_force2",
                      .says = "force-2-state and one level down commute, and are the children's majority",
                      .source = design_source,
                      .subjects = both,
                      .tiers = {.seconds = 1},
                      .mutants = {mutant("force-2-state of one lone UO is T", "micromap-spec", {1, 1},
                                         spoils(&Functions::force2,
                                                [](Level n, auto in, Bytes& out) {
                                                  if (n == 0 && (in[0] & 3) == 3) out[0] = 0;
                                                }))}},
                     {entry::down, entry::force2}, Maps::both_formats, 1, forces_and_falls);
}

Law modes() {
  return on_all_maps(
      {.id = "micromap.modes",
       .says = "through T/C and O/C, T (O) stays and the rest is one of the unknown states; T/O forces",
       .source = "Succinct Opacity Micromaps, 7 (left to the future); docs/MICROMAP.md",
       .subjects = both,
       .tiers = {.seconds = 1},
       .mutants = {mutant("UT and UO of one map stay apart in O/C", "micromap", {1, 1},
                          spoils(&Functions::through,
                                 [](Level n, Mode m, auto in, Bytes& out) {
                                   if (m == Mode::O_C && is(n, in, 1, {0b11'10'01'01})) out.assign(1, in[0]);
                                 }))}},
      {entry::modes}, Maps::four_state, 0, goes_through_modes);
}

// The mutants change one state of a sample at level 5 and above.
Law samples() {
  return on_samples(
      {.id = "micromap.on_samples",
       .says = "packing, force-2-state, up, down and the modes, as on the small levels",
       .source = packing_source,
       .subjects = {"micromap"},
       .tiers = {.fast = {2, 8}, .long_run = {2, 12}, .seconds = 3},
       .mutants = {mutant("a tie in the last byte of level 5 is transparent", "micromap", {5, 5},
                          spoils(&Functions::down,
                                 [](Level n, Format f, auto in, Bytes& out) {
                                   if (n == 5 && f == four && (in.back() & 0x55) == 0x14) flip(out, 510);
                                 }))}},
      {}, Maps::both_formats, everything);
}

}  // namespace

std::vector<Law> map_laws() {
  return {packing(), force2(), up_law(), down_up(), down_law(), down_force2(), modes(), samples()};
}

}  // namespace mmverify::proofs::micromap
