// Fixed functions in traversal: hits' values are blended into a ray's payload, four codes of 8 bits to a word.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace mmverify::impl::traverse {

/// The blend operation; code x means x / 255.  max, min and add give one result for any order of hits; multiply, which
/// rounds, and over do not.  For max and min, a hit taken twice counts once.  Source: Color and Attribute Micromaps,
/// 4.3.
enum class Operation : std::uint8_t {
  max,
  min,
  add,       ///< clamped to 255
  multiply,  ///< to the nearest code
  over,      ///< the value over the payload, alpha premultiplied into the value; clamped to 255
};

/// The code nearest to x / 255, exactly, for x up to 255 * 255.
/// Law: traverse.blend
constexpr std::uint32_t divided_by_255(std::uint32_t x) noexcept { return (x + 128 + ((x + 128) >> 8)) >> 8; }

/// One code of the payload after a hit; alpha is the value's, used by `over` alone.  Domain: codes.
/// Law: traverse.blend
constexpr std::uint32_t blend(Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t alpha) noexcept {
  switch (o) {
    case Operation::max: return std::max(p, v);
    case Operation::min: return std::min(p, v);
    case Operation::add: return std::min(p + v, 255u);
    case Operation::multiply: return divided_by_255(p * v);
    case Operation::over: break;
  }
  return std::min(v + divided_by_255(p * (255 - alpha)), 255u);
}

/// The payload after a hit, code by code.  Words hold R, G, B, A from the lowest byte on.  Domain: every word.
/// Law: traverse.blend, traverse.blend_on_samples
constexpr std::uint32_t blend(Operation o, std::uint32_t payload, std::uint32_t value) noexcept {
  std::uint32_t out = 0;
  for (unsigned shift = 0; shift < 32; shift += 8)
    out |= blend(o, payload >> shift & 255, value >> shift & 255, value >> 24) << shift;
  return out;
}

/// Many payloads after a hit each: out[k] of payload[k] and value[k].
/// Errors: spans of other sizes than out's are std::invalid_argument, and nothing is written.
/// Law: traverse.blend, traverse.blend_on_samples
void blend(Operation o, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
           std::span<std::uint32_t> out);

/// A hit on a ray: its distance, and whether it is accepted or blends.
struct Hit {
  float distance = 0;
  bool accepted = false;
  std::uint32_t value = 0;
};

/// The payload after all hits before the closest accepted one.  Blending waits until that hit is known: else a hit
/// behind it, met before it, would count, and the result would depend on the order of traversal.
/// Domain: hits in any order.  Source: Color and Attribute Micromaps, 4.3; docs/TRAVERSE.md.
/// Law: traverse.blend_before_closest, traverse.blend_many_on_samples
std::uint32_t blended(Operation o, std::uint32_t payload, std::span<const Hit> hits) noexcept;

}  // namespace mmverify::impl::traverse
