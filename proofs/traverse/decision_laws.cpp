// Laws of the outcome for a candidate, in every combination that an API defines, and of the undefined combinations.
#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/laws.hpp"
#include "proofs/traverse/premises.hpp"

namespace mmverify::proofs::traverse {
namespace {

constexpr char dxr_and_vulkan[] =
    "Vulkan, Ray Opacity Culling and Ray Opacity Micromap; DXR, Opacity micromaps and TraceRay";

bool all_of_them(const Combination&) { return true; }

using spec::traverse::consulted;

Law decision() {
  return on_defined(
      {.id = "traverse.decision",
       .says = "a candidate is ignored, opaque or non-opaque by the lookup or the geometry's flag, then the "
               "instance's force flags, then the ray's, then culling",
       .source = dxr_and_vulkan,
       .subjects = {"traverse", "traverse-single"},
       .tiers = {.seconds = 0.2},
       .domain = "all 17,040 combinations that an API defines",
       .mutants = {mutant(
           "one combination", "traverse-single", deciding([](const Combination& c, Outcome o) {
             static const Combination one = combination_of(
                 "khr-query,on,4-state:UO,not-opaque,instance=force-no-opaque+2-state,ray=opaque");
             return c == one ? Outcome::non_opaque : o;
           }))}},
      all_of_them, [](const TraverseSubject& s, const Combination& c) {
        return same(spec::traverse::decide(c), s.functions.decide(c));
      });
}

std::string reasons_of(const Undefined& u) {
  std::string text;
  const auto add = [&](bool is_so, const char* reason) {
    if (is_so) text += (text.empty() ? "" : ", ") + std::string(reason);
  };
  add(u.ray_flags, "ray flags");
  add(u.instance_flags, "instance flags");
  add(u.not_enabled, "not enabled");
  return text.empty() ? "defined" : text;
}

Law undefined_is_named() {
  Cases<Combination> cases;
  cases.count = [] { return all_combinations; };
  cases.number = combination;
  cases.text = [](const Combination& c) { return text_of(c); };
  cases.read = combination_of;
  cases.check = [](const TraverseSubject& s, const Combination& c) {
    const Undefined right = spec::traverse::undefined(c), got = s.functions.undefined(c);
    if (got != right) return wrong(reasons_of(right), reasons_of(got));
    return Finding{1u + got.ray_flags + 2u * got.instance_flags + 4u * got.not_enabled};
  };
  const auto naming = [](void (*wrong)(const Combination&, Undefined&)) {
    return spoils(&Functions::undefined, wrong);
  };
  return on_cases<Combination>(
      {.id = "traverse.undefined_is_named",
       .says = "a combination is undefined where ray flags or instance flags exclude each other, or where a "
               "triangle with a micromap is met by a trace that is not set up for any, and it has these "
               "reasons and no others",
       .source = "VUID-RuntimeSpirv-OpTraceRayKHR-06893; VkGeometryInstanceFlagBitsKHR; "
                 "SPV_KHR_opacity_micromap, 3.2.5; DXR, RAY_FLAG and Opacity micromaps",
       .subjects = {"traverse", "traverse-spec"},
       .tiers = {.seconds = 0.3},
       .domain = "all 123,904 combinations",
       .mutants =
           {mutant("Opaque goes with CullNoOpaque", "traverse",
                   naming([](const Combination& c, Undefined& u) {
                     if (c.ray.opaque && c.ray.cull_no_opaque && !c.ray.no_opaque && !c.ray.cull_opaque)
                       u.ray_flags = false;
                   })),
            mutant("three ray flags at once are let pass", "traverse",
                   naming([](const Combination& c, Undefined& u) {
                     if (int{c.ray.opaque} + c.ray.no_opaque + c.ray.cull_opaque + c.ray.cull_no_opaque == 3)
                       u.ray_flags = false;
                   })),
            mutant("a KHR ray query without its execution mode skips micromaps", "traverse-spec",
                   naming([](const Combination& c, Undefined& u) {
                     if (c.api == Api::khr_query) u.not_enabled = false;
                   })),
            mutant("a disabled micromap is none", "traverse", naming([](const Combination& c, Undefined& u) {
                     if (c.instance.disable_micromaps) u.not_enabled = false;
                   }))}},
      {entry::undefined}, std::move(cases));
}

Law ignored_is_final() {
  return on_defined({.id = "traverse.ignored_is_final",
                     .says = "what the lookup ignores, T, or UT under force-2-state, no flag of the "
                             "geometry, the instance or the ray brings back",
                     .source = dxr_and_vulkan,
                     .subjects = {"traverse-spec", "traverse"},
                     .tiers = {.seconds = 0.1},
                     .domain = "all 3,240 defined combinations whose lookup ignores",
                     .mutants = {mutant("FORCE_OPAQUE of an opaque geometry wins over a special T",
                                        "traverse-spec", deciding([](const Combination& c, Outcome o) {
                                          return consulted(c) && c.candidate.held == Held::special &&
                                                         c.candidate.geometry_opaque &&
                                                         c.instance.force_opaque
                                                     ? Outcome::opaque
                                                     : o;
                                        }))}},
                    lookup_ignores, [](const TraverseSubject& s, const Combination& c) {
                      return same(Outcome::ignored, s.functions.decide(c));
                    });
}

Law two_state_never_calls_a_shader() {
  return on_defined(
      {.id = "traverse.two_state_never_calls_a_shader",
       .says = "of states that are known, or read under force-2-state, a shader is asked just where "
               "NoOpaque, or FORCE_NO_OPAQUE without the ray's Opaque, wants it for O or UO and CullNoOpaque "
               "does not drop them",
       .source = "Vulkan, Ray Opacity Micromap; the KHR slides, \"force2state\"",
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 0.1},
       .domain = "all 6,480 defined combinations whose lookup leaves nothing unknown",
       .mutants = {mutant("force-2-state overrides NoOpaque, too", "traverse", mistaking([](Combination& c) {
                            if (c.instance.force_two_state && consulted(c)) c.ray.no_opaque = false;
                          }))}},
      certain, [](const TraverseSubject& s, const Combination& c) {
        const bool right =
            !on_transparent_side(c.candidate.state) && made_non_opaque(c) && !c.ray.cull_no_opaque;
        const Outcome got = s.functions.decide(c);
        if ((got == Outcome::non_opaque) == right) return Finding{static_cast<std::uint64_t>(got) + 1};
        return wrong(right ? "a shader is asked" : "no shader is asked", text_of(got));
      });
}

Law micromap_replaces_flag() {
  return on_defined({.id = "traverse.micromap_replaces_flag",
                     .says = "where a micromap counts the geometry's opaque flag does not; where there is "
                             "none, or the instance disables it, neither its states nor force-2-state do",
                     .source = dxr_and_vulkan,
                     .subjects = {"traverse-spec", "traverse"},
                     .tiers = {.seconds = 0.2},
                     .domain = "all 17,040 combinations that an API defines",
                     .mutants = {mutant("force-2-state makes geometries without a micromap opaque",
                                        "traverse-spec", mistaking([](Combination& c) {
                                          if (!consulted(c) && c.ray.force_two_state)
                                            c.candidate.geometry_opaque = true;
                                        }))}},
                    all_of_them, [](const TraverseSubject& s, const Combination& c) {
                      const Outcome here = s.functions.decide(c);
                      Combination other = c;
                      if (consulted(c)) {
                        other.candidate.geometry_opaque = !other.candidate.geometry_opaque;
                      } else {
                        other.candidate.held = Held::nothing;
                        other.candidate.state = State::T;
                        other.instance.force_two_state = other.ray.force_two_state = false;
                      }
                      const Outcome there = s.functions.decide(other);
                      if (here == there) return Finding{static_cast<std::uint64_t>(here) + 1};
                      return wrong(fmt::format("{}, as {}", text_of(there), text_of(other)), text_of(here));
                    });
}

Law last_flag_wins() {
  return on_defined(
      {.id = "traverse.last_flag_wins",
       .says = "what the lookup does not ignore is opaque or not as the ray's Opaque or NoOpaque say, else "
               "the instance's force flags; CullOpaque or CullNoOpaque then drop what they name",
       .source = "Vulkan, Ray Opacity Culling; DXR, RAY_FLAG and D3D12_RAYTRACING_INSTANCE_FLAGS",
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 0.1},
       .domain = "all 11,040 defined combinations with such a flag and no ignoring lookup",
       .mutants = {mutant("FORCE_OPAQUE leaves O, UT and UO of a special index as they are", "traverse-spec",
                          mistaking([](Combination& c) {
                            if (consulted(c) && c.candidate.held == Held::special)
                              c.instance.force_opaque = false;
                          }))}},
      [](const Combination& c) { return !lookup_ignores(c) && (made_opaque(c) || made_non_opaque(c)); },
      [](const TraverseSubject& s, const Combination& c) {
        const bool opaque = made_opaque(c), dropped = opaque ? c.ray.cull_opaque : c.ray.cull_no_opaque;
        return same(dropped  ? Outcome::ignored
                    : opaque ? Outcome::opaque
                             : Outcome::non_opaque,
                    s.functions.decide(c));
      });
}

