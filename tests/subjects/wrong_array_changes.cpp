// The example of changes of arrays but for one thing, chosen when it is linked.
#include <cstddef>
#include <cstring>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_array_changes(void);

namespace {

mmverify_array_parts_t head_of(const std::uint8_t* array) {
  mmverify_array_parts_t head;
  std::memcpy(&head, array, sizeof head);
  return head;
}
std::uint8_t* geometry(std::uint8_t* array, std::size_t g) {
  return array + sizeof(mmverify_array_parts_t) + g * sizeof(mmverify_array_geometry_t);
}
std::uint32_t word_at(const std::uint8_t* at) {
  std::uint32_t word = 0;
  std::memcpy(&word, at, sizeof word);
  return word;
}
/// Whether a record of the array has a level of 2 or more.
bool has_level_2(const std::uint8_t* array) {
  const mmverify_array_parts_t head = head_of(array);
  const std::uint8_t* const records =
      array + sizeof head + head.geometries * sizeof(mmverify_array_geometry_t);
  for (std::uint32_t r = 0; r < head.records; ++r)
    if ((word_at(records + 8 * r + 4) & 0xffff) >= 2) return true;
  return false;
}
/// An array of nothing.
std::size_t empty(std::uint8_t* changed, std::size_t capacity) {
  if (capacity >= sizeof(mmverify_array_parts_t)) std::memset(changed, 0, sizeof(mmverify_array_parts_t));
  return sizeof(mmverify_array_parts_t);
}
/// Whether each record has a format, and each plain index of the first geometry, whose indices have 32 bits, a record.
bool is_array(const std::uint8_t* array) {
  const mmverify_array_parts_t head = head_of(array);
  const std::uint8_t* const records =
      array + sizeof head + head.geometries * sizeof(mmverify_array_geometry_t);
  for (std::uint32_t r = 0; r < head.records; ++r)
    if (const std::uint32_t kind = word_at(records + 8 * r + 4);
        (kind & 0xffff) > 12 || kind >> 16 == 0 || kind >> 16 > 2)
      return false;
  if (head.geometries == 0 || word_at(array + sizeof head) != MMVERIFY_INDEX_U32) return true;
  const std::uint32_t base = word_at(array + sizeof head + 4), triangles = word_at(array + sizeof head + 8);
  for (std::uint32_t t = 0; t < triangles; ++t)
    if (const std::uint32_t code = word_at(records + 8 * head.records + 4 * t);
        code < 0xfffffffc && std::uint64_t{code} + base >= head.records)
      return false;
  return true;
}
constexpr std::size_t base_at = offsetof(mmverify_array_geometry_t, base_triangle);

std::size_t compact(const std::uint8_t* array, std::size_t array_size, std::uint8_t* changed,
                    std::size_t capacity) {
  if (wrong_is("compact_drops_nothing"))
    return right_array_changes()->array_reorder(array, array_size, changed, capacity);
  if (wrong_is("compact_refuses")) return 0;
  if (wrong_is("compact_empties_level_2") && has_level_2(array)) return empty(changed, capacity);
  const std::size_t size = right_array_changes()->array_compact(array, array_size, changed, capacity);
  if (wrong_is("compact_keeps_the_base") && size <= capacity)
    std::memcpy(geometry(changed, 0) + base_at, array + sizeof(mmverify_array_parts_t) + base_at, 4);
  if (wrong_is("compact_overruns") && size <= capacity && head_of(array).records == 3) changed[size] = 1;
  return size;
}

std::size_t reorder(const std::uint8_t* array, std::size_t array_size, std::uint8_t* changed,
                    std::size_t capacity) {
  if (wrong_is("reorder_empties_level_2") && has_level_2(array)) return empty(changed, capacity);
  // The third of three geometries is taken for the second.
  if (wrong_is("reorder_forgets_the_third") && head_of(array).geometries == 3) {
    std::vector<std::uint8_t> other(array, array + array_size);
    std::memcpy(geometry(other.data(), 2) + base_at, geometry(other.data(), 1) + base_at, 4);
    return right_array_changes()->array_reorder(other.data(), array_size, changed, capacity);
  }
  if (!wrong_is("reorder_does_nothing"))
    return right_array_changes()->array_reorder(array, array_size, changed, capacity);
  if (array_size <= capacity) std::memcpy(changed, array, array_size);
  return array_size;
}

std::size_t concatenate(const std::uint8_t* arrays, std::size_t arrays_size, std::uint8_t* changed,
                        std::size_t capacity) {
  if (wrong_is("concatenate_empties_level_2") && has_level_2(arrays)) return empty(changed, capacity);
  const std::size_t size = right_array_changes()->array_concatenate(arrays, arrays_size, changed, capacity);
  if (size > capacity) return size;
  const mmverify_array_parts_t first = head_of(arrays);
  if (wrong_is("concatenate_leaves_the_base")) {
    std::uint8_t* const base = geometry(changed, first.geometries) + base_at;
    const std::uint32_t as_it_was = word_at(base) - first.records;
    std::memcpy(base, &as_it_was, sizeof as_it_was);
  }
  if (wrong_is("concatenate_leaves_the_offsets")) {
    const mmverify_array_parts_t both = head_of(changed);
    std::uint8_t* const records = geometry(changed, both.geometries);
    for (std::uint32_t r = first.records; r < both.records; ++r) {
      const std::uint32_t as_it_was = word_at(records + 8 * r) - first.data_bytes;
      std::memcpy(records + 8 * r, &as_it_was, sizeof as_it_was);
    }
  }
  return size;
}

std::size_t load(const std::uint8_t* file, std::size_t file_size, std::uint8_t* array, std::size_t capacity) {
  const auto real = right_array_changes()->array_load;
  if (wrong_is("load_lets_bytes_behind_pass")) {
    const std::size_t size = real(file, file_size, array, capacity);
    return size != 0 || file_size == 0 ? size : real(file, file_size - 1, array, capacity);
  }
  const std::size_t size = real(file, file_size, array, capacity);
  // Whatever room there is.
  std::vector<std::uint8_t> loaded(size);
  real(file, file_size, loaded.data(), size);
  if (size != 0 && wrong_is("load_refuses_level_2") && has_level_2(loaded.data())) return 0;
  if (size != 0 && wrong_is("load_refuses_no_array") && !is_array(loaded.data())) return 0;
  if (wrong_is("load_forgets_signs") && size != 0 && size <= capacity)
    for (std::size_t g = 0; g < head_of(array).geometries; ++g)
      if (word_at(geometry(array, g)) == MMVERIFY_INDEX_I16) {
        constexpr std::uint32_t unsigned_one = MMVERIFY_INDEX_U16;
        std::memcpy(geometry(array, g), &unsigned_one, sizeof unsigned_one);
      }
  return size;
}

std::size_t emulate(std::uint32_t level, std::uint32_t most, const std::uint8_t* map, std::uint8_t* emulated,
                    std::size_t capacity) {
  const std::size_t size = right_array_changes()->array_emulate(level, most, map, emulated, capacity);
  // O wins where there is more of it.
  if (wrong_is("emulate_by_majority") && level == 1 && map[0] == 0x54 && capacity > 0) emulated[0] = 1;
  return size;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_array_changes();
  subject.array_compact = compact;
  subject.array_reorder = reorder;
  subject.array_concatenate = concatenate;
  subject.array_load = load;
  subject.array_emulate = emulate;
  if (wrong_is("saves_alone")) {
    subject.array_load = nullptr;
    subject.array_compact = nullptr;
  }
  return &subject;
}
