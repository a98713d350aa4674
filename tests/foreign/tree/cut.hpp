// Cuts a code into tree and data, and tells whether it is a code at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/foreign/tree/bits.hpp"
#include "tests/foreign/tree/faults.hpp"
#include "tests/foreign/tree/form.hpp"

namespace mmverify::tests::foreign::tree {

/// The tree's bits, cut into nodes.
struct Tree {
  unsigned level = 0, bits = 0;
  const std::uint8_t* code = nullptr;
  std::size_t size = 0;  // nodes
  std::size_t leaves = 0;
  std::size_t data = 0;               // where they begin, in bits
  std::vector<std::uint32_t> end;     // of each node, the node after its last descendant
  std::vector<std::uint32_t> before;  // of each node, the leaves before it

  bool is_internal(std::size_t t) const { return bit_at(code, t) == (has(form_leaf_is_one) ? 0u : 1u); }
  unsigned state(std::size_t d) const {
    if (has(lookup_leaf_in_8_bits)) d &= 0xff;
    return stored(bits_at(code, data + d * bits, bits), level);
  }
};

/// Whether the code begins with a tree that is no deeper than its level, and then that tree.
bool cut(Tree& tree, std::size_t code_size);

}  // namespace mmverify::tests::foreign::tree
