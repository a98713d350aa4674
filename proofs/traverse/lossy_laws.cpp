// Laws of lossy maps, which replace states by unknown ones.  The shader answers as the full map would, so a ray may
// only end another way if no shader runs.
#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/laws.hpp"
#include "proofs/traverse/premises.hpp"

namespace mmverify::proofs::traverse {
namespace {

constexpr char lossy_source[] =
    "VK_KHR_opacity_micromap proposal, lossy micromaps; the KHR slides, \"Lossy Micromaps\"";

/// A combination of the full map, and the unknown state that the lossy map has instead.
struct Substitution {
  Combination full;
  State read;
};

bool own_side(const Substitution& s) { return spec::micromap::as_unknown(s.full.candidate.state) == s.read; }

/// KHR traces that read a state of a 4-state map or of a special index, each with every other state that is unknown.
std::vector<Substitution> all_substitutions() {
  std::vector<Substitution> all;
  for (const Combination& c : defined()) {
    const bool khr = c.api == Api::khr_pipeline || c.api == Api::khr_query,
               lossy = c.candidate.held == Held::special || c.candidate.held == Held::four_state;
    if (!khr || !lossy || !spec::traverse::consulted(c)) continue;
    for (const State read : {State::UT, State::UO})
      if (read != c.candidate.state) all.push_back({c, read});
  }
  return all;
}

bool any(const Substitution&) { return true; }

/// Whether the ray drops hits that are opaque by the lookup.
bool drops_opaque(const Combination& c) {
  return made_non_opaque(c) ? c.ray.cull_no_opaque : c.ray.cull_opaque;
}

/// Whether only a shader can tell the states apart.  Without force-2-state: T if no flag makes hits opaque, or if
/// CullOpaque drops them; O if a flag settles the opacity, or if nothing is culled by it.  With force-2-state: states
/// that stay on their side; others if the ray drops both sides; and T if flags let a shader drop it.
bool leaves_it_to_the_shader(const Substitution& s) {
  const Combination& c = s.full;
  if (spec::traverse::two_state_override(c))
    return own_side(s) || drops_opaque(c) || (c.candidate.state == State::T && made_non_opaque(c));
  if (c.candidate.state == State::T) return !made_opaque(c) || c.ray.cull_opaque;
  return c.candidate.state != State::O || (made_opaque(c) || made_non_opaque(c)) || !culls(c);
}

bool shows(const Substitution& s) { return !leaves_it_to_the_shader(s); }

/// Whether traversal itself accepts or drops a candidate that the full map leaves to a shader, or the other way
/// round. Without force-2-state: a T that flags make opaque, an O that CullNoOpaque drops because it is unknown.
/// With it: a state read as the other one, unless both are dropped, or a shader runs for a T or UT.
bool decides_more(const Substitution& s) {
  const Combination& c = s.full;
  if (spec::traverse::two_state_override(c))
    return !own_side(s) && !drops_opaque(c) &&
           !(on_transparent_side(c.candidate.state) && made_non_opaque(c));
  if (c.candidate.state == State::T) return made_opaque(c) && !c.ray.cull_opaque;
  return c.candidate.state == State::O && c.ray.cull_no_opaque && !made_opaque(c) && !made_non_opaque(c);
}

/// Whether the candidate is a hit, given the shader's answer.
bool hits(Outcome o, bool shader_says) {
  return o == Outcome::opaque || (o == Outcome::non_opaque && shader_says);
}

/// The law on the substitutions that `about` accepts.
Law on_substitutions(Law law, bool (*about)(const Substitution&),
                     std::function<Finding(const Substitution&, Outcome full, Outcome lossy)> check) {
  // Evaluated late, when defined() can be called.
  const auto some = [about]() -> const std::vector<Substitution>& {
    static std::map<bool (*)(const Substitution&), std::vector<Substitution>> known;
    static std::mutex lock;
    const std::lock_guard hold(lock);
    auto& found = known[about];
    if (found.empty())
      for (const Substitution& s : all_substitutions())
        if (about(s)) found.push_back(s);
    return found;
  };
  Cases<Substitution> cases;
  cases.count = [some] { return std::uint64_t{some().size()}; };
  cases.number = [some](std::uint64_t k) { return some()[k]; };
  cases.text = [](const Substitution& s) {
    return fmt::format("{},read={}", text_of(s.full), spec::micromap::name_of(s.read));
  };
  cases.read = [some, text = cases.text](const std::string& at) {
    for (const Substitution& s : some())
      if (text(s) == at) return s;
    throw BadCase(fmt::format("'{:.110}': write {}", at, text(some().front())));
  };
  cases.check = [check](const TraverseSubject& subject, const Substitution& s) {
    Combination read = s.full;
    read.candidate.state = s.read;
    return check(s, subject.functions.decide(s.full), subject.functions.decide(read));
  };
  return on_cases(std::move(law), {entry::decide}, std::move(cases));
}

/// Whether the ray ends another way than with the full map, for some answer of a shader that agrees with the full
/// map.
bool ends_otherwise(const Substitution& s, Outcome full, Outcome lossy) {
  for (const bool shader_says : {false, true}) {
    // The full map settles the shader's answer for its known states.
    if (s.full.candidate.state == State::T && shader_says) continue;
    if (s.full.candidate.state == State::O && !shader_says) continue;
    if (hits(full, shader_says) != hits(lossy, shader_says)) return true;
  }
  return false;
}

template <bool otherwise>
Finding ends(const Substitution& s, Outcome full, Outcome lossy) {
  if (ends_otherwise(s, full, lossy) == otherwise)
    return Finding{static_cast<std::uint64_t>(lossy) * 4 + static_cast<std::uint64_t>(full) + 1};
  return wrong(fmt::format("{} {}", otherwise ? "not as with" : "as with", text_of(full)), text_of(lossy));
}

Law is_conservative() {
  return on_substitutions(
      {.id = "traverse.lossy_is_conservative",
       .says =
           "a state read as unknown ends no ray otherwise, if its shader answers as the full map would: "
           "without force-2-state, unless flags make a T opaque or the ray culls an O by its opacity; with "
           "it, where the state keeps its side, the ray drops both sides, or a shader is asked of a T",
       .source = lossy_source,
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 0.1},
       .domain = "all 1,736 substitutions of KHR traces that leave it to the shader",
       .mutants = {mutant("the instance's force-2-state reads UO of special indices as UT", "traverse",
                          deciding([](const Combination& c, Outcome o) {
                            return c.candidate.held == Held::special && c.candidate.state == State::UO &&
                                           c.instance.force_two_state && spec::traverse::consulted(c)
                                       ? Outcome::ignored
                                       : o;
                          }))}},
      leaves_it_to_the_shader, ends<false>);
}

Law shows_without_a_shader() {
  return on_substitutions(
      {.id = "traverse.lossy_shows",
       .says = "everywhere else a state that a lossy map reads as unknown does change the ray, and no shader "
               "can help: a hole is hit, an opaque one is culled or escapes culling, or force-2-state reads "
               "the other side",
       .source = lossy_source,
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 0.1},
       .domain = "all 1,144 substitutions of KHR traces that do not leave it to the shader",
       .mutants = {mutant("force-2-state leaves UO to the shader", "traverse-spec",
                          deciding([](const Combination& c, Outcome o) {
                            return c.candidate.state == State::UO && o == Outcome::opaque &&
                                           !made_opaque(c) && !made_non_opaque(c)
                                       ? Outcome::non_opaque
                                       : o;
                          }))}},
      shows, ends<true>);
}

