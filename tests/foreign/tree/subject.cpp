// Succinct trees of opacity micromaps, written from the paper (Algorithms 1 to 3), the header and Vulkan's rule of
// ties alone.  Each fault of the table is one slip inside this code.
//
// MMVERIFY_FOREIGN_TREE chooses what of it is handed over, none of it wrong: nothing, the paper's two bit sequences
// and all four entry points; "private", a code of our own without the flag; "encode", "decode", "lookup" and "point",
// the paper's sequences and one entry point alone.
#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/tree/code.hpp"
#include "tests/foreign/tree/faults.hpp"
#include "tests/foreign/tree/lookup.hpp"
#include "tests/foreign/tree/point.hpp"

namespace mmverify::tests::foreign::tree {
namespace {

const std::string_view variant = [] {
  const char* name = std::getenv("MMVERIFY_FOREIGN_TREE");
  return std::string_view(name == nullptr ? "" : name);
}();

/// A fault of the private form asks for it.
bool is_private() {
  return variant == "private" || has(private_takes_any_first_byte) ||
         has(private_takes_flat_where_a_tree_is_due) || has(private_takes_a_tree_where_flat_is_due) ||
         has(private_takes_longer_flat_from_level_3);
}

std::size_t tree_encode(std::uint32_t level, std::uint32_t format, const std::uint8_t* map,
                        std::uint8_t* code, std::size_t capacity) {
  const Bytes found = is_private() ? private_code(level, format, map) : stream(level, format, map);
  const std::size_t size = found.size();
  if (has(encode_gives_up_at_level_11) && level >= 11) return 0;
  bool fits = capacity >= size;
  if (has(encode_wants_a_byte_to_spare)) fits = capacity > size;
  if (has(encode_wants_a_byte_to_spare_from_level_3)) fits = capacity >= size + (level >= 3 ? 1 : 0);
  if (has(encode_writes_one_byte_too_many)) fits = capacity + 1 >= size;
  if (!fits && has(encode_says_what_fitted)) return std::max<std::size_t>(capacity, 1);
  if (!fits && has(encode_says_a_bound_without_room)) return size + 1;
  if (!fits && has(encode_says_nothing_without_room) && capacity == 0) return 0;
  if (!fits) return size;
  for (std::size_t k = 0; k < size; ++k)
    code[k] = has(encode_leaves_old_bits) ? static_cast<std::uint8_t>(code[k] | found[k]) : found[k];
  return size;
}

int tree_decode(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
                std::uint8_t* map) {
  return is_private() ? decode_private(level, format, code, size, map)
                      : decode_stream(level, format, code, size, map);
}

/// A lookup in any of the two forms.
template <class IndexOf>
void look_up(unsigned level, unsigned bits, const std::uint8_t* code, std::size_t size, std::uint8_t* state,
             std::size_t count, bool by_point, IndexOf index) {
  if (is_private() && code[0] == 0) {
    for (std::size_t k = 0; k < count; ++k)
      state[k] = static_cast<std::uint8_t>(bits_at(code + 1, std::size_t{index(k)} * bits, bits));
    return;
  }
  const Tree& tree =
      is_private() ? tree_of(level, bits, code + 1, size - 1) : tree_of(level, bits, code, size);
  for (std::size_t k = 0; k < count; ++k)
    state[k] = static_cast<std::uint8_t>(looked_up(tree, index(k), by_point));
  if (has(lookup_rest_of_a_batch) && count > 64 && count % 64 != 0) state[count - 1] = state[0];
}

void tree_lookup(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
                 const std::uint32_t* index, std::uint8_t* state, std::size_t count) {
  look_up(level, format, code, size, state, count, false, [&](std::size_t k) { return index[k]; });
}

void tree_lookup_f32(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
                     const float* u, const float* v, std::uint8_t* state, std::size_t count) {
  look_up(level, format, code, size, state, count, true, [&](std::size_t k) {
    if (has(point_exchanges_axes)) return index_of(level, v[k], u[k]);
    return index_of(level, u[k], v[k]);
  });
}

mmverify_subject_t make() {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "foreign tree";
  s.max_level = 12;
  s.flags = threading() | (is_private() ? 0u : MMVERIFY_TREE_STREAM);
  const bool all = variant.empty() || is_private();
  if (all || variant == "encode") s.tree_encode = tree_encode;
  if (all || variant == "decode") s.tree_decode = tree_decode;
  if (all || variant == "lookup") s.tree_lookup = tree_lookup;
  if (all || variant == "point") s.tree_lookup_f32 = tree_lookup_f32;
  return s;
}

const mmverify_subject_t subject = make();

}  // namespace
}  // namespace mmverify::tests::foreign::tree

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  using namespace mmverify::tests::foreign::tree;
  return fault ? &subject : nullptr;
}
