// The outcome of a ray's candidate hit on a triangle, from the very words of drivers and shaders: flags of the instance
// and of the ray in the numbers of Vulkan, SPIR-V and DXR, which are the same.  No branches.
#pragma once

#include <cstdint>
#include <span>

namespace mmverify::impl::traverse {

/// The bits of a candidate's word.  The low two are the state that was read, T 0, O 1, UT 2, UO 3.
inline constexpr std::uint32_t candidate_state = 3;
/// A micromap or a special index decides the opacity.  Without this bit the state means nothing.
inline constexpr std::uint32_t candidate_has_micromap = 4;
/// The geometry was built as opaque.
inline constexpr std::uint32_t candidate_geometry_opaque = 8;

/// Flags of an instance.  Source: VkGeometryInstanceFlagBitsKHR; D3D12_RAYTRACING_INSTANCE_FLAGS.
inline constexpr std::uint32_t instance_force_opaque = 0x4, instance_force_no_opaque = 0x8,
                               instance_force_two_state = 0x10, instance_disable_micromaps = 0x20;

/// Flags of a ray.  Source: SPIR-V, 3.RF, Ray Flags; DXR, RAY_FLAG.
inline constexpr std::uint32_t ray_opaque = 0x1, ray_no_opaque = 0x2, ray_cull_opaque = 0x40,
                               ray_cull_no_opaque = 0x80, ray_force_two_state = 0x400;

/// The outcome of a candidate hit.
enum class Outcome : std::uint8_t {
  ignored,     ///< dropped, no shader runs
  opaque,      ///< confirmed, no shader runs
  non_opaque,  ///< the any-hit shader decides, or the ray query hands the candidate out
};

/// Decides a candidate, in this order: the micromap's state, or the geometry's flag if there is no micromap or the
/// instance disables it; the 2-state override; the instance's force flags; the ray's; culling.
/// Domain: every word; if undefined() has a reason, some outcome.  Other bits are ignored.
/// Source: Vulkan, Ray Opacity Culling and Ray Opacity Micromap; DXR, Opacity micromaps and TraceRay.
/// Law: traverse.decision
constexpr Outcome decide(std::uint32_t candidate, std::uint32_t instance, std::uint32_t ray) noexcept {
  const std::uint32_t consulted = candidate >> 2 & ~(instance >> 5) & 1, side = candidate & 1;
  const std::uint32_t known = (~(candidate >> 1) | instance >> 4 | ray >> 10) & 1;
  std::uint32_t opaque = (consulted & side & known) | (~consulted & candidate >> 3 & 1);
  opaque = (opaque | instance >> 2) & ~(instance >> 3) & 1;
  opaque = (opaque | ray) & ~(ray >> 1) & 1;
  const std::uint32_t dropped =
      (consulted & known & ~side) | (opaque & ray >> 6 & 1) | (~opaque & ray >> 7 & 1);
  return static_cast<Outcome>((2 - opaque) & (dropped - 1));
}

/// The outcomes of many candidates: out[k] of candidate[k], instance[k] and ray[k].
/// Errors: spans of other sizes than out's are std::invalid_argument, and nothing is written.
/// Law: traverse.decision
void decide(std::span<const std::uint32_t> candidate, std::span<const std::uint32_t> instance,
            std::span<const std::uint32_t> ray, std::span<Outcome> out);

/// The reasons why no specification defines the outcome.
/// Two or more of the ray's Opaque, NoOpaque, CullOpaque, CullNoOpaque exclude each other.
inline constexpr std::uint32_t undefined_ray_flags = 1;
/// The instance's two force flags exclude each other.
inline constexpr std::uint32_t undefined_instance_flags = 2;
/// The triangle has a micromap, but the pipeline, the shader or the RayQuery is not set up for micromaps.
inline constexpr std::uint32_t undefined_not_enabled = 4;

/// The set of reasons; 0 if the outcome is defined.  `enabled`: the pipeline's flag, the execution mode
/// OpacityMicromapIdKHR, or the RayQuery's flag is set; true for ray queries of VK_EXT_opacity_micromap.
/// Source: VUID-RuntimeSpirv-OpTraceRayKHR-06893; VkGeometryInstanceFlagBitsKHR; SPV_KHR_opacity_micromap, 3.2.5; DXR.
/// Law: traverse.undefined_is_named
constexpr std::uint32_t undefined(bool enabled, std::uint32_t candidate, std::uint32_t instance,
                                  std::uint32_t ray) noexcept {
  const std::uint32_t exclusive = ray & (ray_opaque | ray_no_opaque | ray_cull_opaque | ray_cull_no_opaque);
  constexpr std::uint32_t both = instance_force_opaque | instance_force_no_opaque;
  return ((exclusive & (exclusive - 1)) != 0 ? undefined_ray_flags : 0) |
         ((instance & both) == both ? undefined_instance_flags : 0) |
         (!enabled && (candidate & candidate_has_micromap) != 0 ? undefined_not_enabled : 0);
}

}  // namespace mmverify::impl::traverse
