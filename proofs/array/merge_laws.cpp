// Near-duplicate merging: a bound, and known into unknown alone.
#include "proofs/array/law_parts.hpp"
#include "proofs/array/laws.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

constexpr std::uint32_t most_bound = 2;

/// All pairs of the 278 maps of levels 0 and 1, then all triples of sorted ones, with a bound of 1 and 2; no special
/// indices, so that maps of level 0 merge, too.
std::uint64_t merged_pairs() { return std::uint64_t{all_maps(1).size()} * all_maps(1).size() * most_bound; }
std::uint64_t merged_triples() {
  const std::uint64_t sorted = sorted_maps(1).size();
  return sorted * sorted * sorted * most_bound;
}
BuildCase merged_number(std::uint64_t k) {
  BuildCase c;
  c.options.encoding = Encoding::u8;
  c.options.special = false;
  c.options.bound = 1 + static_cast<std::uint32_t>(k % most_bound);
  const bool two = k < merged_pairs();
  const auto& from = two ? all_maps(1) : sorted_maps(1);
  std::uint64_t rest = (two ? k : k - merged_pairs()) / most_bound;
  for (unsigned left = two ? 2 : 3; left > 0; --left) {
    c.maps.insert(c.maps.begin(), from[rest % from.size()]);
    rest /= from.size();
  }
  return c;
}

Finding merges(const Answer& a, const BuildCase& c) {
  for (const Check check : {stays_in_range, resolves, keeps_formats, counts_records})
    if (Finding found = check(a, c); !found.holds) return found;
  return {digest_of(a)};
}

/// The states of the first record are turned into others.
void restate(const BuildCase& c, Answer& a, State from, State to) {
  if (c.maps.size() < 2 || record_count(a) != 1) return;
  ReadMap read = read_map(a, 0);
  if (!read.unreadable.empty() || read.record.format != 2) return;
  for (State& s : read.states)
    if (s == from) s = to;
  a.data = maps::pack(read.states, Format::four_state);
}

}  // namespace

std::vector<Law> merge_laws() {
  return {on_cases(
      {.id = "array.merging",
       .says = "near-duplicate merging turns T and O into unknown states and nothing else, in at most as "
               "many micro-triangles of each triangle as the bound says; 2-state, formats and levels stay",
       .source = here,
       .subjects = {"array-spec", "array"},
       .tiers = {.fast = {1, 1}, .long_run = {1, 1}, .seconds = 4},
       .domain =
           "all pairs of maps of levels 0 and 1, all triples of sorted ones, both formats, bounds 1 and 2",
       .mutants = {mutant(
                       "a known state is merged into a transparent one", "array", {1, 1},
                       answering([](const BuildCase& c, Answer& a) { restate(c, a, State::UO, State::T); })),
                   mutant("UT beside UO merges", "array-spec", {1, 1}, building([](BuildCase& c) {
                            for (PackedMap& m : c.maps) {
                              States s = states_of(m);
                              for (State& x : s)
                                if (x == State::UT) x = State::UO;
                              m = packed(m.level, m.format, s);
                            }
                          })),
                   mutant("the bound is one more", "array", {1, 1},
                          building([](BuildCase& c) { ++c.options.bound; })),
                   mutant("a third map may take a record beyond the first one's bound", "array-spec", {1, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps.size() == 3 && record_count(a) == 1 &&
                                read_map(a, 0).record.level == 1)
                              a.data[0] = static_cast<std::uint8_t>(a.data[0] | 0x80);
                          })),
                   mutant("2-state merges by majority", "array", {1, 1}, building([](BuildCase& c) {
                            if (c.maps.size() == 2 && c.maps[0].format == Format::two_state &&
                                c.maps[1].format == Format::two_state && c.maps[0].level == c.maps[1].level &&
                                c.maps[0].level == 1)
                              c.maps[1] = c.maps[0];
                          }))}},
      {entry::build},
      built_cases([](Level n) { return n == 1 ? merged_pairs() + merged_triples() : 0; },
                  [](Level, std::uint64_t k) { return merged_number(k); }, merges))};
}

}  // namespace mmverify::proofs::array
