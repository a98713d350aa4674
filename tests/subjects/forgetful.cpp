// The examples but for one thing, chosen when it is linked: an answer that is kept without one argument of its question, an
// answer behind a vector's last whole one, and one that its neighbour changes.
#include <cstring>
#include <utility>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_traverse(void);
extern "C" const mmverify_subject_t* right_tree(void);
extern "C" const mmverify_subject_t* right_attribute(void);

namespace {

void decide(std::uint32_t api, const std::uint32_t* candidate, const std::uint32_t* instance,
            const std::uint32_t* ray, std::uint8_t* outcome, std::size_t count) {
  static thread_local std::uint32_t key = ~0u;
  static thread_local std::uint8_t kept = 0;
  const auto right = right_traverse()->traverse_decide;
  right(api, candidate, instance, ray, outcome, count);
  if (wrong_is("decide_tail_of_16") && count % 16 >= 9 && count % 16 <= 12) outcome[count - count % 16] ^= 1;
  for (std::size_t k = 0; wrong_is("decide_without_flag_1024") && k < count; ++k) {
    const std::uint32_t mine = candidate[k] | instance[k] << 4 | (ray[k] & 255) << 12 | api << 24;
    if (std::exchange(key, mine) != mine) kept = outcome[k];
    outcome[k] = kept;
  }
}

void blend(std::uint32_t operation, const std::uint32_t* payload, const std::uint32_t* value,
           std::uint32_t* out, std::size_t count) {
  static thread_local std::uint32_t kept[3] = {}, full = 0;
  right_traverse()->traverse_blend(operation, payload, value, out, count);
  for (std::size_t k = 0; wrong_is("blend_without_operation") && k < count; ++k) {
    if (full == 0 || kept[0] != payload[k] || kept[1] != value[k])
      full = 1, kept[0] = payload[k], kept[1] = value[k], kept[2] = out[k];
    out[k] = kept[2];
  }
}

/// The last code, or map, without its format.
struct Kept {
  std::uint32_t level = ~0u;
  std::vector<std::uint8_t> question, answer;
  std::size_t size = 0;
  bool is_of(std::uint32_t l, const std::uint8_t* bytes, std::size_t count) const {
    return level == l && question.size() == count && std::memcmp(question.data(), bytes, count) == 0;
  }
};

std::size_t bytes_of(std::uint32_t level, std::uint32_t format) {
  return ((std::size_t{format} << 2 * level) + 7) / 8;
}

std::size_t encode(std::uint32_t level, std::uint32_t format, const std::uint8_t* map, std::uint8_t* code,
                   std::size_t capacity) {
  static thread_local Kept last;
  const std::size_t bytes = bytes_of(level, format);
  if (!wrong_is("encode_without_format") || level > 2)
    return right_tree()->tree_encode(level, format, map, code, capacity);
  if (!last.is_of(level, map, bytes)) {
    last = {level, {map, map + bytes}, std::vector<std::uint8_t>(128), 0};
    last.size = right_tree()->tree_encode(level, format, map, last.answer.data(), last.answer.size());
  }
  if (last.size <= capacity) std::memcpy(code, last.answer.data(), last.size);
  return last.size;
}

int decode(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
           std::uint8_t* map) {
  static thread_local Kept last;
  if (!wrong_is("decode_without_format") || level > 2)
    return right_tree()->tree_decode(level, format, code, size, map);
  if (!last.is_of(level, code, size)) {
    last = {level, {code, code + size}, std::vector<std::uint8_t>(16), 0};
    last.size = right_tree()->tree_decode(level, format, code, size, last.answer.data()) != 0 ? 1 : 0;
  }
  if (last.size != 0) std::memcpy(map, last.answer.data(), bytes_of(level, format));
  return last.size != 0;
}

void look_up(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
             const std::uint32_t* index, std::uint8_t* state, std::size_t count) {
  static thread_local Kept last;
  right_tree()->tree_lookup(level, format, code, size, index, state, count);
  if (wrong_is("lookup_tail_of_16") && count % 16 >= 9 && count % 16 <= 12) state[count - 1] ^= 1;
  if (!wrong_is("lookup_without_format") || level > 2) return;
  if (!last.is_of(level, code, size)) {
    last = {level, {code, code + size}, std::vector<std::uint8_t>(16), 0};
    for (std::uint32_t k = 0; k < 1u << 2 * level; ++k)
      right_tree()->tree_lookup(level, format, code, size, &k, &last.answer[k], 1);
  }
  for (std::size_t k = 0; k < count; ++k) state[k] = last.answer[index[k]];
}

void vertex_index(std::uint32_t level, std::uint32_t order, const std::uint32_t* i, const std::uint32_t* j,
                  std::uint32_t* index, std::size_t count) {
  static thread_local std::uint32_t kept[4] = {~0u};
  right_attribute()->attribute_vertex_index(level, order, i, j, index, count);
  for (std::size_t k = 0; wrong_is("vertex_without_order") && k < count; ++k) {
    if (kept[0] != level || kept[1] != i[k] || kept[2] != j[k])
      kept[0] = level, kept[1] = i[k], kept[2] = j[k], kept[3] = index[k];
    index[k] = kept[3];
  }
}

void face_mip(std::uint32_t rounding, const std::uint8_t* children, std::size_t parents, std::uint8_t* out) {
  right_attribute()->attribute_face_mip(rounding, children, parents, out);
  if (wrong_is("mip_tail_of_4") && parents > 4 && parents % 4 == 2) out[4 * parents - 1] ^= 1;
  for (std::size_t k = 1; wrong_is("mip_after_13") && k < parents; ++k)
    if (children[16 * k] == 200 && children[16 * (k - 1)] == 13) out[4 * k] ^= 1;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_traverse();
  subject.name = "forgetful";
  subject.max_level = 12;
  subject.traverse_decide = decide;
  subject.traverse_blend = blend;
  subject.flags |= MMVERIFY_TREE_STREAM;
  subject.tree_encode = encode;
  subject.tree_decode = decode;
  subject.tree_lookup = look_up;
  subject.attribute_vertex_index = vertex_index;
  subject.attribute_face_mip = face_mip;
  return &subject;
}
