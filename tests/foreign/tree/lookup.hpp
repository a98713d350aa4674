// Algorithm 3.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tests/foreign/tree/cut.hpp"

namespace mmverify::tests::foreign::tree {

/// A lookup's tree: that of the code, or one kept from an earlier call.
const Tree& tree_of(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size);

/// The state of a micro-triangle.
unsigned looked_up(const Tree& tree, std::uint32_t index, bool by_point);

}  // namespace mmverify::tests::foreign::tree
