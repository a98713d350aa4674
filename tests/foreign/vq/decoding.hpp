// Decoding: what a block says of one region.
#pragma once

#include <cstdint>

#include "tests/foreign/vq/blocks.hpp"

namespace mmverify::tests::foreign::vq {

/// The index that belongs to the vector (X, Y).
unsigned read_index(const Format& f, const std::uint8_t* block, int X, int Y, Way way);

/// The transform that belongs to a quadrant.
unsigned read_transform(const Format& f, const std::uint8_t* block, int quadrant, unsigned index, Way way);

/// The region of the stored vector that shows at (x, y).
Region read_region(const Format& f, unsigned transform, int quadrant, int x, int y);

std::uint8_t vq2_state(const std::uint8_t* block, int x, int y, Way way);
std::uint8_t vq4_state(const std::uint8_t* block, int x, int y, Way way);

}  // namespace mmverify::tests::foreign::vq
