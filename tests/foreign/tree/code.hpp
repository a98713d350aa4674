// Maps and codes: the paper's two bit sequences, and a code of our own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tests/foreign/tree/bits.hpp"

namespace mmverify::tests::foreign::tree {

/// Algorithms 1 and 2: the tree's bits, then the leaves'.
Bytes stream(unsigned level, unsigned bits, const std::uint8_t* map);

/// 1, and the map; 0 where `code` is none.
int decode_stream(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size,
                  std::uint8_t* map);

/// A code of our own: a byte that says how, then the map as it is, or the tree's and the leaves' bits.
Bytes private_code(unsigned level, unsigned bits, const std::uint8_t* map);
int decode_private(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size,
                   std::uint8_t* map);

}  // namespace mmverify::tests::foreign::tree
