// A code of our own, which holds the map as it is wherever the paper's is no shorter.
#include <algorithm>

#include "tests/foreign/tree/code.hpp"
#include "tests/foreign/tree/faults.hpp"

namespace mmverify::tests::foreign::tree {

Bytes private_code(unsigned level, unsigned bits, const std::uint8_t* map) {
  const std::size_t flat = bytes_of(states_of(level) * bits);
  Bytes code{1};
  const Bytes tree = stream(level, bits, map);
  if (tree.size() < flat || level == 0) {
    code.insert(code.end(), tree.begin(), tree.end());
    return code;
  }
  code[0] = 0;
  code.insert(code.end(), map, map + flat);
  return code;
}

int decode_private(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size,
                   std::uint8_t* map) {
  const std::size_t flat = bytes_of(states_of(level) * bits);
  Bytes got(flat);
  if (size == 0) return 0;
  if (code[0] == 0) {
    if (size < flat + 1) return 0;
    if (size > flat + 1 && !(has(private_takes_longer_flat_from_level_3) && level >= 3)) return 0;
    got.assign(code + 1, code + 1 + flat);
  } else if (decode_stream(level, bits, code + 1, size - 1, got.data()) == 0) {
    return 0;
  }
  const Bytes again = private_code(level, bits, got.data());
  bool same = again.size() == size && std::equal(again.begin(), again.end(), code);
  if (has(private_takes_any_first_byte) && code[0] != 0) same = true;
  if (has(private_takes_flat_where_a_tree_is_due) && code[0] == 0) same = true;
  if (has(private_takes_a_tree_where_flat_is_due) && code[0] == 1) same = true;
  if (has(private_takes_longer_flat_from_level_3) && code[0] == 0 && level >= 3) same = true;
  if (!same) return 0;
  std::copy(got.begin(), got.end(), map);
  return 1;
}

}  // namespace mmverify::tests::foreign::tree
