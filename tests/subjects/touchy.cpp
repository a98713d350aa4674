// The examples but for one thing, chosen when it is linked, that shows only by what lies around a question: the bytes behind
// an output and those that it holds already, how much room is there, where the code lies, which elements are neighbours, or
// what another thread asks.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_traverse(void);
extern "C" const mmverify_subject_t* right_tree(void);
extern "C" const mmverify_subject_t* right_attribute(void);

namespace {

bool is_new_page(const std::uint8_t* at) { return reinterpret_cast<std::uintptr_t>(at) % 4096 == 0; }

std::size_t bytes_of(std::uint32_t level, std::uint32_t format) {
  return ((std::size_t{format} << 2 * level) + 7) / 8;
}

void decide(std::uint32_t api, const std::uint32_t* candidate, const std::uint32_t* instance,
            const std::uint32_t* ray, std::uint8_t* outcome, std::size_t count) {
  const std::uint8_t ends[] = {outcome[0], outcome[count - 1]};
  const bool answered = count > 2 && outcome[count / 2] < 3;
  const std::vector<std::uint8_t> before(outcome, outcome + count);
  right_traverse()->traverse_decide(api, candidate, instance, ray, outcome, count);
  if (wrong_is("decide_keeps_answers") && answered && ends[0] == outcome[0] && ends[1] == outcome[count - 1])
    std::copy(before.begin(), before.end(), outcome);
  std::size_t run = 0;
  for (std::size_t k = 1; wrong_is("decide_runs_of_256") && k < count; ++k) {
    const bool same =
        candidate[k] == candidate[k - 1] && instance[k] == instance[k - 1] && ray[k] == ray[k - 1];
    run = same ? run + 1 : 0;
    if (run >= 256) outcome[k] ^= 1;
  }
  if (wrong_is("decide_writes_behind") && !is_new_page(outcome + count)) outcome[count] = 0;
}

std::size_t encode(std::uint32_t level, std::uint32_t format, const std::uint8_t* map, std::uint8_t* code,
                   std::size_t capacity) {
  const std::vector<std::uint8_t> before(code, code + std::min<std::size_t>(capacity, 8));
  const std::size_t size = right_tree()->tree_encode(level, format, map, code, capacity);
  if (wrong_is("encode_adds_to_zero") && size <= before.size() && before[0] == 0)
    for (std::size_t k = 0; k < size; ++k) code[k] |= before[k];
  if (wrong_is("encode_ends_in_a_word") && capacity > size && capacity < size + 8) code[size - 1] ^= 1;
  return wrong_is("encode_asks_for_twice") && capacity != 0 && capacity < size / 2 ? 2 * capacity : size;
}

int decode(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
           std::uint8_t* map) {
  const int taken = right_tree()->tree_decode(level, format, code, size, map);
  std::uint8_t* const end = map + bytes_of(level, format);
  const auto at = reinterpret_cast<std::uintptr_t>(code) % 16;
  if (wrong_is("decode_at_13") && taken != 0 && size == 2 && code[1] != 0 && at == 13) map[0] ^= 1;
  if (wrong_is("decode_writes_behind") && taken != 0 && !is_new_page(end)) *end = 0;
  return taken;
}

void look_up(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
             const std::uint32_t* index, std::uint8_t* state, std::size_t count) {
  static volatile std::uint32_t shared;
  shared = level;
  for (std::size_t k = 0; k < count; ++k) {
    if (wrong_is("lookup_shares_level")) level = shared;
    right_tree()->tree_lookup(level, format, code, size, index + k, state + k, 1);
  }
}

void place(std::uint32_t level, std::uint32_t order, const std::uint32_t* index, std::uint32_t* at,
           std::size_t count) {
  static volatile std::uint32_t shared;
  shared = order;
  for (std::size_t k = 0; k < count; ++k) {
    if (wrong_is("place_shares_order")) order = shared;
    const std::uint32_t before[] = {at[2 * k], at[2 * k + 1]};
    right_attribute()->attribute_vertex_place(level, order, index + k, at + 2 * k, 1);
    if (wrong_is("place_keeps_j") && before[0] == at[2 * k] && before[1] <= 1u << level)
      at[2 * k + 1] = before[1];
  }
  // A gather that is taken for one with a stride.
  for (const auto& [thing, step] : {std::pair{"place_descending", ~0u}, {"place_by_twos", 2u}})
    for (std::size_t k = 4; wrong_is(thing) && k < count; ++k)
      if (index[k] == index[k - 1] + step && index[k] == index[k - 4] + 4 * step) at[2 * k] ^= 1;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_traverse();
  subject.name = "touchy";
  subject.max_level = 12;
  subject.traverse_decide = decide;
  subject.flags |= MMVERIFY_TREE_STREAM;
  subject.tree_encode = encode;
  subject.tree_decode = decode;
  subject.tree_lookup = look_up;
  subject.attribute_vertex_index = right_attribute()->attribute_vertex_index;
  subject.attribute_vertex_place = place;
  return &subject;
}
