#include "proofs/micromap/laws.hpp"

#include "proofs/micromap/law_parts.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::micromap {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group :
       {map_laws(), apart_laws(), count_laws(), lossy_laws(), special_laws(), array_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

namespace {

PackedMap packed(const Map& map) { return {map.level, map.format, map.packed}; }

// A 4-state map of a sample; 2-state ones are widened, state by state.
Map sampled(Level n, std::uint64_t seed, std::uint64_t k, Maps maps) {
  Map map = sample_map(n, seed, k);
  if (maps == Maps::both_formats || map.format == Format::four_state) return map;
  const States states = spec::micromap::unpack(map.packed, map.format, spec::micromap::micro_triangles(n));
  return {n, Format::four_state, spec::micromap::pack(states, Format::four_state)};
}

std::uint64_t two_state_maps(Level n) { return std::uint64_t{1} << spec::micromap::micro_triangles(n); }

std::string first_bytes(const Bytes& bytes) {
  constexpr std::size_t shown = 24;
  const auto first = std::span(bytes).first(std::min(bytes.size(), shown));
  return hex(first, " ") + (bytes.size() > shown ? " ..." : "");
}

/// The entry points that map maps to maps, with their words in the domain of a law.
constexpr std::pair<Entry, const char*> map_parts[] = {{entry::pack, "packing"},
                                                       {entry::force2, "force-2-state"},
                                                       {entry::up, "up"},
                                                       {entry::down, "down"},
                                                       {entry::modes, "modes"}};

}  // namespace

std::vector<Bytes> with_paddings(const PackedMap& map) {
  const unsigned used =
      static_cast<unsigned>(spec::micromap::micro_triangles(map.level) * bits(map.format) % 8);
  std::vector<Bytes> all;
  for (unsigned padding = 0; padding < (used == 0 ? 1u : 256u >> used); ++padding) {
    all.push_back(map.bytes);
    all.back().back() = static_cast<std::uint8_t>(map.bytes.back() | padding << used);
  }
  return all;
}

Finding same(const char* what, const Bytes& expected, const Bytes& got) {
  if (expected == got) return {hash_of(got), true, {}, {}};
  if (expected.size() == got.size() && expected.size() > 24) {
    std::size_t k = 0;
    while (expected[k] == got[k]) ++k;
    return wrong(fmt::format("{} byte {} {:02x}", what, k, expected[k]), fmt::format("{:02x}", got[k]));
  }
  return wrong(fmt::format("{} {}", what, first_bytes(expected)), first_bytes(got));
}

Law on_cases(Law law, std::vector<Entry> entries, Cases cases) {
  if (!law.how && law.method == Method::sample) law.how = "sample, against the specification";
  law.unfit = unless_of_topic<MicromapSubject>(lacking<MicromapSubject>(
      std::move(entries),
      [levels = law.tiers.long_run, exhaustive = law.method == Method::exhaustive](
          const MicromapSubject&, Level n) -> std::optional<std::string> {
        if (n < levels.first) return fmt::format("it is about level {} and above", levels.first);
        if (exhaustive && n > levels.last)
          return fmt::format("all cases are run up to level {} only; samples go beyond", levels.last);
        if (n > 12) return "samples have levels up to 12";
        return std::nullopt;
      }));
  return on_cases_of(std::move(law), std::move(cases));
}

Law on_all_maps(Law law, std::vector<Entry> entries, Maps maps, Level first, MapCheck check) {
  const bool both = maps == Maps::both_formats;
  law.tiers.fast = law.tiers.long_run = {first, both ? 2u : 1u};
  law.domain = [both](Level n) {
    if (!both) return fmt::format("all 4-state maps of level {}", n);
    return fmt::format("all {} maps of level {}", n < 2 ? "2-state and 4-state" : "65,536 2-state", n);
  };
  // map_number() counts the 2-state maps first.
  const auto number = [both](Level n, std::uint64_t k) {
    return map_number(n, both ? k : k + two_state_maps(n));
  };
  return on_cases(std::move(law), std::move(entries),
                  {[both](Level n) -> std::uint64_t {
                     if (n > (both ? 2u : 1u)) return 0;
                     return both ? map_count(n) : two_state_maps(n) * two_state_maps(n);
                   },
                   [=](const MicromapSubject& s, Level n, std::uint64_t k, const Run&) {
                     return check(s, packed(number(n, k)));
                   },
                   [=](Level n, std::uint64_t k, const Run&) { return text_of_states(number(n, k)); },
                   [=](const MicromapSubject& s, Level n, const std::string& at) {
                     const Map map = map_from_text(n, at);
                     if (!both && map.format != Format::four_state)
                       throw BadCase("the law is about 4-state maps");
                     return check(s, packed(map));
                   }});
}

std::string asked_of(const MicromapSubject& s) {
  std::vector<std::string> there;
  for (const auto& [entry, name] : map_parts)
    if (entry.there(s.functions)) there.push_back(name);
  return there.size() == std::size(map_parts) ? "" : fmt::format(", of it {}", fmt::join(there, ", "));
}

Law on_any_part(Law law) {
  law.unfit = [fits = law.unfit](const Subject& subject, Level n) -> std::optional<std::string> {
    if (auto why = fits(subject, n)) return why;
    const MicromapSubject& s = subject_as<MicromapSubject>(subject);
    for (const auto& [entry, name] : map_parts)
      if (entry.there(s.functions)) return std::nullopt;
    return s.name() +
           " has no entry point micromap_pack, micromap_force2, micromap_up, micromap_down or "
           "micromap_through";
  };
  return law;
}

Law on_samples(Law law, std::vector<Entry> entries, Maps maps, MapCheck check) {
  law.method = Method::sample;
  const bool parts = entries.empty();
  law.domain = [maps, parts](const Subject& s, Level n) {
    return fmt::format("noise, leaves, blocks, alternating and all-but-one maps of level {}, {}{}", n,
                       maps == Maps::both_formats ? "both formats" : "4-state",
                       parts ? asked_of(subject_as<MicromapSubject>(s)) : "");
  };
  law = on_cases(std::move(law), std::move(entries),
                 {[](Level n) -> std::uint64_t {
                    return n <= 5 ? 200 : n == 6 ? 100 : n == 7 ? 40 : n == 8 ? 20 : 10;
                  },
                  [=](const MicromapSubject& s, Level n, std::uint64_t k, const Run& run) {
                    return check(s, packed(sampled(n, run.seed, k, maps)));
                  },
                  [=](Level n, std::uint64_t k, const Run& run) {
                    return text_of_sample(sampled(n, run.seed, k, maps), run.seed, k);
                  },
                  [=](const MicromapSubject& s, Level n, const std::string& at) {
                    Map map = map_from_text(n, at);
                    if (maps == Maps::four_state && map.format != Format::four_state) {
                      const States states =
                          spec::micromap::unpack(map.packed, map.format, spec::micromap::micro_triangles(n));
                      map = {n, Format::four_state, spec::micromap::pack(states, Format::four_state)};
                    }
                    return check(s, packed(map));
                  },
                  1});
  return parts ? on_any_part(std::move(law)) : law;
}

}  // namespace mmverify::proofs::micromap
