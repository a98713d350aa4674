// Fixed functions in traversal: a hit blends its value into the ray's payload instead of running an any-hit shader.
// The paper names one operation, max, and no order; the laws tell which operations need none.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace mmverify::spec::traverse {

/// Source: Color and Attribute Micromaps, 4.3, for max; the others are those of rasterisation's blending.
enum class Operation : std::uint8_t { max, min, add, multiply, over };
inline constexpr unsigned operations = 5;
constexpr const char* name_of(Operation o) {
  constexpr const char* names[] = {"max", "min", "add", "multiply", "over"};
  return names[static_cast<unsigned>(o)];
}

/// A code of 8 bits; code x means x / 255.
using Code = std::uint32_t;

/// R, G, B, A.
using Colour = std::array<Code, 4>;

/// The code nearest to the number x / 255 / 255, for a product x of two codes: floor((2x + 255) / 510).  No product
/// lies halfway.
constexpr Code nearest(std::uint32_t product) { return (2 * product + 255) / 510; }

/// One channel of the payload after a hit.
///   max(p, v) | min(p, v) | min(255, p + v) | p v | min(255, v + p (1 - alpha))
/// Domain: codes.  alpha is the value's own; `over` takes values premultiplied with it.
/// Source: Color and Attribute Micromaps, 4.3; Vulkan, Blend Operations; Porter and Duff, over.
constexpr Code blend(Operation o, Code p, Code v, Code alpha) {
  switch (o) {
    case Operation::max: return std::max(p, v);
    case Operation::min: return std::min(p, v);
    case Operation::add: return std::min<Code>(255, p + v);
    case Operation::multiply: return nearest(p * v);
    case Operation::over: break;
  }
  return std::min<Code>(255, v + nearest(p * (255 - alpha)));
}

/// The payload after a hit, channel by channel.
constexpr Colour blend(Operation o, const Colour& payload, const Colour& value) {
  Colour out{};
  for (std::size_t c = 0; c < out.size(); ++c) out[c] = blend(o, payload[c], value[c], value[3]);
  return out;
}

/// A hit on a ray: its distance, and whether it is accepted or blends.  The distance is the bits of a binary32 number
/// that is not negative, whose order is that of the numbers.
struct Hit {
  std::uint32_t distance = 0;
  bool accepted = false;
  Colour value = {};
};

/// The payload if each hit is blended as it is met.  An accepted hit hides hits that are met later and lie behind it,
/// or at its distance, not those met before.  Domain: hits in the order in which they are met; some may be reported
/// again.
/// Source: Color and Attribute Micromaps, 4.3, figure 6, which leaves the order open; Vulkan, Ray Closest Hit
/// Determination.
constexpr Colour blended_as_met(Operation o, Colour payload, std::span<const Hit> hits) {
  std::uint32_t closest = ~0u;
  for (const Hit& h : hits) {
    if (h.distance >= closest) continue;
    if (h.accepted)
      closest = h.distance;
    else
      payload = blend(o, payload, h.value);
  }
  return payload;
}

/// The payload if blending waits until the closest accepted hit is known: the hits before it blend, in the order in
/// which they were met; a hit at its very distance is hidden.  Domain: as blended_as_met().
constexpr Colour blended_before_closest(Operation o, Colour payload, std::span<const Hit> hits) {
  std::uint32_t closest = ~0u;
  for (const Hit& h : hits)
    if (h.accepted) closest = std::min(closest, h.distance);
  for (const Hit& h : hits)
    if (!h.accepted && h.distance < closest) payload = blend(o, payload, h.value);
  return payload;
}

}  // namespace mmverify::spec::traverse
