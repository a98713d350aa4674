// A lossy map has unknown states in the place of others.  Its shader answers as the full map would; then a ray may end
// another way only where nobody asks the shader.
#include "proofs/traverse/law_groups.hpp"
#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/premises.hpp"

namespace mmverify::proofs::traverse {
namespace {

constexpr char lossy_source[] =
    "VK_KHR_opacity_micromap proposal, lossy micromaps; the KHR slides, \"Lossy Micromaps\"";

/// A combination of the full map, and the unknown state that is read in the place of its state.
struct Substitution {
  Combination full;
  State read;
};

bool own_side(const Substitution& s) { return spec::micromap::as_unknown(s.full.candidate.state) == s.read; }

/// Traces of KHR that read a state of a 4-state map or of a special index, and another state, which is unknown.
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

/// Nobody but a shader can tell.  Without force-2-state: T where no flag makes hits opaque, or CullOpaque drops them; O
/// where a flag settles the opacity, or nothing is culled by it.  With it: states that stay on their side.
bool leaves_it_to_the_shader(const Substitution& s) {
  const Combination& c = s.full;
  if (spec::traverse::two_state_override(c)) return own_side(s);
  if (c.candidate.state == State::T) return !made_opaque(c) || c.ray.cull_opaque;
  return c.candidate.state != State::O || (made_opaque(c) || made_non_opaque(c)) || !culls(c);
}

/// Without force-2-state a known state outside of leaves_it_to_the_shader(); with it a known state that goes to the other
/// side, and no other flag.
bool shows(const Substitution& s) {
  const Combination& c = s.full;
  if (spec::micromap::unknown(c.candidate.state)) return false;
  if (!spec::traverse::two_state_override(c)) return !leaves_it_to_the_shader(s);
  return !own_side(s) && !made_opaque(c) && !made_non_opaque(c) && !culls(c);
}

/// Whether the candidate is a hit, given what the shader would say.
bool hits(Outcome o, bool shader_says) {
  return o == Outcome::opaque || (o == Outcome::non_opaque && shader_says);
}

/// The law on the substitutions that it is about: the ray ends as with the full map, or it does not.
Law on_substitutions(Law law, bool (*about)(const Substitution&), bool changes) {
  const auto some = std::make_shared<std::vector<Substitution>>();
  for (const Substitution& s : all_substitutions())
    if (about(s)) some->push_back(s);
  Cases<Substitution> cases;
  cases.count = [some] { return std::uint64_t{some->size()}; };
  cases.number = [some](std::uint64_t k) { return (*some)[k]; };
  cases.text = [](const Substitution& s) {
    return fmt::format("{},read={}", text_of(s.full), spec::micromap::name_of(s.read));
  };
  cases.read = [some, text = cases.text](const std::string& at) {
    for (const Substitution& s : *some)
      if (text(s) == at) return s;
    throw BadCase(fmt::format("'{:.110}': write {}", at, text(some->front())));
  };
  cases.check = [changes](const TraverseSubject& subject, const Substitution& s) {
    Combination read = s.full;
    read.candidate.state = s.read;
    const Outcome full = subject.functions.decide(s.full), lossy = subject.functions.decide(read);
    bool changed = false;
    for (const bool shader_says : {false, true}) {
      // The full map settles what a shader says of its known states.
      if (s.full.candidate.state == State::T && shader_says) continue;
      if (s.full.candidate.state == State::O && !shader_says) continue;
      changed = changed || hits(full, shader_says) != hits(lossy, shader_says);
    }
    if (changed == changes)
      return Finding{static_cast<std::uint64_t>(lossy) * 4 + static_cast<std::uint64_t>(full) + 1};
    return wrong(fmt::format("{} {}", changes ? "not as with" : "as with", text_of(full)), text_of(lossy));
  };
  return on_cases(std::move(law), {entry::decide}, std::move(cases));
}

Law is_conservative() {
  return on_substitutions(
      {.id = "traverse.lossy_is_conservative",
       .topic = "traverse",
       .says = "a state read as unknown ends no ray otherwise, if its shader answers as the full map would: "
               "without "
               "force-2-state, unless flags make a T opaque or the ray culls an O by its opacity; with it, "
               "where the state "
               "keeps its side",
       .source = lossy_source,
       .subjects = {"traverse-spec", "traverse"},
       .fast_seconds = 0.1,
       .domain = named_domain("all 1,328 substitutions of KHR traces that leave it to the shader"),
       .mutants = {mutant("unknown is transparent where the ray does not force 2-state", "traverse",
                          deciding([](const Combination& c, Outcome o) {
                            return c.candidate.state == State::UT && o == Outcome::non_opaque
                                       ? Outcome::ignored
                                       : o;
                          })),
                   mutant("UO is opaque", "traverse-spec", deciding([](const Combination& c, Outcome o) {
                            return c.candidate.state == State::UO && o == Outcome::non_opaque
                                       ? Outcome::opaque
                                       : o;
                          })),
                   mutant("the instance's force-2-state reads UO of special indices as UT", "traverse",
                          deciding([](const Combination& c, Outcome o) {
                            return c.candidate.held == Held::special && c.candidate.state == State::UO &&
                                           c.instance.force_two_state && spec::traverse::consulted(c)
                                       ? Outcome::ignored
                                       : o;
                          }))}},
      leaves_it_to_the_shader, false);
}

Law shows_without_a_shader() {
  return on_substitutions(
      {.id = "traverse.lossy_shows",
       .topic = "traverse",
       .says =
           "everywhere else a known state that a lossy map reads as unknown does change the ray, and no "
           "shader can help: "
           "a hole is hit, an opaque one is culled or escapes culling, or force-2-state reads the other side",
       .source = lossy_source,
       .subjects = {"traverse-spec", "traverse"},
       .fast_seconds = 0.1,
       .domain = named_domain("all 160 substitutions of known states that do not leave it to the shader"),
       .mutants = {mutant("CullNoOpaque spares what is unknown", "traverse",
                          deciding([](const Combination& c, Outcome o) {
                            return spec::traverse::consulted(c) &&
                                           spec::micromap::unknown(c.candidate.state) &&
                                           c.ray.cull_no_opaque && !made_opaque(c) && !made_non_opaque(c) &&
                                           !spec::traverse::two_state_override(c)
                                       ? Outcome::non_opaque
                                       : o;
                          })),
                   mutant("Opaque leaves UT to the shader", "traverse",
                          deciding([](const Combination& c, Outcome o) {
                            return c.candidate.state == State::UT && c.ray.opaque &&
                                           spec::traverse::consulted(c) && o == Outcome::opaque
                                       ? Outcome::non_opaque
                                       : o;
                          })),
                   mutant("force-2-state leaves UO to the shader", "traverse-spec",
                          deciding([](const Combination& c, Outcome o) {
                            return c.candidate.state == State::UO && o == Outcome::opaque &&
                                           !made_opaque(c) && !made_non_opaque(c)
                                       ? Outcome::non_opaque
                                       : o;
                          }))}},
      shows, true);
}

}  // namespace

std::vector<Law> lossy_laws() { return {is_conservative(), shows_without_a_shader()}; }

}  // namespace mmverify::proofs::traverse
