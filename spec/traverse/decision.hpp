// The outcome of one candidate hit on a triangle before any shader has run: traversal ignores the candidate, confirms
// it without a shader, or leaves it to a shader.  The steps are in the order of Vulkan's chapter.
#pragma once

#include <cstdint>

#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::traverse {

using micromap::State;

// ---- Inputs of a decision

/// The API that traces, and how.  EXT is VK_EXT_opacity_micromap, KHR is VK_KHR_opacity_micromap.
enum class Api : std::uint8_t { ext_pipeline, ext_query, khr_pipeline, khr_query, dxr_pipeline, dxr_query };
inline constexpr unsigned apis = 6;

/// Whether a trace has a switch that lets it meet micromaps: the flag of a pipeline, the execution mode of a KHR ray
/// query, the flag of a RayQuery.  Ray queries of EXT have none and always use micromaps.
/// Source: VkPipelineCreateFlagBits2, *_RAY_TRACING_OPACITY_MICROMAP_BIT; SPV_KHR_opacity_micromap, 3.2.5;
/// VK_KHR_opacity_micromap proposal, ray query; DXR, Opacity micromaps and TraceRay, and TraceRayInline.
constexpr bool has_switch(Api api) { return api != Api::ext_query; }

/// The place where the geometry of the candidate has its opacity.
enum class Held : std::uint8_t {
  nothing,     ///< no micromap: the geometry's own flag
  special,     ///< a special index, which stands for the whole triangle
  two_state,   ///< a micro-triangle of a 2-state map
  four_state,  ///< a micro-triangle of a 4-state map
};

/// The candidate: its opacity, and whether its geometry was built as opaque.  `state` is the state that traversal
/// reads, after any lossy substitution; it means nothing with Held::nothing.
struct Candidate {
  Held held = Held::nothing;
  State state = State::T;
  bool geometry_opaque = false;
  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// Flags of the instance.  Source: VkGeometryInstanceFlagBitsKHR; D3D12_RAYTRACING_INSTANCE_FLAGS.
struct Instance {
  bool force_opaque = false, force_no_opaque = false, force_two_state = false, disable_micromaps = false;
  friend bool operator==(const Instance&, const Instance&) = default;
};

/// Flags of the ray.  Source: SPIR-V, 3.RF, Ray Flags; DXR, RAY_FLAG.
struct Ray {
  bool opaque = false, no_opaque = false, cull_opaque = false, cull_no_opaque = false,
       force_two_state = false;
  friend bool operator==(const Ray&, const Ray&) = default;
};

/// All inputs of a decision.  An instance that disables micromaps refers to a structure that was built to allow it.
struct Combination {
  Api api = Api::khr_pipeline;
  bool enabled = true;  ///< the switch of has_switch(); true if there is none
  Candidate candidate = {};
  Instance instance = {};
  Ray ray = {};
  friend bool operator==(const Combination&, const Combination&) = default;
};

/// Whether the format has a code for the state: a 2-state map has T and O alone.
constexpr bool exists(const Candidate& c) { return c.held != Held::two_state || !micromap::unknown(c.state); }

// ---- Combinations that no API defines

/// The reasons why a combination has no defined outcome.
struct Undefined {
  bool ray_flags = false;       ///< more than one of Opaque, NoOpaque, CullOpaque, CullNoOpaque
  bool instance_flags = false;  ///< both FORCE_OPAQUE and FORCE_NO_OPAQUE
  bool not_enabled = false;     ///< the triangle has a micromap, and the trace was not set up for micromaps
  constexpr bool any() const { return ray_flags || instance_flags || not_enabled; }
  friend bool operator==(const Undefined&, const Undefined&) = default;
};

/// The reasons of a combination.  Domain: candidates that exist.
/// Source: VUID-RuntimeSpirv-OpTraceRayKHR-06893, DXR RAY_FLAG; VkGeometryInstanceFlagBitsKHR,
/// D3D12_RAYTRACING_INSTANCE_FLAG_FORCE_OPAQUE; those of has_switch().  A disabled micromap is one that the triangle
/// has.
constexpr Undefined undefined(const Combination& c) {
  const int of_ray = int{c.ray.opaque} + c.ray.no_opaque + c.ray.cull_opaque + c.ray.cull_no_opaque;
  return {of_ray > 1, c.instance.force_opaque && c.instance.force_no_opaque,
          has_switch(c.api) && !c.enabled && c.candidate.held != Held::nothing};
}

// ---- The decision

enum class Outcome : std::uint8_t {
  ignored,     ///< dropped, no shader runs
  opaque,      ///< confirmed, no shader runs
  non_opaque,  ///< the any-hit shader decides, or the ray query hands the candidate out
};
constexpr const char* name_of(Outcome o) {
  constexpr const char* names[] = {"ignored", "opaque", "non-opaque"};
  return names[static_cast<unsigned>(o)];
}

/// Whether the micromap decides instead of the geometry's flag.
/// Source: Vulkan, Ray Opacity Micromap; DXR, Opacity micromaps and TraceRay.
constexpr bool consulted(const Combination& c) {
  return c.candidate.held != Held::nothing && !c.instance.disable_micromaps;
}

/// Whether unknown states are read by their force-2-state.  Source: Vulkan, Ray Opacity Micromap.
constexpr bool two_state_override(const Combination& c) {
  return c.instance.force_two_state || c.ray.force_two_state;
}

/// The outcome of a state.  Source: Vulkan, Ray Opacity Micromap, its table.
constexpr Outcome looked_up(State s, bool two_state) {
  switch (s) {
    case State::T: return Outcome::ignored;
    case State::O: return Outcome::opaque;
    case State::UT: return two_state ? Outcome::ignored : Outcome::non_opaque;
    case State::UO: break;
  }
  return two_state ? Outcome::opaque : Outcome::non_opaque;
}

/// The opacity before the instance's and the ray's flags.  Source: Vulkan, Ray Opacity Culling, Determination.
constexpr Outcome initial(const Combination& c) {
  if (consulted(c)) return looked_up(c.candidate.state, two_state_override(c));
  return c.candidate.geometry_opaque ? Outcome::opaque : Outcome::non_opaque;
}

/// The outcome after FORCE_OPAQUE or FORCE_NO_OPAQUE of the instance, and after Opaque or NoOpaque of the ray, which
/// overrides them.  Domain: not both of either.  Source: Vulkan, Ray Opacity Culling, Determination.
constexpr Outcome overridden(Outcome o, const Instance& instance, const Ray& ray) {
  if (instance.force_opaque) o = Outcome::opaque;
  if (instance.force_no_opaque) o = Outcome::non_opaque;
  if (ray.opaque) o = Outcome::opaque;
  if (ray.no_opaque) o = Outcome::non_opaque;
  return o;
}

/// Source: Vulkan, Ray Opacity Culling, Culling.
constexpr Outcome culled(Outcome o, const Ray& ray) {
  if (ray.cull_opaque && o == Outcome::opaque) return Outcome::ignored;
  if (ray.cull_no_opaque && o == Outcome::non_opaque) return Outcome::ignored;
  return o;
}

/// Decides a candidate.  No flag brings back a candidate that the lookup ignores.
/// Domain: a candidate that exists, and no reason of undefined().
/// Source: Vulkan, Ray Opacity Culling and Ray Opacity Micromap; DXR, Opacity micromaps and TraceRay.
constexpr Outcome decide(const Combination& c) {
  const Outcome o = initial(c);
  if (o == Outcome::ignored) return o;
  return culled(overridden(o, c.instance, c.ray), c.ray);
}

}  // namespace mmverify::spec::traverse
