#include "impl/traverse/blend.hpp"

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace mmverify::impl::traverse {
namespace {

/// The loop for one operation, which is known at compile time.
template <Operation o>
void blend_all(std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
               std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = blend(o, payload[k], value[k]);
}

}  // namespace

void blend(Operation o, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
           std::span<std::uint32_t> out) {
  if (payload.size() != out.size() || value.size() != out.size())
    throw std::invalid_argument("blend: spans of different sizes");
  switch (o) {
    case Operation::max: return blend_all<Operation::max>(payload, value, out);
    case Operation::min: return blend_all<Operation::min>(payload, value, out);
    case Operation::add: return blend_all<Operation::add>(payload, value, out);
    case Operation::multiply: return blend_all<Operation::multiply>(payload, value, out);
    case Operation::over: return blend_all<Operation::over>(payload, value, out);
  }
}

std::uint32_t blended(Operation o, std::uint32_t payload, std::span<const Hit> hits) noexcept {
  float closest = std::numeric_limits<float>::infinity();
  for (const Hit& h : hits)
    if (h.accepted) closest = std::min(closest, h.distance);
  for (const Hit& h : hits)
    if (!h.accepted && h.distance < closest) payload = blend(o, payload, h.value);
  return payload;
}

}  // namespace mmverify::impl::traverse
