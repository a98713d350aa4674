// Blends of whole random payloads and values: what codes in a fixed order leave out, one that is read in another one's place.
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/hit_lists.hpp"
#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/laws.hpp"

namespace mmverify::proofs::traverse {
namespace {

constexpr std::uint64_t blend_stream = 0x626c656e64, most_hits_at_once = 70;
using HitWords = std::vector<std::uint32_t>;

/// Up to 70 payloads and values, blended at once.
struct HitBatch {
  Operation operation;
  HitWords payload, value;
};
HitBatch hit_batch(std::uint64_t seed, std::uint64_t k) {
  Random random(seed, blend_stream, k);
  HitBatch b{static_cast<Operation>(k % spec::traverse::operations),
             HitWords(1 + random.below(most_hits_at_once)),
             {}};
  for (std::uint32_t& word : b.payload) {
    word = random.four_codes();
    b.value.push_back(random.four_codes());
  }
  return b;
}

Finding blends(const TraverseSubject& s, const HitBatch& b) {
  HitWords out(b.payload.size());
  s.functions.blend(b.operation, b.payload, b.value, out);
  Finding found;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto payload = colour_of(b.payload[k]), value = colour_of(b.value[k]),
               right = spec::traverse::blend(b.operation, payload, value);
    found.answer += Tally::digest_of(k, out[k]);
    if (out[k] == word_of(right)) continue;
    return wrong(fmt::format("{} of payload {} and {}, by {}", text_of_colour(right), text_of_colour(payload),
                             text_of_colour(value), name_of(b.operation)),
                 text_of_colour(colour_of(out[k])));
  }
  return found;
}

/// A mutant that is given other payloads and values.
std::function<void(Functions&)> blending_others(void (*change)(Operation, std::uint32_t& payload,
                                                               std::uint32_t& value)) {
  return [change](Functions& f) {
    f.blend = [change, real = f.blend](Operation o, std::span<const std::uint32_t> payload,
                                       std::span<const std::uint32_t> value, std::span<std::uint32_t> out) {
      HitWords p(payload.begin(), payload.end()), v(value.begin(), value.end());
      for (std::size_t k = 0; k < p.size(); ++k) change(o, p[k], v[k]);
      real(o, p, v, out);
    };
  };
}

Law blend_on_samples() {
  Law law{.id = "traverse.blend_on_samples",
          .says =
              "each code of a payload after a hit is its own operation's on the same code of the value, "
              "whatever the others are",
          .source = "Color and Attribute Micromaps, 4.3, figure 6",
          .method = Method::sample,
          .subjects = {"traverse-spec", "traverse", "traverse-single"},
          .tiers = {.seconds = 0.1},
          .at_once = "all levels",
          .domain =
              "5 operations; 1 to 70 payloads and values, each of their eight bytes drawn "
              "on its own, half of them 0, 1, 127, 128, 254 or 255",
          .unfit = needing({entry::blend}),
          .mutants = {mutant("add takes 1 of R away where B of both is 254", "traverse-spec",
                             blending_others([](Operation o, std::uint32_t& p, std::uint32_t& v) {
                               if (o == Operation::add && (p >> 16 & 255) == 254 && (v >> 16 & 255) == 254 &&
                                   (p & 255) > 0)
                                 --p;
                             }))}};
  return on_numbered_cases(
      std::move(law),
      {[](Level, const Run& run) { return std::uint64_t{run.tier == Tier::fast ? 5'000u : 500'000u}; },
       [](const Subject& s, Level, std::uint64_t k, const Run& run) {
         return blends(subject_as<TraverseSubject>(s), hit_batch(run.seed, k));
       },
       [](const Subject&, Level, std::uint64_t k, const Run& run) {
         return fmt::format("seed={},batch={}", run.seed, k);
       },
       [](const Subject& s, Level, const std::string& at) {
         const Groups g = groups_of(at, "seed=(\\d{1,19}),batch=(\\d{1,9})");
         if (!g) throw BadCase(fmt::format("'{:.60}': write seed=1,batch=2", at));
         return blends(subject_as<TraverseSubject>(s), hit_batch(std::stoull((*g)[1]), std::stoull((*g)[2])));
       },
       64, Kind::interior});
}

}  // namespace

std::vector<Law> blend_sample_laws() { return {blend_on_samples()}; }

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
      .domain =
          "lists of 1 to 16 hits, by five operations; distances of six kinds, of each "
          "exponent and units in the last place apart; hits that are as the one before; "
          "in half of them any payload and any values, each code on its own",
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
