// Laws between the maps of one texture: nothing has to be known of them but that they fit together, so that
// textures and levels may be larger than the specification's pace allows.
#include "proofs/bake/domains/samples.hpp"
#include "proofs/bake/domains/spans.hpp"
#include "proofs/bake/domains/strata.hpp"
#include "proofs/bake/laws.hpp"
#include "proofs/bake/laws/relation_judges.hpp"
#include "proofs/bake/mutants/states.hpp"
#include "proofs/engine/spoils.hpp"

namespace mmverify::proofs::bake {
namespace {

/// Every fourth case is one of the strata, above level 6 every second; the others are textures of up to 24x24 texels.
constexpr std::uint64_t every(Level n) { return n > 6 ? 2 : 4; }
constexpr bool is_stratum(Level n, std::uint64_t k) { return k % every(n) == every(n) - 1; }

std::uint64_t count_of(Level n, Tier tier) {
  constexpr std::array<std::uint64_t, 9> few{16, 16, 16, 44, 44, 44, 44, 4, 2};
  constexpr std::array<std::uint64_t, 12> many{26'668, 26'668, 26'668, 26'668, 26'668, 26'668,
                                               26'668, 40'000, 40'000, 100,    40,     4};
  return tier == Tier::fast ? (n < few.size() ? few[n] : 0) : n < many.size() ? many[n] : 0;
}

/// Other ones at each level.
std::uint64_t row_of(Level n, std::uint64_t k) { return 37 * std::uint64_t{n} + k; }
/// Every second one plain, above level 9 each.
std::uint64_t row_or_plain(Level n, std::uint64_t k) {
  return n > highest_rows || k % 2 != 0 ? plain_rows + row_of(n, k / 2) : row_of(n, k / 2);
}

Case any_sample(std::uint64_t seed, Level n, std::uint64_t k) {
  return is_stratum(n, k) ? stratified(seed, n, row_or_plain(n, k / every(n)))
                          : large_sample(seed, k - k / every(n));
}

std::optional<std::string> missing(bool there, std::string why) {
  return there ? std::nullopt : std::optional(std::move(why));
}

Law relation(Law law, Case (*number)(std::uint64_t seed, Level n, std::uint64_t k),
             Finding (*holds)(const BakeSubject&, const Case&, Level), const Lacks& lacks = {},
             std::uint64_t (*count)(Level, Tier) = count_of) {
  law.method = Method::sample;
  law.tiers.fast = {0, 8};
  law.tiers.long_run = {0, 11};
  law.tiers.seconds = 0.5;
  if (!law.domain)
    law.domain = fmt::format("{}; every fourth case, above level 6 every second, of {}", large_samples_text(),
                             strata_text());
  Cases cases;
  cases.count = [count](Level n, const Run& run) { return count(n, run.tier); };
  cases.number = [number](const Support& support, Level n, std::uint64_t k, std::uint64_t seed) {
    return fitted(support, number(seed, n, k), k);
  };
  cases.chunk = 4;
  return on_maps(std::move(law), cases, holds, lacks);
}

/// Along an axis that repeats, at least one, in coordinates that whole repeats can be added to.
Case periodic_sample(std::uint64_t seed, Level n, std::uint64_t k) {
  Case one = any_sample(seed, n, k);
  const std::uint64_t number = is_stratum(n, k) ? k / every(n) : k - k / every(n);
  const auto periodic = [](Wrap w) { return w == Wrap::repeat || w == Wrap::mirrored_repeat; };
  if (!is_stratum(n, k) || number % 3 != 1 || !periodic(one.wrap_v))
    one.wrap_u = number % 2 == 0 ? Wrap::repeat : Wrap::mirrored_repeat;
  if (!is_stratum(n, k) || number % 3 == 1)
    one.wrap_v = number / 2 % 2 == 0 ? Wrap::repeat : Wrap::mirrored_repeat;
  if (is_stratum(n, k))
    for (float& x : one.uv) x = std::ldexp(std::nearbyint(std::ldexp(std::fmod(x, 64.0f), 14)), -14);
  return one;
}

/// Each bakes up to 15 mips.
std::uint64_t count_with_mips(Level n, Tier tier) {
  const std::uint64_t all = count_of(n, tier);
  return std::min<std::uint64_t>(all, tier == Tier::fast ? 12 : n > 7 ? 100 : 2'000);
}

/// Each bakes ten maps.
std::uint64_t count_in_turn(Level n, Tier tier) {
  const std::uint64_t all = count_of(n, tier);
  return tier == Tier::fast ? std::min<std::uint64_t>(all, n > 6 ? 2 : 12) : all / 8;
}

/// With two mips or more; every second one a chain.
Case sample_with_mips(std::uint64_t seed, Level n, std::uint64_t k) {
  if (k % 2 != 0) return stratified(seed, n, chain_rows + row_of(n, k / 2));
  for (std::uint64_t row = row_of(n, k);; ++row) {
    const Row& kinds = design()[row % design().size()];
    if (kinds[mips_of] == 0 || kinds[width_of] + kinds[height_of] == 0) continue;
    return stratified(seed, n, row);
  }
}

/// Every second one with mips.
Case sample_in_turn(std::uint64_t seed, Level n, std::uint64_t k) {
  return k % 2 != 0 ? sample_with_mips(seed, n, k / 2) : any_sample(seed, n, k / 2);
}

/// The last of one state in a map of that level becomes another.
Spoil changes(Level level, bool (*meant)(const Case&), State from, State to) {
  return [=](const Case& one, Level n, std::vector<State>& states) {
    if (n != level || !meant(one)) return;
    const auto last = std::find(states.rbegin(), states.rend(), from);
    if (last != states.rend()) *last = to;
  };
}

Mutant changed(const char* name, Levels levels, bool (*meant)(const Case&), State from, State to) {
  return spoiled(name, "bake", levels, changes(levels.first, meant, from, to));
}

bool same_sides(const Case& a, const Case& b) {
  return a.width == b.width && a.height == b.height && a.texel == b.texel && a.mips == b.mips;
}
bool same_first_mip(const Case& a, const Case& b) {
  const auto texels = static_cast<std::ptrdiff_t>(texels_of(a.width, a.height, 1));
  return same_sides(a, b) && std::equal(a.alpha.begin(), a.alpha.begin() + texels, b.alpha.begin());
}
/// The last texture is kept, and taken for each that is as good as it.
std::function<void(Functions&)> keeping(bool (*same)(const Case&, const Case&)) {
  return [same](Functions& functions) {
    struct LastTexture {
      std::mutex lock;
      std::optional<Case> last;
    };
    functions.bake = [same, kept = std::make_shared<LastTexture>(), real = functions.bake](
                         const Case& one, Level n, Format format) {
      Case now = one;
      {
        const std::lock_guard hold(kept->lock);
        if (kept->last && same(*kept->last, one)) now.alpha = kept->last->alpha;
        kept->last = now;
      }
      return real(now, n, format);
    };
  };
}

std::vector<Mutant> in_turn_mutants() {
  std::vector<Mutant> mutants = forgetful_mutants();
  mutants.push_back(mutant("a texture is known by its largest mip", "bake", {4, 4}, keeping(same_first_mip)));
  return mutants;
}

/// The last state of a map in 2-state is the other one.
std::function<void(Functions&)> in_two_state(bool (*meant)(const Case&)) {
  return spoils(&Functions::bake, [meant](const Case& one, Level, Format format, auto& baked) {
    if (baked && format == Format::two_state && meant(one))
      baked->states.back() = baked->states.back() == State::O ? State::T : State::O;
  });
}

Law mips_law() {
  Law law = relation(
      {.id = "bake.mips",
       .says = "with several mips a micro-triangle is O, or T, exactly where it is in each mip baked alone",
       .source = "a mean of two mips' alpha lies between them; spec/bake/state.hpp",
       .subjects = {"bake"},
       .domain =
           fmt::format("those with two mips or more of {}; every second one a whole chain, of which any mip "
                       "decides alone",
                       strata_text()),
       .mutants = {asked_for_another("the last mip is left out", {5, 8}, without_last_mip)}},
      sample_with_mips, keeps_mips,
      [](const BakeSubject& s, Level) {
        return missing(s.functions.support.max_mips > 1, "it declares one mip alone");
      },
      count_with_mips);
  law.tiers.long_run = {0, highest_rows};
  return law;
}

std::optional<std::string> has_no_repeats(const BakeSubject& s, Level) {
  const Support& support = s.functions.support;
  if (support.bounded() && support.uv_max - support.uv_min < 2)
    return "it declares coordinates in less than two repeats";
  return missing(support.wraps.has(Wrap::repeat) || support.wraps.has(Wrap::mirrored_repeat),
                 "it declares no addressing that repeats");
}
std::optional<std::string> has_one_format(const BakeSubject& s, Level) {
  return missing(s.functions.support.two_state, "it declares no maps in 2-state");
}
std::optional<std::string> has_one_cutoff(const BakeSubject& s, Level) {
  const Support& support = s.functions.support;
  if (!support.mask) return "it declares no MASK";
  return missing(!support.fixed_cutoff, "it declares one cutoff alone");
}
std::optional<std::string> has_no_margins(const BakeSubject& s, Level) {
  return missing(s.functions.support.margins, "it declares no margins");
}
/// Bakers go up to level 12, so that 11 is the last one that has children.
std::optional<std::string> has_no_children(const BakeSubject& s, Level n) {
  return missing(n < s.functions.support.max_level,
                 fmt::format("levels go up to {}, and so do the children of {}",
                             s.functions.support.max_level, s.functions.support.max_level - 1));
}

Law in_turn_law() {
  return relation(
      {.id = "bake.asked_in_turn",
       .says = "a map is its question's, whichever other one was asked before that differs from it "
               "in one thing: its texels from the second row on, their order, the smaller mips, the "
               "border, an addressing, the filter, a factor, the alpha mode, the cutoff, the "
               "margin, a vertex, or sides exchanged",
       .source = "mmverify_subject.h: an answer depends on nothing but the question",
       .subjects = {"bake"},
       .mutants = in_turn_mutants()},
      sample_in_turn, keeps_no_other, {}, count_in_turn);
}

/// The last micro-triangle of a triangle of so many repeats is another state.
Spoil differs_beyond(float repeats, bool (*meant)(const Case&)) {
  return [=](const Case& one, Level, std::vector<State>& states) {
    if (std::fabs(one.uv[2] - one.uv[0]) < repeats || !meant(one)) return;
    states.back() = states.back() == State::T ? State::O : State::T;
  };
}

Law lengths_law() {
  Law law = relation(
      {.id = "bake.length",
       .says = "all micro-triangles that hold a whole period of the texture have one state but for "
               "the side of unknown ones, however many periods longer they are",
       .source = "Vulkan, Wrapping Operation; all texels are under each",
       .subjects = {"bake"},
       .domain = whole_period_samples_text(),
       .mutants = {spoiled("the last one beyond 2^9 repeats", "bake", {0, 3},
                           differs_beyond(512, [](const Case&) { return true; })),
                   spoiled("the last one beyond 2^15 repeats, mirrored", "bake", {0, 3},
                           differs_beyond(
                               32'768, [](const Case& one) { return one.wrap_u == Wrap::mirrored_repeat; })),
                   spoiled(
                       "the last one beyond 2^9 repeats, sampled nearest", "bake", {0, 3},
                       differs_beyond(512, [](const Case& one) { return one.filter == Filter::nearest; }))}},
      whole_period_sample, keeps_lengths, has_no_repeats,
      [](Level, Tier tier) -> std::uint64_t { return tier == Tier::fast ? 24 : 2'000; });
  law.tiers.fast = {0, 3};
  law.tiers.long_run = {0, 5};
  return law;
}

}  // namespace

std::vector<Law> relation_laws() {
  const auto above = [](const Case& one) { return one.uv[1] < -30 && one.wrap_v == Wrap::mirrored_repeat; };
  const auto v_first = [](const Case& one) { return one.uv[4] < one.uv[0] && one.uv[4] < one.uv[2]; };
  const auto odd = [](const Case& one) { return one.width % 2 == 1; };
  const auto any = [](const Case&) { return true; };
  const auto narrow = [](const Case& one) { return one.margin == 0 && one.height % 2 == 0; };
  const auto never = [](const Case& one) { return one.cutoff.numerator == 256; };
  return {
      relation({.id = "bake.shift",
                .says = "whole repeats of the texture change nothing: any number along a repeated axis, an "
                        "even one along a mirrored one",
                .source = "Vulkan, Wrapping Operation",
                .subjects = {"bake"},
                .mutants = {changed("a transparent one 30 above", {5, 5}, above, State::T, State::UT)}},
               periodic_sample, keeps_shifts, has_no_repeats),
      lengths_law(),
      relation({.id = "bake.order",
                .says = "the vertices in another order give the same states, each to the micro-triangle that "
                        "is where it was",
                .source = "VK_KHR_opacity_micromap, barycentrics to micro-triangles; spec/index/index.hpp",
                .subjects = {"bake"},
                .mutants = {changed("an opaque one where the third vertex is the leftmost", {5, 5}, v_first,
                                    State::O, State::UO)}},
               any_sample, keeps_orders),
      relation(
          {.id = "bake.force2",
           .says = "a map in 2-state is force-2-state of the one in 4-state",
           .source = "VK_KHR_opacity_micromap, force-2-state; spec/micromap/micromap.hpp",
           .subjects = {"bake"},
           .mutants = {mutant("the last of odd textures in 2-state", "bake", {5, 5}, in_two_state(odd))}},
          any_sample, keeps_formats, has_one_format),
      relation({.id = "bake.nested",
                .says = "a micro-triangle is O, or T, exactly where its four children are",
                .source = "a closed micro-triangle is the union of its children; spec/bake/state.hpp",
                .subjects = {"bake"},
                .mutants = {changed("an opaque one", {5, 5}, any, State::O, State::UO)}},
               any_sample, keeps_levels, has_no_children),
      relation(
          {.id = "bake.cutoff",
           .says = "a higher cutoff makes nothing O, and nothing that is T anything else",
           .source = "glTF 2.0, Alpha Coverage",
           .subjects = {"bake"},
           .mutants = {changed("one of those with a cutoff above 1", {4, 4}, never, State::T, State::O)}},
          any_sample, keeps_cutoffs, has_one_cutoff),
      relation({.id = "bake.margin",
                .says = "a wider margin settles nothing: what is O or T with it is so without",
                .source = "a dilated micro-triangle holds it; spec/bake/state.hpp",
                .subjects = {"bake"},
                .mutants = {changed("a transparent one without a margin, an even number of rows", {3, 3},
                                    narrow, State::T, State::UT)}},
               any_sample, keeps_margins, has_no_margins),
      in_turn_law(),
      mips_law(),
  };
}

}  // namespace mmverify::proofs::bake
