// The library's own codec of the paper's two sequences as a subject: its sources, word for word, in one file.
#define HWY_COMPILE_ONLY_SCALAR
#include <algorithm>

#include "impl/tree/pyramid.cpp"
#include "impl/tree/recursion.cpp"
#include "impl/tree/stream.cpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

using namespace mmverify::impl::tree;

std::size_t bytes_of(std::uint64_t bits) { return static_cast<std::size_t>((bits + 7) / 8); }
std::span<const std::uint8_t> map_of(uint32_t level, uint32_t format, const uint8_t* map) {
  return {map, bytes_of(std::uint64_t{format} << 2 * level)};
}

/// The sequences of a code: nodes in the first one, and its bytes.
struct Sequences {
  std::uint64_t nodes = 0;  ///< 0: no code has that length
  std::span<const std::uint8_t> tree, data;
};

Sequences sequences_of(uint32_t format, const uint8_t* code, size_t size) {
  detail::Place end;
  if (!detail::pass_subtrees(code, 8 * size, 1, end)) return {};
  const std::size_t tree = bytes_of(end.node);
  if (size != tree + bytes_of(end.leaf * format)) return {};
  return {end.node, {code, tree}, {code + tree, size - tree}};
}

size_t encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code, size_t capacity) {
  const Stream s = encode_stream(level, static_cast<Format>(format), map_of(level, format, map));
  const size_t size = s.tree.size() + s.data.size();
  if (capacity < size) return size;
  std::copy(s.data.begin(), s.data.end(), std::copy(s.tree.begin(), s.tree.end(), code));
  return size;
}

int decode(uint32_t level, uint32_t format, const uint8_t* code, size_t size, uint8_t* map) {
  const Sequences s = sequences_of(format, code, size);
  if (s.nodes == 0) return 0;
  const std::span<std::uint8_t> states(map, map_of(level, format, map).size());
  return detail::decode(level, static_cast<Format>(format), s.tree, s.nodes, s.data, s.nodes - s.nodes / 4,
                        states)
             ? 0
             : 1;
}

void lookup(uint32_t level, uint32_t format, const uint8_t* code, size_t size, const uint32_t* index,
            uint8_t* state, size_t count) {
  const Sequences s = sequences_of(format, code, size);
  for (size_t k = 0; k < count; ++k)
    state[k] = detail::lookup(level, static_cast<Format>(format), s.tree, s.nodes, s.data, index[k]);
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own streams";
  subject.max_level = 12;
  subject.flags = MMVERIFY_TREE_STREAM;
  subject.tree_encode = encode;
  subject.tree_decode = decode;
  subject.tree_lookup = lookup;
  return &subject;
}
