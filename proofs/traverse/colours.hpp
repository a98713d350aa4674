// Colours in words: R in the lowest byte.
#pragma once

#include <cstdint>

#include "spec/traverse/blend.hpp"

namespace mmverify::proofs::traverse {

constexpr std::uint32_t word_of(const spec::traverse::Colour& c) {
  return c[0] | c[1] << 8 | c[2] << 16 | c[3] << 24;
}
constexpr spec::traverse::Colour colour_of(std::uint32_t word) {
  return {word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24};
}

}  // namespace mmverify::proofs::traverse
