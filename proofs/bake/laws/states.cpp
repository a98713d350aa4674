// Laws of states: O and T are true of all of their micro-triangle, unknown states are necessary, and lie on the right
// side.
#include "proofs/bake/mutants/states.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <numeric>

#include "proofs/bake/diagnosis/diagnosis.hpp"
#include "proofs/bake/domains/family.hpp"
#include "proofs/bake/domains/plateaus.hpp"
#include "proofs/bake/domains/samples.hpp"
#include "proofs/bake/domains/spans.hpp"
#include "proofs/bake/domains/strata.hpp"
#include "proofs/bake/law_parts.hpp"
#include "proofs/bake/laws.hpp"
#include "proofs/bake/mutants/plateaus.hpp"
#include "proofs/bake/truth/denial.hpp"
#include "proofs/engine/passed.hpp"

namespace mmverify::proofs::bake {
namespace {

using spec::micromap::unknown;

constexpr char source[] =
    "VK_KHR_opacity_micromap, opacity states; glTF 2.0, Alpha Coverage; spec/bake/state.hpp";

bool differs(State got, State lower, State upper) {
  return not_conservative(got, lower, upper) || not_tight(got, lower, upper) || wrong_side(got, lower, upper);
}
bool leans_transparent(State got, State, State) { return got == State::UT; }
bool leans_opaque(State got, State, State) { return got == State::UO; }

/// The law's check, or, for a subject that declares the side of its unknown states, a check of that side.
Denies denied_of(const BakeSubject& s, Denies denies) {
  if (denies != wrong_side || s.functions.centroid) return denies;
  return s.functions.support.unknown == UnknownSide::opaque ? leans_transparent : leans_opaque;
}

/// Whether all wrong states are ties.
bool ties_alone(const Case& one, Level n, const std::vector<State>& got, const std::vector<std::uint32_t>& at,
                const Truth& truth) {
  for (std::size_t k = 0; k < at.size(); ++k)
    if (not_conservative(got[at[k]], truth.lower[k], truth.upper[k]) && !is_tie(one, n, at[k], got[at[k]]))
      return false;
  return true;
}

/// The domain of a law: a family, complete, or samples.
struct Domain {
  const Families& (*families)() = nullptr;
  Case (*drawn)(std::uint64_t seed, Level n, std::uint64_t k) = nullptr;
  const char* (*says)() = nullptr;                       ///< the text of samples
  std::uint64_t (*count)(Level n, Tier tier) = nullptr;  ///< the number of samples
  Levels fast = {0, 3}, long_run = {0, 3};
  bool moving = false;  ///< its triangles move
  bool sides = false;   ///< of a family: some law is about the side of its unknown states

