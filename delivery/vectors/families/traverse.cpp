// The decisions of traversal on a candidate hit: every combination of state and flags that is defined.
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/micromap/level.hpp"
#include "spec/micromap/lossy.hpp"
#include "spec/traverse/decision.hpp"

namespace mmverify::vectors::traverse {
namespace {

using namespace spec::traverse;
namespace micromap = spec::micromap;

constexpr State every_state[] = {State::T, State::O, State::UT, State::UO};

std::vector<std::string> state_names() { return {"T", "O", "UT", "UO"}; }

std::uint32_t word(bool bit, std::uint32_t value) { return bit ? value : 0; }

/// The word by which drivers and shaders name a combination: the state in bits 0 and 1, bit 2 if there is a
/// micromap, bit 3 if the geometry is opaque.
std::uint32_t word_of(const Candidate& c) {
  return micromap::code(c.state) | word(c.held != Held::nothing, 4) | word(c.geometry_opaque, 8);
}
/// Source: VkGeometryInstanceFlagBitsKHR; D3D12_RAYTRACING_INSTANCE_FLAGS.
std::uint32_t word_of(const Instance& i) {
  return word(i.force_opaque, 0x4) | word(i.force_no_opaque, 0x8) | word(i.force_two_state, 0x10) |
         word(i.disable_micromaps, 0x20);
}
/// Source: SPIR-V, 3.RF, Ray Flags; DXR, RAY_FLAG.
std::uint32_t word_of(const Ray& r) {
  return word(r.opaque, 0x1) | word(r.no_opaque, 0x2) | word(r.cull_opaque, 0x40) |
         word(r.cull_no_opaque, 0x80) | word(r.force_two_state, 0x400);
}

std::vector<Candidate> every_candidate() {
  std::vector<Candidate> all;
  for (const bool opaque : {false, true}) {
    all.push_back({Held::nothing, State::T, opaque});
    for (const State s : every_state) all.push_back({Held::four_state, s, opaque});
  }
  return all;
}

std::vector<Instance> every_instance() {
  std::vector<Instance> all;
  for (unsigned k = 0; k < 16; ++k) all.push_back({(k & 1) != 0, (k & 2) != 0, (k & 4) != 0, (k & 8) != 0});
  return all;
}

std::vector<Ray> every_ray() {
  std::vector<Ray> all;
  for (unsigned k = 0; k < 32; ++k)
    all.push_back({(k & 1) != 0, (k & 2) != 0, (k & 4) != 0, (k & 8) != 0, (k & 16) != 0});
  return all;
}

/// The reason why a combination has a vector.
const char* about(const Combination& c) {
  const bool culls = c.ray.cull_opaque || c.ray.cull_no_opaque;
  if (c.candidate.held == Held::nothing) return "no micromap: the geometry's flag counts";
  if (c.instance.disable_micromaps) return "a micromap that the instance disables: as if there were none";
  if (initial(c) == Outcome::ignored && (c.ray.opaque || c.instance.force_opaque))
    return "a hole stays a hole, whatever flags ask for";
  if (initial(c) == Outcome::ignored) return "ignored by the lookup";
  if (two_state_override(c) && micromap::unknown(c.candidate.state))
    return "force-2-state on an unknown state";
  if (culls) return "culled by opacity, or not";
  if (c.ray.opaque || c.ray.no_opaque) return "the ray's flag has the last word";
  if (c.instance.force_opaque || c.instance.force_no_opaque) return "the instance's flag over the micromap";
  return "the state alone";
}

void add_states(Builder& out) {
  for (const State s : every_state)
    out.add({"each state", micromap::code(s), micromap::code(micromap::force2(s)),
             micromap::unknown(s) ? 1u : 0u, micromap::code(micromap::as_unknown(s))});
}

void add_substitutions(Builder& out) {
  for (const State was : every_state)
    for (const State is : every_state)
      out.add({"each pair", micromap::code(was), micromap::code(is), micromap::allowed(was, is) ? 1u : 0u,
               micromap::conservative(was, is) ? 1u : 0u, micromap::force2_stable(was, is) ? 1u : 0u});
}

void add_down(Builder& out) {
  for (unsigned k = 0; k < 256; ++k) {
    Bytes children;
    for (unsigned c = 0; c < 4; ++c) children.push_back(static_cast<std::uint8_t>(k >> 2 * c & 3));
    const State parent =
        micromap::merged(State(children[0]), State(children[1]), State(children[2]), State(children[3]));
    out.add({"each four states", children, micromap::code(parent)});
  }
}

void add_decisions(Builder& out) {
  for (const Candidate& candidate : every_candidate())
    for (const Instance& instance : every_instance())
      for (const Ray& ray : every_ray()) {
        const Combination c{Api::khr_pipeline, true, candidate, instance, ray};
        if (undefined(c).any()) continue;
        out.add({about(c), word_of(candidate), word_of(instance), word_of(ray),
                 static_cast<std::uint32_t>(decide(c))});
      }
}

void add_undefined(Builder& out) {
  const Instance both{true, true, false, false}, disabled{false, false, false, true};
  const Ray two{true, true, false, false, false}, culls{false, false, true, true, false},
      mixed{true, false, false, true, false};
  for (unsigned api = 0; api < apis; ++api)
    for (const bool enabled : {true, false}) {
      if (!enabled && !has_switch(Api(api))) continue;
      for (const Candidate& candidate : {Candidate{}, Candidate{Held::four_state, State::O, false}})
        for (const Instance& instance : {Instance{}, both, disabled})
          for (const Ray& ray : {Ray{}, two, culls, mixed}) {
            const Undefined why = undefined({Api(api), enabled, candidate, instance, ray});
            out.add({why.not_enabled ? "micromaps that the trace is not set up for"
                     : why.any()     ? "flags that exclude each other"
                                     : "defined, beside what is not",
                     api, enabled ? 1u : 0u, word_of(candidate), word_of(instance), word_of(ray),
                     std::uint64_t{word(why.ray_flags, 1) | word(why.instance_flags, 2) |
                                   word(why.not_enabled, 4)}});
          }
    }
}

}  // namespace

Family family() {
  Builder out("traverse", 1, "states, and what traversal does with a candidate hit before any shader runs");
  const Column why{"about", Kind::about, "why the vector is there"};
  out.table("states", "What each state is.",
            {why,
             {"state", Kind::name, "its 4-state code", state_names()},
             {"forced", Kind::name, "what it is under force-2-state", state_names()},
             {"unknown", Kind::number, "1 where the any-hit shader is asked, else 0"},
             {"as_unknown", Kind::name, "the unknown state of its side", state_names()}});
  add_states(out);
  out.table("changes", "Which state may take the place of which.",
            {why,
             {"was", Kind::name, "the state", state_names()},
             {"is", Kind::name, "what took its place", state_names()},
             {"lossy", Kind::number, "1 where KHR's rule for lossy builds allows it"},
             {"conservative", Kind::number, "1 where T or O became unknown, or nothing changed"},
             {"stable", Kind::number, "1 where force-2-state sees no difference and no promise is added"}});
  add_substitutions(out);
  out.table("down", "Four states as one of the level above: mmverify's rule, which keeps every promise.",
            {why,
             {"children", Kind::digits, "codes of the children 0..3"},
             {"parent", Kind::name, "the state above", state_names()}});
  add_down(out);
  out.table(
      "decisions", "All combinations that are defined; all ways to trace decide alike.",
      {why,
       {"candidate", Kind::number, "state, 4 where there is a micromap, 8 where the geometry is opaque"},
       {"instance", Kind::number, "flags: 4 opaque, 8 no opaque, 16 force-2-state, 32 no micromaps"},
       {"ray", Kind::number, "flags: 1 opaque, 2 no opaque, 64, 128 their culling, 1024 force-2-state"},
       {"outcome", Kind::name, "what becomes of the candidate", {"ignored", "opaque", "non-opaque"}}});
  add_decisions(out);
  out.table(
      "undefined", "What no specification defines, and why; not to be tested for an outcome.",
      {why,
       {"api",
        Kind::name,
        "who traces",
        {"ext-pipeline", "ext-query", "khr-pipeline", "khr-query", "dxr-pipeline", "dxr-query"}},
       {"enabled", Kind::number, "1 where the trace is set up for micromaps"},
       {"candidate", Kind::number, "as in decisions"},
       {"instance", Kind::number, "as in decisions"},
       {"ray", Kind::number, "as in decisions"},
       {"why", Kind::set, "the reasons; none: defined", {"ray-flags", "instance-flags", "not-enabled"}}});
  add_undefined(out);
  return out.take();
}

}  // namespace mmverify::vectors::traverse
