// Colours in words: R in the lowest byte.
#pragma once

#include "spec/traverse/blend.hpp"
#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

constexpr std::uint32_t word_of(const spec::traverse::Colour& c) {
  return c[0] | c[1] << 8 | c[2] << 16 | c[3] << 24;
}
constexpr spec::traverse::Colour colour_of(std::uint32_t word) {
  return {word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24};
}

/// The three words of a candidate, as impl/traverse/decision.hpp and the header of subjects number their bits.
struct Words {
  std::uint32_t candidate, instance, ray;
};

/// The combination's words; who traces and whether it may meet micromaps are in none of them.
/// Source: SPIR-V, 3.RF, Ray Flags; VkGeometryInstanceFlagBitsKHR.
constexpr Words words_of(const spec::traverse::Combination& c) {
  const auto bit = [](bool set, std::uint32_t value) { return set ? value : 0; };
  const bool has = c.candidate.held != spec::traverse::Held::nothing;
  return {(has ? spec::micromap::code(c.candidate.state) : 0u) | bit(has, 4) |
              bit(c.candidate.geometry_opaque, 8),
          bit(c.instance.force_opaque, 4) | bit(c.instance.force_no_opaque, 8) |
              bit(c.instance.force_two_state, 16) | bit(c.instance.disable_micromaps, 32),
          bit(c.ray.opaque, 1) | bit(c.ray.no_opaque, 2) | bit(c.ray.cull_opaque, 64) |
              bit(c.ray.cull_no_opaque, 128) | bit(c.ray.force_two_state, 1024)};
}

}  // namespace mmverify::proofs::traverse