Law decides_no_more() {
  return on_substitutions(
      {.id = "traverse.lossy_decides_no_more",
       .says = "traversal accepts or drops by a lossy map what it accepts or drops by the full one, and asks "
               "a shader of the rest, but just where flags make a T opaque, CullNoOpaque drops an O, or "
               "force-2-state reads the other side",
       .source = lossy_source,
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 0.1},
       .domain = "all 2,880 substitutions of KHR traces",
       .mutants = {mutant("under NoOpaque force-2-state accepts UO without a shader", "traverse",
                          deciding([](const Combination& c, Outcome o) {
                            return c.candidate.state == State::UO && c.ray.no_opaque &&
                                           spec::traverse::two_state_override(c) && o == Outcome::non_opaque
                                       ? Outcome::opaque
                                       : o;
                          }))}},
      any, [](const Substitution& s, Outcome full, Outcome lossy) {
        const bool more = lossy != Outcome::non_opaque && lossy != full;
        if (more == decides_more(s))
          return Finding{static_cast<std::uint64_t>(lossy) * 4 + static_cast<std::uint64_t>(full) + 1};
        return wrong(more ? fmt::format("{} or non-opaque", text_of(full))
                          : fmt::format("another outcome than {} and non-opaque", text_of(full)),
                     text_of(lossy));
      });
}

}  // namespace

std::vector<Law> lossy_laws() { return {is_conservative(), shows_without_a_shader(), decides_no_more()}; }

}  // namespace mmverify::proofs::traverse
