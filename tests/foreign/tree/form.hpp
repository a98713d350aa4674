// The form of a code, where the faults change encoder, decoder and lookups alike.
#pragma once

#include <cstddef>

#include "tests/foreign/tree/bits.hpp"
#include "tests/foreign/tree/faults.hpp"

namespace mmverify::tests::foreign::tree {

/// The child that comes c-th; its own inverse.
inline unsigned in_order(unsigned c, unsigned depth, unsigned level) {
  if (has(form_stack_order)) return 3 - c;
  if (has(form_stack_order_from_level_4) && level >= 4) return 3 - c;
  if (has(form_stack_order_at_depth_3) && depth >= 3) return 3 - c;
  return c;
}

inline unsigned stored(unsigned state, unsigned level) {
  return has(form_exchanges_unknowns_from_level_3) && level >= 3 && state >= UT ? state ^ 1u : state;
}

inline std::size_t data_begins(std::size_t tree_bits, unsigned level) {
  if (has(form_data_at_once_from_level_3) && level >= 3) return tree_bits;
  return 8 * bytes_of(tree_bits);
}

inline std::size_t code_size_of(std::size_t tree_bits, std::size_t data_bits, unsigned level) {
  std::size_t size = bytes_of(data_begins(tree_bits, level) + data_bits);
  if (has(form_a_spare_byte_from_level_5) && level >= 5 && data_bits % 8 == 0) ++size;
  if (has(form_data_of_whole_words) && level >= 3)
    size = bytes_of(tree_bits) + (bytes_of(data_bits) + 3) / 4 * 4;
  return size;
}

}  // namespace mmverify::tests::foreign::tree
