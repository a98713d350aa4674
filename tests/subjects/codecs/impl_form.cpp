// The library's own form for random access, and its container of a map, as a subject: their sources, word for word, in one
// file, as they are for processors without vectors.  CONTAINER: a code is a container; else it is a form.
#define _GLIBCXX_EXTERN_TEMPLATE 0
#define HWY_COMPILE_ONLY_SCALAR
#ifdef CONTAINER
#include "impl/tree/container.cpp"
#else
#include "impl/tree/lookup.cpp"
// The others have a namespace within lookup.cpp's.
#include "impl/tree/encode.cpp"
#include "impl/tree/expand.cpp"
#include "impl/tree/expand_flat.cpp"
#endif
#include "impl/tree/pyramid.cpp"
#include "impl/tree/recursion.cpp"
#include "impl/tree/stream.cpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

using namespace mmverify::impl::tree;

std::size_t map_bytes(uint32_t level, uint32_t format) {
  return static_cast<std::size_t>(((std::uint64_t{format} << 2 * level) + 7) / 8);
}

size_t put(const std::uint8_t* bytes, std::size_t size, uint8_t* code, size_t capacity) {
  if (size <= capacity) std::memcpy(code, bytes, size);
  return size;
}

#ifdef CONTAINER

size_t encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code, size_t capacity) {
  const auto bytes = write(level, static_cast<Format>(format), {map, map_bytes(level, format)});
  return put(bytes.data(), bytes.size(), code, capacity);
}
int decode(uint32_t level, uint32_t format, const uint8_t* code, size_t size, uint8_t* map) {
  const auto read = try_read({code, size});
  if (!read || read->level != level || static_cast<uint32_t>(read->format) != format) return 0;
  std::memcpy(map, read->map.data(), read->map.size());
  return 1;
}

#else

size_t encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code, size_t capacity) {
  const std::span<const std::uint8_t> states(map, map_bytes(level, format));
  const auto form = mmverify::impl::tree::detail::encode_form(level, static_cast<Format>(format), states, {});
  return put(form.get(), mmverify::impl::tree::detail::Layout::of(form.get()).size(), code, capacity);
}
int decode(uint32_t level, uint32_t format, const uint8_t* code, size_t, uint8_t* map) {
  mmverify::impl::tree::detail::decode_form(code, {map, map_bytes(level, format)});
  return 1;
}
void lookup(uint32_t, uint32_t, const uint8_t* code, size_t, const uint32_t* index, uint8_t* state,
            size_t count) {
  mmverify::impl::tree::detail::find_each(code, index, state, count);
}

#endif

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own forms of a tree";
  subject.max_level = 12;
  subject.tree_encode = encode;
  subject.tree_decode = decode;
#ifndef CONTAINER
  subject.tree_lookup = lookup;
#endif
  return &subject;
}
