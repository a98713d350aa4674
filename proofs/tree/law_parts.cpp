#include "proofs/tree/law_parts.hpp"

namespace mmverify::proofs::tree {
namespace {

constexpr std::uint64_t maps_per_chunk = 256;

/// The number of maps, map k, and its text.
struct Domain {
  CaseCount count;
  std::function<Map(Level, std::uint64_t, const Run&)> map;
  std::function<std::string(const Map&, std::uint64_t, const Run&)> text;
  std::uint64_t chunk = maps_per_chunk;
};

Law on_maps(Law law, std::vector<Entry> entries, const Check& check, const Domain& domain) {
  return on_cases(
      std::move(law), std::move(entries),
      {domain.count,
       [=](const TreeSubject& s, Level n, std::uint64_t k, const Run& run) {
         return check(s, domain.map(n, k, run));
       },
       [=](Level n, std::uint64_t k, const Run& run) { return domain.text(domain.map(n, k, run), k, run); },
       [=](const TreeSubject& s, Level n, const std::string& at) { return check(s, map_from_text(n, at)); },
       domain.chunk});
}

}  // namespace

Law on_cases(Law law, std::vector<Entry> entries, Cases cases) {
  law.unfit = needing(std::move(entries));
  return on_cases_of(std::move(law), std::move(cases));
}

Finding wrong(const std::string& where, const std::string& expected, std::string got) {
  return proofs::wrong(where + " " + expected, std::move(got));
}

Unfit needing(std::vector<Entry> entries) {
  return unless_of_topic<TreeSubject>(
      lacking<TreeSubject>(std::move(entries), above_its_levels<TreeSubject>));
}

Law on_all_maps(Law law, std::vector<Entry> entries, Check check) {
  law.tiers.fast = law.tiers.long_run = {0, 2};
  law.domain = [](Level n) {
    return fmt::format("all {} maps of level {}", n < 2 ? "2-state and 4-state" : "65,536 2-state", n);
  };
  law = on_maps(std::move(law), std::move(entries), check,
                {[](Level n) { return n <= 2 ? map_count(n) : 0; },
                 [](Level n, std::uint64_t k, const Run&) { return map_number(n, k); },
                 [](const Map& map, std::uint64_t, const Run&) { return text_of_states(map); }});
  law.unfit = [fits = law.unfit](const Subject& s, Level n) -> std::optional<std::string> {
    if (n > 2) return "its maps are those of levels 0..2; tree.on_samples goes beyond";
    return fits(s, n);
  };
  return law;
}

Law on_four_state_maps_of_level_2(Law law, std::vector<Entry> entries, Check check) {
  law.tiers.fast = law.tiers.long_run = {2, 2};
  law.long_only = law.by_id_only = true;
  law.domain = "all 4^16 4-state maps of level 2";
  law = on_maps(std::move(law), std::move(entries), check,
                {[](Level) { return four_state_maps_of_level_2; },
                 [](Level, std::uint64_t k, const Run&) { return four_state_map_of_level_2(k); },
                 [](const Map& map, std::uint64_t, const Run&) { return text_of_states(map); }, 1 << 16});
  law.unfit = [fits = law.unfit](const Subject& s, Level n) -> std::optional<std::string> {
    if (n != 2) return "it is about level 2";
    return fits(s, n);
  };
  return law;
}

Law on_samples(Law law, std::vector<Entry> entries, Check check) {
  law.method = Method::sample;
  law.how = "sample, against the specification";
  law.domain = [](Level n) {
    return fmt::format("{} maps of level {}, both formats",
                       n <= 8   ? "noise, leaves, blocks, alternating and all-but-one"
                       : n <= 9 ? "noise and leaves,"
                                : "noise,",
                       n);
  };
  return on_maps(
      std::move(law), std::move(entries), check,
      {falling({{5, 200}, {6, 100}, {7, 40}, {8, 20}, {9, 4}}, 2),
       [](Level n, std::uint64_t k, const Run& run) { return sample_map(n, run.seed, k); },
       [](const Map& map, std::uint64_t k, const Run& run) { return text_of_sample(map, run.seed, k); }, 1});
}

Finding same_map(const Map& expected, const Bytes& got) {
  if (got.size() != expected.packed.size())
    return wrong("map of", fmt::format("{} bytes", expected.packed.size()), fmt::format("{}", got.size()));
  if (got == expected.packed) return {hash_of(got)};
  const Map found{expected.level, expected.format, got};
  for (std::uint64_t k = 0; k < spec::micromap::micro_triangles(expected.level); ++k)
    if (state_at(expected, k) != state_at(found, k))
      return wrong(fmt::format("state {}", k), fmt::format("{}", state_at(expected, k)),
                   fmt::format("{}", state_at(found, k)));
  return wrong("padding bits", "0", "1");
}

}  // namespace mmverify::proofs::tree
