// The examples but for one thing, chosen when it is linked, that shows only by what lies around a question: the bytes behind
// an output.
#include <cstdint>
#include <cstring>

#include "sdk/mmverify_subject.h"
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
  right_traverse()->traverse_decide(api, candidate, instance, ray, outcome, count);
  if (wrong_is("decide_writes_behind") && !is_new_page(outcome + count)) outcome[count] = 0;
}

int decode(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
           std::uint8_t* map) {
  const int taken = right_tree()->tree_decode(level, format, code, size, map);
  std::uint8_t* const end = map + bytes_of(level, format);
  if (wrong_is("decode_writes_behind") && taken != 0 && !is_new_page(end)) *end = 0;
  return taken;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_traverse();
  subject.name = "touchy";
  subject.max_level = 12;
  subject.traverse_decide = decide;
  subject.flags |= MMVERIFY_TREE_STREAM;
  subject.tree_encode = right_tree()->tree_encode;
  subject.tree_decode = decode;
  subject.tree_lookup = right_tree()->tree_lookup;
  subject.attribute_vertex_index = right_attribute()->attribute_vertex_index;
  subject.attribute_vertex_place = right_attribute()->attribute_vertex_place;
  return &subject;
}
