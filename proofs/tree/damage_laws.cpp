// Laws of malformed and non-canonical codes, above the levels of which every map is tried.
#include "proofs/tree/damages.hpp"
#include "proofs/tree/law_parts.hpp"
#include "proofs/tree/laws.hpp"
#include "proofs/tree/mutants.hpp"

namespace mmverify::proofs::tree {
namespace {

constexpr Format two = Format::two_state, four = Format::four_state;

/// The size in bytes up to which codes are cut and flipped everywhere.
constexpr std::size_t thorough = 24;

Finding refuses(const TreeSubject& s, const Map& map) {
  Finding found;
  const auto wrongly = [&](const Damaged& d, const char* expected, std::string got) {
    found = wrong(d.what, expected, std::move(got));
    return false;
  };
  // Bytes that are taken are the one code of another map, in any form.
  any_damage(map, s.functions.bytes(s.functions.encode(map)), thorough, [&](const Damaged& d) {
    const auto code = s.functions.open(d.level, d.format, d.bytes);
    if (!code) return true;
    ++found.answer;
    const Map other{d.level, d.format, s.functions.decode(*code)};
    if (d.level == map.level && d.format == map.format && other.packed == map.packed)
      return wrongly(d, "refused", "the same map");
    if (s.functions.bytes(s.functions.encode(other)) != d.bytes)
      return wrongly(d, "refused", "a code that nobody encodes");
    return true;
  });
  if (!found.holds || !s.functions.reads_paper) return found;
  // Strings in the paper's form have a known meaning.
  constructed_codes(map, [&](const Constructed& d) {
    const auto code = s.functions.open(d.level, d.format, d.bytes);
    if (code.has_value() != d.meant.has_value())
      return wrongly(d, d.meant ? "taken" : "refused", d.meant ? "refused" : "taken");
    if (!code) return true;
    const Finding same = same_map(*d.meant, s.functions.decode(*code));
    if (!same.holds) return wrongly(d, same.expected.c_str(), same.got);
    found.answer = found.answer * 31 + same.answer;
    return true;
  });
  return found;
}

/// Below this level each map is a case.
constexpr Level first_sampled = 2;

std::uint64_t apart_maps(Level n) { return n < first_sampled ? 0 : 8; }

std::uint64_t samples(Level n) { return n < first_sampled ? map_count(n) : n <= 5 ? 40 : n <= 8 ? 10 : 0; }

OneApart apart_number(Level n, std::uint64_t k) {
  return chosen_apart(n, (11 * k + n) % chosen_apart_count(n));
}

Map map_of_case(Level n, std::uint64_t seed, std::uint64_t k) {
  if (n < first_sampled) return map_number(n, k);
  return k < samples(n) ? sample_map(n, seed, k) : map_of(n, apart_number(n, k - samples(n)));
}

}  // namespace

Law damage_samples_law() {
  Law law{.id = "tree.malformed_on_samples",
          .says =
              "a code cut, longer, flipped or of another level is refused or is another map's; in the "
              "paper's form so are equal leaves kept apart, trees too deep and padding that is set, and "
              "exchanged children are the other map",
          .source = succinct_4_2,
          .method = Method::sample,
          .subjects = {"tree-stream", "tree-container"},
          .tiers = {.fast = {0, 8}, .long_run = {0, 10}}};
  law.tiers.seconds = 2;
  law.domain = [](Level n) {
    if (n < first_sampled)
      return fmt::format("the {} maps of level {}, some 100 strings each", samples(n), n);
    return samples(n) == 0
               ? fmt::format("{} maps of level {} of one state but for one, some 100 strings each",
                             apart_maps(n), n)
               : fmt::format(
                     "noise, leaves, blocks, alternating and all-but-one maps of level {}, both formats, and "
                     "{} of one state but for one; some 100 strings each",
                     n, apart_maps(n));
  };
  law.how = "sample, by construction";
  // Each mutant takes a code that it must refuse, for a map of one state, or refuses one that it must take.
  const auto with = [](const char* name, const char* base, Levels levels, auto choose) {
    return mutant(name, base, levels,
                  opens_wrongly([=](const Functions& real, Level n, Format f, auto bytes,
                                    std::optional<Code> code) -> std::optional<Code> {
                    const int verdict = choose(n, f, bytes, code.has_value());
                    if (verdict < 0) return std::nullopt;
                    return verdict == 0 ? code : real.encode(map_of(n, {f, 0, 1, n, 0}));
                  }));
  };
  law.mutants = {with("takes a code of the level above at level 7", "tree-container", {7, 7},
                      [](Level n, Format, auto bytes, bool) {
                        return n == 6 && bytes.size() > 16 && bytes[5] == 7 ? 1 : 0;
                      })};
  law = on_cases(
      std::move(law), {entry::bytes},
      {[](Level n) { return samples(n) + apart_maps(n); },
       [](const TreeSubject& s, Level n, std::uint64_t k, const Run& run) {
         return refuses(s, map_of_case(n, run.seed, k));
       },
       [](Level n, std::uint64_t k, const Run& run) {
         if (n < first_sampled) return text_of_states(map_number(n, k));
         return k < samples(n) ? text_of_sample(sample_map(n, run.seed, k), run.seed, k)
                               : text_of(apart_number(n, k - samples(n)));
       },
       [](const TreeSubject& s, Level n, const std::string& at) { return refuses(s, map_from_text(n, at)); },
       1});
  return law;
}

}  // namespace mmverify::proofs::tree
