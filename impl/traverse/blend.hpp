// Fixed functions in traversal: values of hits blended into a ray's payload, four codes of 8 bits to a word.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace mmverify::impl::traverse {

/// Which operation; codes mean x / 255.  max, min and add give one result for any order of hits; multiply, which rounds, and
/// over do not.  max and min take a hit twice as once.  Source: Color and Attribute Micromaps, 4.3.
enum class Operation : std::uint8_t {
  max,
  min,
  add,       ///< up to 255
  multiply,  ///< to the nearest code
  over,      ///< the value over the payload, alpha multiplied into the value; up to 255
};

/// The code nearest to x / 255, exactly, for x up to 255 * 255.
constexpr std::uint32_t divided_by_255(std::uint32_t x) noexcept { return (x + 128 + ((x + 128) >> 8)) >> 8; }

/// One code of the payload after a hit; alpha is the value's, and matters to `over` alone.  Domain: codes.
constexpr std::uint32_t blend(Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t alpha) noexcept {
  switch (o) {
    case Operation::max:
      return std::max(p, v);
    case Operation::min:
      return std::min(p, v);
    case Operation::add:
      return std::min(p + v, 255u);
    case Operation::multiply:
      return divided_by_255(p * v);
    case Operation::over:
      break;
  }
  return std::min(v + divided_by_255(p * (255 - alpha)), 255u);
}

/// The payload after a hit, code by code.  Words hold R, G, B, A from the lowest byte on.  Domain: every word.
constexpr std::uint32_t blend(Operation o, std::uint32_t payload, std::uint32_t value) noexcept {
  std::uint32_t out = 0;
  for (unsigned shift = 0; shift < 32; shift += 8)
    out |= blend(o, payload >> shift & 255, value >> shift & 255, value >> 24) << shift;
  return out;
}

/// The same of many: out[k] of payload[k] and value[k].
/// Errors: spans of other sizes than out's are std::invalid_argument, and nothing is written.
void blend(Operation o, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
           std::span<std::uint32_t> out);

/// A hit on a ray: how far, and whether it is accepted or blends.
struct Hit {
  float distance = 0;
  bool accepted = false;
  std::uint32_t value = 0;
};

/// The payload after all hits before the closest accepted one.  Blending waits for it: a blend behind it, met before it,
/// would stay otherwise, and the result depend on the order of traversal.
/// Domain: hits in any order.  Source: Color and Attribute Micromaps, 4.3; docs/TRAVERSE.md.
std::uint32_t blended(Operation o, std::uint32_t payload, std::span<const Hit> hits) noexcept;

}  // namespace mmverify::impl::traverse
