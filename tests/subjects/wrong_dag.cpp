// The example of topic dag but for one thing, chosen when it is linked.
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_dag(void);

namespace {

volatile int* volatile nowhere = nullptr;
using Bytes = std::vector<std::uint8_t>;

std::size_t map_bytes(std::uint32_t level, std::uint32_t bits) {
  return ((std::size_t{bits} << 2 * level) + 7) / 8;
}

/// Two maps that differ in their last byte alone are taken for one.
Bytes near_merged(std::uint32_t bits, Bytes scene) {
  const std::size_t bytes = map_bytes(scene[0], bits), second = 1 + bytes;
  if (second < scene.size() && scene[second] == scene[0] && bytes > 1 &&
      std::memcmp(&scene[1], &scene[second + 1], bytes - 1) == 0)
    std::memcpy(&scene[second + 1], &scene[1], bytes);
  return scene;
}

std::size_t encode(std::uint32_t bits, const std::uint8_t* scene, std::size_t size, std::uint8_t* code,
                   std::size_t capacity) {
  Bytes changed(scene, scene + size);
  if (wrong_is("merges_near")) changed = near_merged(bits, changed);
  if (wrong_is("forgets_the_second")) changed.resize(1 + map_bytes(scene[0], bits));
  if (wrong_is("encoder_throws") && scene[0] == 3) throw std::runtime_error("level 3");
  static volatile unsigned calls = 0;
  const std::size_t all = right_dag()->dag_encode(bits, changed.data(), changed.size(), code, capacity);
  calls = calls + 1;
  if (wrong_is("encoder_counts_calls") && capacity >= all && calls % 5 == 4) code[all - 1] ^= 1;
  return all;
}

std::size_t decode(std::uint32_t bits, const std::uint8_t* code, std::size_t code_size, std::uint8_t* scene,
                   std::size_t capacity) {
  // The decoder reads on as if the code were whole.
  if (wrong_is("decoder_reads_past_its_code") && code_size < 4) *nowhere = 1;
  const std::size_t all = right_dag()->dag_decode(bits, code, code_size, scene, capacity);
  if (wrong_is("answers_no_scene") && all == 0 && code_size != 0) {
    if (capacity != 0) scene[0] = 13;
    return 1;
  }
  static volatile std::size_t last = 0;
  if (wrong_is("answers_by_the_last_code") && all == 0 && capacity > 1 && code_size < last) {
    scene[0] = scene[1] = 0;
    return 2;
  }
  last = code_size;
  if (wrong_is("padding_set") && bits == 1 && all != 0 && capacity >= all && scene[0] == 0) scene[1] |= 2;
  return all;
}

void lookup(std::uint32_t bits, const std::uint8_t* code, std::size_t code_size, const std::uint32_t* map,
            const std::uint32_t* index, std::uint8_t* state, std::size_t count) {
  right_dag()->dag_lookup(bits, code, code_size, map, index, state, count);
  for (std::size_t k = 0; k < count; ++k) {
    if (wrong_is("looks_in_the_first") && map[k] == 1) {
      const std::uint32_t first = 0;
      right_dag()->dag_lookup(bits, code, code_size, &first, index + k, state + k, 1);
    }
    const bool other = (wrong_is("looks_for_257_in_the_first") && map[k] == 256) ||
                       (wrong_is("numbers_of_16_bits") && map[k] >= 65536);
    if (other) {
      const std::uint32_t taken = map[k] == 256 ? 0 : map[k] - 65536;
      right_dag()->dag_lookup(bits, code, code_size, &taken, index + k, state + k, 1);
    }
    if (wrong_is("lookup_crashes") && index[k] == 255) *nowhere = 1;
  }
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = [] {
    mmverify_subject_t s = *right_dag();
    s.dag_encode = encode;
    s.dag_decode = decode;
    s.dag_lookup = lookup;
    if (wrong_is("decodes_only")) s.dag_encode = nullptr;
    if (wrong_is("encodes_only")) s.dag_decode = nullptr, s.dag_lookup = nullptr;
    if (wrong_is("looks_up_only")) s.dag_decode = nullptr;
    if (wrong_is("promises_the_container")) s.flags |= MMVERIFY_DAG_CONTAINER;
    if (wrong_is("old_header")) s.size = offsetof(mmverify_subject_t, dag_encode);
    return s;
  }();
  return &subject;
}