  bool whole() const { return families != nullptr; }
  const Families& families_of(const Support& support) const { return fitted(families(), support); }
  /// The micro-triangles at which a case is judged; of a family all.
  std::vector<std::uint32_t> at(const Case& one, Level n) const {
    if (!whole()) return judged_at(one, n);
    std::vector<std::uint32_t> all(std::size_t{1} << 2 * n);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  /// The true states at these micro-triangles.
  Truth truth(const Support& support, const Case& one, Level n,
              const std::optional<std::uint64_t>& number) const {
    if (!whole()) return true_states(one, n);
    if (!number) return true_states(one, n, at(one, n));
    const Families& all = families_of(support);
    Truth truth{all.truth(n, *number, Threshold::lower), {}};
    truth.upper = one.rules.slack != 0 ? all.truth(n, *number, Threshold::upper) : truth.lower;
    return truth;
  }
};

/// The number of a level's sample.  Each level has samples of its own; their kinds follow those of the first level.
std::uint64_t sample_of(Level n, std::uint64_t k) { return 104 * 200 * std::uint64_t{n} + k; }
std::uint64_t as_many(Level, Tier tier) { return tier == Tier::fast ? 104 : 20'000; }
std::uint64_t strata_count(Level n, Tier tier) {
  if (tier == Tier::fast) return with_plain(fast_strata(n));
  constexpr std::array<std::uint64_t, 13> counts{4840, 4840, 4840, 4840, 4840, 4840, 2420,
                                                 1936, 968,  484,  96,   8,    4};
  return n < counts.size() ? with_plain(counts[n]) : 0;
}

constexpr Domain bilinear{.families = bilinear_families, .sides = true}, nearest{nearest_families},
    blend{blend_families}, grid{grid_families};
constexpr Domain plain_samples{
    nullptr,      [](std::uint64_t seed, Level n, std::uint64_t k) { return sample(seed, sample_of(n, k)); },
    samples_text, as_many,
    {2, 5},       {0, 8}};
constexpr Domain all_samples{
    nullptr,
    [](std::uint64_t seed, Level n, std::uint64_t k) { return featured_sample(seed, sample_of(n, k)); },
    featured_samples_text,
    as_many,
    {2, 5},
    {0, 8}};
constexpr Domain moving{
    nullptr,
    [](std::uint64_t seed, Level n, std::uint64_t k) { return moving_sample(seed, sample_of(n, k)); },
    moving_samples_text,
    [](Level, Tier tier) -> std::uint64_t { return tier == Tier::fast ? 52 : 10'000; },
    {0, 4},
    {0, 7},
    true};
constexpr Domain of_sides{
    nullptr,
    [](std::uint64_t seed, Level n, std::uint64_t k) { return side_sample(seed, n, k); },
    side_samples_text,
    [](Level, Tier tier) { return side_count() * distances * (tier == Tier::fast ? 1 : 64); },
    {0, 1},
    {0, 3}};
constexpr Domain spans{nullptr,
                       span_sample,
                       span_samples_text,
                       [](Level, Tier tier) -> std::uint64_t { return tier == Tier::fast ? 40 : 4'000; },
                       {0, 3},
                       {0, 5}};
constexpr Domain plateaus{nullptr,
                          plateau_sample,
                          plateau_samples_text,
                          [](Level, Tier tier) -> std::uint64_t { return tier == Tier::fast ? 312 : 20'000; },
                          {0, 3},
                          {0, 6}};
constexpr Domain strata{
    nullptr,
    [](std::uint64_t seed, Level n, std::uint64_t k) { return stratified(seed, n, stratum(n, k)); },
    judged_strata_text,
    strata_count,
    {0, 9},
    {0, 12}};

/// The laws on a family.
std::vector<Denies> laws_on(const Domain& domain) {
  if (domain.sides) return {not_conservative, not_tight, wrong_side};
  return {not_conservative, not_tight};
}

/// The cases of a family that the states of impl/bake have passed at a level; null for other domains, subjects and laws,
/// and for a family with too many cases.
Passed* passed_by(const BakeSubject& s, const Domain& domain, Denies denies, Level n) {
  constexpr Level levels = 4;
  constexpr std::uint64_t most = 100'000;  // cases of a level, 9 bytes each
  static const BakeSubjectPtr library = built_in("bake");
  if (!domain.whole() || &s != library.get() || n >= levels) return nullptr;
  const std::vector<Denies> laws = laws_on(domain);
  if (std::find(laws.begin(), laws.end(), denies) == laws.end()) return nullptr;
  static std::mutex lock;
  static std::map<const Families*, std::array<std::unique_ptr<Passed>, levels>> kept;
  const Families& families = domain.families_of(s.functions.support);
  const std::lock_guard hold(lock);
  std::unique_ptr<Passed>& one = kept[&families][n];
  if (!one && families.count() <= most) one = std::make_unique<Passed>(families.count());
  return one.get();
}

/// Whether the states offend no law on the family.
bool offends_no_law(const BakeSubject& s, const Domain& domain, const std::vector<State>& states,
                    const Truth& truth) {
  for (const Denies by_law : laws_on(domain)) {
    const Denies denies = denied_of(s, by_law);
    for (std::size_t k = 0; k < truth.lower.size(); ++k)
      if (denies(states.at(k), truth.lower[k], truth.upper[k])) return false;
  }
  return true;
}

Check judged_by(Denies by_law, const Domain& domain) {
  return [=](const BakeSubject& s, const Case& one, Level n, const std::optional<std::uint64_t>& number) {
    const Denies denies = denied_of(s, by_law);
    // The library is asked once for all laws on a family: the first law to come to a case judges it by all.
    Passed* const kept = number ? passed_by(s, domain, by_law, n) : nullptr;
    if (kept != nullptr)
      if (const auto answer = kept->answer(*number)) return Finding{*answer};
    const bool first = kept != nullptr && kept->take(*number);
    const std::optional<Baked> baked = s.functions.bake(one, n, Format::four_state);
    if (!baked) return unsupported();
    if (!baked->padded) return wrong("zeros after the last state", "others");
    const Truth truth = domain.truth(s.functions.support, one, n, number);
    const auto offends = [&] {
      if (domain.whole()) {
        for (std::size_t k = 0; k < truth.lower.size(); ++k)
          if (denies(baked->states.at(k), truth.lower[k], truth.upper[k])) return true;
        return false;
      }
      const std::vector<std::uint32_t> at = domain.at(one, n);
      for (std::size_t k = 0; k < at.size(); ++k)
        if (denies(baked->states.at(at[k]), truth.lower[k], truth.upper[k])) return true;
      return false;
    };
    if (!offends()) {
      const std::uint64_t answer = hash_of(baked->states);
      if (first && offends_no_law(s, domain, baked->states, truth)) kept->pass(*number, answer);
      return Finding{answer};
    }
    Finding finding = wrong([=, states = baked->states] {
      return words_of(one, n, offender_of(one, n, states, domain.at(one, n), truth, denies).value());
    });
    finding.lesser =
        denies == not_conservative && ties_alone(one, n, baked->states, domain.at(one, n), truth);
    return finding;
  };
}

Draw drawn_by(Denies denies, const Domain& domain) {
  return [=](const BakeSubject& s, const Case& one, Level n) {
    const std::optional<Baked> baked = s.functions.bake(one, n, Format::four_state);
    return picture(
        one, n,
        offender_of(one, n, baked.value().states, domain.at(one, n),
                    domain.truth(s.functions.support, one, n, std::nullopt), denied_of(s, denies)));
  };
}

/// Whether a subject defines the side of its unknown states.
bool says_the_side(const BakeSubject& s) {
  return s.functions.centroid || s.functions.support.unknown == UnknownSide::opaque ||
         s.functions.support.unknown == UnknownSide::transparent;
}

/// The reason why a law does not fit what a subject declares.
Lacks lacking(Denies denies, const Domain& domain) {
  const Family* first = domain.whole() ? &domain.families().all().front().family() : nullptr;
  const bool both = domain.whole() && domain.families().all().back().family().filter != first->filter;
  return [=, moving = domain.moving](const BakeSubject& s, Level) -> std::optional<std::string> {
    const Support& support = s.functions.support;
    if (moving && !support.moving) return s.name() + " has no entry point for coordinates that move";
    if (denies == differs && !s.functions.centroid)
      return s.name() + " does not promise the centroid's side for what is unknown";
    if (denies == wrong_side && !says_the_side(s))
      return s.name() + " does not promise the centroid's side for what is unknown";
    if (support.filters == Set(1u << static_cast<unsigned>(Filter::nearest)) && support.coordinate_bits != 0)
      return "it declares nearest filtering of rounded coordinates alone: which texel it samples is not said";
    if (first == nullptr) return std::nullopt;
    if (first->blend ? !support.blend : !support.mask)
      return first->blend ? "it declares no BLEND" : "it declares no MASK";
    if (first->blend && !support.judges_blend())
      return "it declares sampling in fixed point, which says nothing of BLEND's thresholds";
    const auto filtered = [&](Filter filter) {
      return support.filters.has(filter) && (filter == Filter::bilinear || support.coordinate_bits == 0);
    };
    if (both || filtered(first->filter)) return std::nullopt;
    return first->filter == Filter::nearest ? "it declares no nearest filtering of exact coordinates"
                                            : "it declares no bilinear filtering";
  };
}

Fault fault_of(Denies denies) {
  return denies == not_tight ? Fault::tight : denies == wrong_side ? Fault::side : Fault::conservative;
}

Law state_law(const char* id, const char* says, Denies denies, const Domain& domain,
              std::vector<Mutant> mutants) {
  Cases cases;
  const bool whole = domain.whole();
  if (whole) {
    cases.count = [domain](Level, const Run&) { return domain.families().count(); };
    cases.number = [domain](const Support& support, Level, std::uint64_t k, std::uint64_t) {
      return domain.families_of(support).at(k);
    };
    cases.chunk = 64;
  } else {
    cases.count = [domain](Level n, const Run& run) { return domain.count(n, run.tier); };
    cases.number = [domain](const Support& support, Level n, std::uint64_t k, std::uint64_t seed) {
      return fitted(support, domain.drawn(seed, n, k), k);
    };
    cases.chunk = 4;
  }
  return on_cases(
      {.id = id,
       .says = says,
       .source = source,
       .method = whole ? Method::exhaustive : Method::sample,
       .subjects = {"bake"},
       .tiers = {.fast = domain.fast, .long_run = domain.long_run, .seconds = 0.5},
       .domain =
           [domain, whole](const Subject& s, Level) {
             if (!whole) return std::string(domain.says());
             const auto* subject = dynamic_cast<const BakeSubject*>(&s);
             return (subject == nullptr ? domain.families() : domain.families_of(subject->functions.support))
                 .domain();
           },
       .mutants = std::move(mutants),
       .diagnose =
           [fault = fault_of(denies)](const Subject& s, const std::vector<Result>&) {
             return diagnose(dynamic_cast<const BakeSubject&>(s), fault);
           }},
      cases, judged_by(denies, domain), drawn_by(denies, domain), lacking(denies, domain));
}

Law grid_law() {
  Law law =
      state_law("bake.equals_spec", "every state is the specification's", differs, grid,
                {spoiled("one micro-triangle of one texture on one line", "bake", {3, 3},
                         claims_one({0, 128, 255, 0}, Wrap::repeat, Wrap::clamp_to_edge, -0.8125f)),
                 asked_for_another("mirror-once is clamped to the edge", {0, 1}, mirror_once_as_clamp),
                 unknown_where_another_differs("alpha at the cutoff is unknown", {0, 0}, above_the_cutoff)});
  law.long_only = true;
  return law;
}

// The claims of the laws.
constexpr char conservative[] =
    "alpha is opaque on all of a closed micro-triangle that is O, transparent on all of one that is T";
constexpr char tight[] =
    "a micro-triangle is unknown only where alpha is opaque at one point of it and "
    "transparent at another";
constexpr char tight_blend[] =
    "a micro-triangle is unknown only where alpha is below 1 at a point of it and above 0 "
    "at a point of it";
constexpr char side[] = "an unknown micro-triangle is UO where alpha at its centroid is opaque, else UT";

std::vector<Law> span_laws() {
  const Levels all{0, 3};
  return {
      state_law("bake.conservative_on_spans", conservative, not_conservative, spans,
                {spoiled("texels are counted in 32 bits: none are opaque", "bake", all, counts_in_32_bits),
                 asked_for_another("repeats are clamped from the 512th on", all, clamps_far),
                 asked_for_another("coordinates are in steps of a quarter", all, in_steps_of(2))}),
      state_law("bake.tight_on_spans", tight, not_tight, spans,
                {spoiled("unknown across more than 2^30 texels", "bake", all, forgets_long),
                 unknown_where_another_differs("unknown, too, where clamping differs", all, clamps_far),
                 unknown_where_another_differs("unknown, too, where quarters differ", all, in_steps_of(2))}),
      state_law("bake.unknown_side_on_spans", side, wrong_side, spans,
                {side_of_another("the side is that of coordinates in steps of 2^-3", all, in_steps_of(3)),
                 side_of_another("the side is that of coordinates in steps of 2^-6", all, in_steps_of(6)),
                 side_of_another("the side is that of clamped repeats", all, clamps_far)}),
  };
}

std::vector<Law> plateau_laws() {
  const Levels all{0, 3};
  return {
      state_law("bake.conservative_on_plateaus", conservative, not_conservative, plateaus,
                {spoiled("an unknown whose middle rows are at the cutoff is opaque", "bake", all,
                         looks_at_middle_rows),
                 asked_for_another("alpha at the cutoff is below it", all, above_the_cutoff),
                 asked_for_another("coordinates are in steps of 2^-6", all, in_steps_of(6))}),
      state_law(
          "bake.tight_on_plateaus", tight, not_tight, plateaus,
          {unknown_where_another_differs("alpha at the cutoff is unknown", all, above_the_cutoff),
           unknown_where_another_differs("unknown, too, where the vertices' factor decides", all,
                                         without_vertex_factor),
           unknown_where_another_differs("unknown, too, where steps of 2^-6 differ", all, in_steps_of(6))}),
  };
}

Law moving_law() {
  return state_law("bake.moving", "each state is the specification's of all positions of a moving triangle",
                   differs, moving,
                   {asked_for_another("the ranges of u and v are exchanged", {0, 4},
                                      [](Case& one) { std::swap(one.travel[0], one.travel[1]); }),
                    asked_for_another("the margin is left out beside a range", {0, 4},
                                      [](Case& one) {
                                        if (one.travel[0] != 0) one.margin = 0;
                                      }),
                    asked_for_another("the smaller of two ranges is 0", {0, 4}, [](Case& one) {
                      float& smaller = one.travel[one.travel[0] < one.travel[1] ? 0 : 1];
                      smaller = 0;
                    })});
}

std::vector<Law> other_laws() {
  const auto far = claims_one({0, 128, 128, 0}, Wrap::mirrored_repeat, Wrap::mirror_once, -3);
  return {
      state_law("bake.conservative", conservative, not_conservative, bilinear,
                {spoiled("one micro-triangle far below 0 of one texture, mirrored beside mirror-once", "bake",
                         {2, 3}, far)}),
      state_law("bake.tight", tight, not_tight, bilinear,
                {spoiled("one micro-triangle of one texture that is O", "bake", {3, 3},
                         forgets_one({255, 255, 128, 0}, State::O))}),
      state_law("bake.unknown_side", side, wrong_side, bilinear,
                {spoiled("one micro-triangle of one texture leans the other way", "bake", {3, 3},
                         leans_once({0, 255, 255, 128}))}),
      state_law("bake.conservative_nearest", conservative, not_conservative, nearest,
                {spoiled("one micro-triangle far below 0 of one texture, mirrored beside mirror-once", "bake",
                         {2, 3}, far)}),
      state_law("bake.tight_nearest", tight, not_tight, nearest,
                {spoiled("one micro-triangle of one texture that is T", "bake", {2, 2},
                         forgets_one({0, 0, 255, 0}, State::T))}),
      state_law("bake.conservative_blend", conservative, not_conservative, blend,
                {spoiled("one micro-triangle of one texture, clamped", "bake", {3, 3},
                         claims_one({0, 128, 255, 255}, Wrap::clamp_to_edge, Wrap::clamp_to_edge, 0.125f))}),
      state_law("bake.tight_blend", tight_blend, not_tight, blend,
                {spoiled("one micro-triangle of one texture that is O", "bake", {3, 3},
                         forgets_last({255, 255, 255, 0}, State::O))}),
      state_law("bake.conservative_on_samples", conservative, not_conservative, plain_samples,
                {spoiled("an unknown of textures of 7 rows is settled", "bake", {5, 5}, claims_of_rows(7))}),
      state_law("bake.tight_on_samples", tight, not_tight, plain_samples,
                {spoiled("the first settled of textures of 7 rows is unknown", "bake", {5, 5},
                         forgets_of_rows(7))}),
      state_law(
          "bake.unknown_side_on_samples", side, wrong_side, plain_samples,
          {side_of_another("mirror-once leans as if clamped to the edge", {4, 4}, mirror_once_as_clamp)}),
      state_law("bake.conservative_on_features", conservative, not_conservative, all_samples,
                {asked_for_another("the factor of the vertices is left out", {4, 5}, without_vertex_factor)}),
      state_law("bake.tight_on_features", tight, not_tight, all_samples,
                {unknown_where_another_differs("unknown, too, where the vertices' factor decides", {4, 5},
                                               without_vertex_factor)}),
      state_law("bake.unknown_side_on_features", side, wrong_side, all_samples,
                {side_of_another("the side is that without the factor of the vertices", {4, 5},
                                 without_vertex_factor)}),
      state_law("bake.conservative_on_sides", conservative, not_conservative, of_sides,
                {asked_for_another("mirrored repeats of more than 64 texels are one shorter", {0, 1},
                                   mirrors_by_centres)}),
      state_law("bake.conservative_on_strata", conservative, not_conservative, strata,
                {asked_for_another("of a border of 16 bits the low byte is read", {0, 9}, byte_border)}),
      state_law("bake.tight_on_strata", tight, not_tight, strata,
                {spoiled("all of level 8 is unknown in textures of more than 256 columns", "bake", {8, 8},
                         forgets_wide)}),
      state_law(
          "bake.unknown_side_on_strata", side, wrong_side, strata,
          {side_of_another("the side is that of coordinates in steps of 2^-12", {5, 9}, in_steps_of(12))}),
      moving_law(),
      grid_law(),
  };
}

}  // namespace

std::vector<Law> state_laws() {
  std::vector<Law> all = other_laws();
  for (const std::vector<Law>& more : {span_laws(), plateau_laws()})
    all.insert(all.end() - 1, more.begin(), more.end());  // the last one is of the long tier
  return all;
}

}  // namespace mmverify::proofs::bake
