// The hits before the closest accepted one, where they are many or lie close together: what lists of four do not show.
#include <algorithm>

#include "proofs/engine/cases.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/hit_lists.hpp"
#include "proofs/traverse/law_groups.hpp"
#include "proofs/traverse/law_parts.hpp"

namespace mmverify::proofs::traverse {
namespace {

using spec::traverse::Colour;

/// The blends that are nearer than every accepted hit, one after the other as they were met.
Colour expected(const HitList& list) {
  Colour payload = list.payload;
  for (const Hit& hit : list.hits) {
    const bool seen = std::none_of(list.hits.begin(), list.hits.end(), [&hit](const Hit& other) {
      return other.accepted && other.distance <= hit.distance;
    });
    if (seen && !hit.accepted) payload = spec::traverse::blend(list.operation, payload, hit.value);
  }
  return payload;
}

Finding same_payload(const TraverseSubject& s, const HitList& list) {
  const Colour right = expected(list), got = s.functions.gather(list.operation, list.payload, list.hits);
  if (got == right) return {word_of(got) + std::uint64_t{1}};
  return wrong(text_of_colour(right), text_of_colour(got));
}

Law many_hits_law() {
  const auto without_repeats = [](std::vector<Hit>& hits) {
    hits.erase(std::unique(hits.begin(), hits.end(),
                           [](const Hit& a, const Hit& b) {
                             return a.accepted == b.accepted && a.distance == b.distance &&
                                    a.value == b.value;
                           }),
               hits.end());
  };
  Law law{
      .id = "traverse.blend_many_on_samples",
      .says =
          "where blending waits for the closest accepted hit, exactly the hits before it are blended, as "
          "they are met and as often as they are reported: of up to sixteen, however close their distances",
      .source = "Color and Attribute Micromaps, 4.3, figure 6; Vulkan, Ray Closest Hit Determination",
      .method = Method::sample,
      .subjects = {"traverse-spec", "traverse"},
      .tiers = {.seconds = 0.3},
      .at_once = "all levels",
      .domain = named_domain("lists of 1 to 16 hits, by five operations; distances of six kinds, of each "
                             "exponent and units in the last place apart; hits that are as the one before; "
                             "in half of them any payload and any values, each code on its own"),
      .unfit = needing({entry::gather}),
      .mutants = {
          mutant("a hit like the one before is dropped", "traverse-spec", gathering(without_repeats))}};
  return on_numbered_cases(
      std::move(law),
      {[](Level, const Run& run) { return std::uint64_t{run.tier == Tier::fast ? 20'000u : 2'000'000u}; },
       [](const Subject& s, Level, std::uint64_t k, const Run& run) {
         return same_payload(subject_as<TraverseSubject>(s), hit_list(run.seed, k));
       },
       [](const Subject&, Level, std::uint64_t k, const Run& run) { return text_of(hit_list(run.seed, k)); },
       [](const Subject& s, Level, const std::string& at) {
         return same_payload(subject_as<TraverseSubject>(s), hit_list_of(at));
       },
       256, Kind::interior});
}

}  // namespace

std::vector<Law> many_hits_laws() { return {many_hits_law()}; }

}  // namespace mmverify::proofs::traverse
