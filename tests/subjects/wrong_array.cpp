// The example of arrays but for one thing, chosen when it is linked: the bugs that builders of arrays have had.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_array(void);

namespace {

volatile int* volatile nowhere = nullptr;

std::size_t states_of(const mmverify_array_triangle_t& t) { return std::size_t{1} << (2 * t.level); }
std::size_t bytes_of(const mmverify_array_triangle_t& t) { return (states_of(t) * t.format + 7) / 8; }

unsigned state_at(const std::uint8_t* map, std::uint32_t format, std::size_t i) {
  return map[i * format / 8] >> (i * format % 8) & ((1u << format) - 1);
}
void set_state(std::uint8_t* map, std::uint32_t format, std::size_t i, unsigned state) {
  const std::size_t bit = i * format;
  map[bit / 8] =
      static_cast<std::uint8_t>((map[bit / 8] & ~(((1u << format) - 1) << bit % 8)) | state << bit % 8);
}

/// Another case: its own triangles and maps.
struct Changed {
  explicit Changed(const mmverify_array_case_t& what)
      : all(what), triangles(what.triangles, what.triangles + what.count) {
    for (mmverify_array_triangle_t& t : triangles) {
      const std::size_t at = maps.size();
      maps.insert(maps.end(), what.maps + t.map, what.maps + t.map + bytes_of(t));
      t.map = static_cast<std::uint32_t>(at);
    }
    point();
  }
  void point() {
    all.triangles = triangles.data();
    all.maps = maps.data();
  }
  mmverify_array_case_t all;
  std::vector<mmverify_array_triangle_t> triangles;
  std::vector<std::uint8_t> maps;
};

/// A triangle with one O where an earlier one has T becomes the earlier one.
void merge_known(Changed& c) {
  for (std::uint32_t k = c.all.before; k < c.all.count; ++k)
    for (std::uint32_t j = c.all.before; j < k; ++j) {
      const mmverify_array_triangle_t &a = c.triangles[j], &b = c.triangles[k];
      if (a.level != b.level || a.format != b.format) continue;
      std::size_t differences = 0, known = 0;
      for (std::size_t i = 0; i < states_of(a); ++i) {
        const unsigned x = state_at(&c.maps[a.map], a.format, i), y = state_at(&c.maps[b.map], a.format, i);
        differences += x != y ? 1 : 0;
        known += x == 0 && y == 1 ? 1 : 0;
      }
      if (differences == 1 && known == 1) std::memcpy(&c.maps[b.map], &c.maps[a.map], bytes_of(a));
    }
}

/// All maps in the format of the first triangle.
void one_format(Changed& c) {
  if (c.all.before == c.all.count) return;
  const std::uint32_t format = c.triangles[c.all.before].format;
  for (std::uint32_t k = c.all.before; k < c.all.count; ++k) {
    mmverify_array_triangle_t& t = c.triangles[k];
    const mmverify_array_triangle_t old = t;
    t.format = format;
    t.map = static_cast<std::uint32_t>(c.maps.size());
    c.maps.resize(c.maps.size() + bytes_of(t));
    for (std::size_t i = 0; i < states_of(t); ++i)
      set_state(&c.maps[t.map], format, i, state_at(&c.maps[old.map], old.format, i) & ((1u << format) - 1));
  }
}

/// Children 1 and 3 change places from level 2 on.
void turn_from_level_2(Changed& c) {
  for (std::uint32_t k = c.all.before; k < c.all.count; ++k) {
    const mmverify_array_triangle_t& t = c.triangles[k];
    if (t.level < 2) continue;
    for (std::size_t i = 0; i < states_of(t); i += 4) {
      const unsigned one = state_at(&c.maps[t.map], t.format, i + 1);
      set_state(&c.maps[t.map], t.format, i + 1, state_at(&c.maps[t.map], t.format, i + 3));
      set_state(&c.maps[t.map], t.format, i + 3, one);
    }
  }
}

/// If two triangles have one level and format, the earlier one gets the map that lies before the other.
void take_maps_in_a_row(Changed& c, const mmverify_array_case_t& what) {
  for (std::uint32_t k = 0; k < what.count; ++k)
    for (std::uint32_t j = 0; j < k; ++j) {
      const mmverify_array_triangle_t &a = what.triangles[j], &b = what.triangles[k];
      if (a.level != b.level || a.format != b.format || a.map < b.map) continue;
      std::swap_ranges(&c.maps[c.triangles[j].map], &c.maps[c.triangles[j].map] + bytes_of(a),
                       &c.maps[c.triangles[k].map]);
    }
}

/// Whether each map lies behind the one before.
bool ascend(const mmverify_array_case_t& what) {
  for (std::uint32_t k = 1; k < what.count; ++k)
    if (what.triangles[k].map <= what.triangles[k - 1].map) return false;
  return true;
}

std::size_t build(const mmverify_array_case_t* what, std::uint8_t* answer, std::size_t capacity) {
  Changed c(*what);
  if (wrong_is("takes_maps_in_a_row")) take_maps_in_a_row(c, *what);
  if (wrong_is("wants_ascending_maps") && !ascend(*what)) return 0;
  if (wrong_is("merges_known")) merge_known(c);
  if (wrong_is("one_format")) one_format(c);
  if (wrong_is("order_from_level_2")) turn_from_level_2(c);
  c.point();
  const bool two = what->count == what->before + 2;
  if (two && wrong_is("crash")) *nowhere = 1;
  if (two && wrong_is("throws")) throw std::runtime_error("no second triangle");
  if (wrong_is("refuses_two") && two) return 0;
  std::size_t size = right_array()->array_build(&c.all, answer, capacity);
  if (wrong_is("overrun") && two && size <= capacity) answer[size] = 1;
  if (size == 0 || size > capacity) return size;
  mmverify_array_answer_t head;
  std::memcpy(&head, answer, sizeof head);
  std::uint8_t* const counts = answer + sizeof head + 8 * head.records;
  std::uint8_t* const indices = counts + 12 * (head.array_counts + head.geometry_counts);
  // The geometry's counts are those of the array.
  if (wrong_is("one_histogram") && head.geometry_counts == head.array_counts)
    std::memcpy(counts + 12 * head.array_counts, counts, 12 * head.array_counts);
  // The base triangle is added to whatever there is.
  const std::uint32_t width =
      head.index_bytes / (what->count - what->before == 0 ? 1 : what->count - what->before);
  if (wrong_is("base_on_special"))
    for (std::uint32_t t = 0; t < what->count - what->before; ++t) {
      std::uint32_t code = 0;
      std::memcpy(&code, indices + t * width, width);
      if (code >= (0xffffffffu >> (32 - 8 * width)) - 3) code += what->base_triangle;
      std::memcpy(indices + t * width, &code, width);
    }
  if (wrong_is("says_more_bytes")) {
    ++head.data_bytes;
    std::memcpy(answer, &head, sizeof head);
  }
  static volatile int calls = 0;
  if (wrong_is("counts_calls") && two) {
    calls = calls + 1;
    if (calls > 1) indices[0] ^= 1;
  }
  return size;
}

void resolve(std::uint32_t index_type, const std::uint32_t* code, const std::uint32_t* base,
             const std::uint32_t* records, std::uint32_t* target, std::size_t count) {
  const std::vector<std::uint32_t> first_base(count, count == 0 ? 0 : base[0]);
  if (wrong_is("one_base_a_batch")) base = first_base.data();
  right_array()->array_resolve(index_type, code, base, records, target, count);
  for (std::size_t k = 0; k < count; ++k) {
    if (wrong_is("less_or_equal") && target[2 * k] == MMVERIFY_TARGET_OUTSIDE &&
        std::uint64_t{code[k]} + base[k] == records[k] && index_type < MMVERIFY_INDEX_I16) {
      target[2 * k] = MMVERIFY_TARGET_RECORD;
      target[2 * k + 1] = records[k];
    }
    if (wrong_is("minus_5_everywhere") && code[k] == 0xfffffffb && index_type == MMVERIFY_INDEX_U32) {
      target[2 * k] = MMVERIFY_TARGET_NONE;
      target[2 * k + 1] = 0;
    }
    if (wrong_is("state_4") && target[2 * k] == MMVERIFY_TARGET_SPECIAL) target[2 * k + 1] = 4;
  }
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_array();
  subject.array_build = build;
  subject.array_resolve = resolve;
  if (wrong_is("resolves_only")) subject.array_build = nullptr;
  if (wrong_is("old_header")) subject.size = offsetof(mmverify_subject_t, array_build);
  return &subject;
}