Law apis_agree() {
  return on_defined(
      {.id = "traverse.apis_agree",
       .says = "EXT, KHR and DXR, pipelines and ray queries, decide alike wherever they define the outcome",
       .source = dxr_and_vulkan,
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 0.1},
       .domain = "the 2,640 defined combinations of an EXT ray query, in the five other APIs",
       .mutants = {mutant("EXT pipelines have no FORCE_NO_OPAQUE of 2-state maps", "traverse",
                          mistaking([](Combination& c) {
                            if (c.api == Api::ext_pipeline && c.candidate.held == Held::two_state)
                              c.instance.force_no_opaque = false;
                          }))}},
      [](const Combination& c) { return c.api == Api::ext_query; },
      [](const TraverseSubject& s, const Combination& c) {
        const Outcome here = s.functions.decide(c);
        for (unsigned api = 0; api < spec::traverse::apis; ++api) {
          Combination other = c;
          other.api = static_cast<Api>(api);
          if (const Outcome there = s.functions.decide(other); there != here)
            return wrong(fmt::format("{} in {}", text_of(here), name_of(c.api)),
                         fmt::format("{} in {}", text_of(there), name_of(other.api)));
        }
        return Finding{static_cast<std::uint64_t>(here) + 1};
      });
}

}  // namespace

std::vector<Law> decision_laws() {
  return {decision(),
          undefined_is_named(),
          ignored_is_final(),
          two_state_never_calls_a_shader(),
          micromap_replaces_flag(),
          last_flag_wins(),
          apis_agree()};
}

}  // namespace mmverify::proofs::traverse
