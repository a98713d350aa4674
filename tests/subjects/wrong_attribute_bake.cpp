// The example of a baker of attribute maps but for one thing, chosen when it is linked.
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_attribute_bake(void);

namespace {

using Case = mmverify_attribute_case_t;

std::size_t faces_of(const Case& what) { return std::size_t{1} << 2 * what.level; }
std::size_t vertices_of(const Case& what) {
  const std::size_t N = std::size_t{1} << what.level;
  return (N + 1) * (N + 2) / 2;
}

/// The case that is baked in its place; texels that are changed are in `room`.
Case changed(const Case& what, std::vector<std::uint8_t>& room) {
  Case other = what;
  if (wrong_is("srgb_as_codes") && what.meaning == MMVERIFY_SRGB) other.meaning = MMVERIFY_LINEAR;
  if (wrong_is("black_border")) std::memset(other.border, 0, sizeof other.border);
  if (wrong_is("mirror_repeats") && what.wrap_v == MMVERIFY_MIRRORED_REPEAT) other.wrap_v = MMVERIFY_REPEAT;
  if (wrong_is("wraps_exchanged")) std::swap(other.wrap_u, other.wrap_v);
  if (wrong_is("centres_at_corners"))
    for (std::size_t k = 0; k < 6; ++k)
      other.uv[k] += 0.5f / static_cast<float>(k % 2 == 0 ? what.width : what.height);
  if (wrong_is("coordinates_in_8_bits_at_5") && what.level == 5)
    for (float& x : other.uv) x = std::nearbyint(x * 256) / 256;
  if (wrong_is("rows_from_below")) {
    const std::size_t row = std::size_t{4} * what.width;
    const auto* texels = static_cast<const std::uint8_t*>(what.texels);
    for (std::size_t y = what.height; y-- > 0;)
      room.insert(room.end(), texels + y * row, texels + (y + 1) * row);
    other.texels = room.data();
  }
  return other;
}

int bake(int (*right)(const Case*, std::uint8_t*), const Case& what, std::uint8_t* map, std::size_t values) {
  if (wrong_is("declines_all") || (wrong_is("declines_borders") && what.wrap_u == MMVERIFY_CLAMP_TO_BORDER))
    return 0;
  std::vector<std::uint8_t> room;
  const Case other = changed(what, room);
  std::vector<std::uint8_t> baked(4 * values);
  if (right(&other, baked.data()) == 0) return 0;
  std::memcpy(map, baked.data(), baked.size() - (wrong_is("unwritten") ? 4 : 0));
  std::uint8_t& last = map[4 * values - 2];
  if (wrong_is("two_codes_off_at_4") && what.level == 4) last = static_cast<std::uint8_t>(last ^ 2);
  if ((wrong_is("one_code_off") || wrong_is("exact_by_its_word")) && last > 0) --last;
  static volatile std::uint8_t sum = 0;
  const auto* texels = static_cast<const std::uint8_t*>(what.texels);
  if (wrong_is("reads_past")) sum = texels[std::size_t{4} * what.width * what.height];
  if (wrong_is("overrun")) map[4 * values] = sum;
  return 1;
}

int bake_faces(const Case* what, std::uint8_t* map) {
  return bake(right_attribute_bake()->attribute_bake_faces, *what, map, faces_of(*what));
}

int bake_vertices(const Case* what, std::uint8_t* map) {
  return bake(right_attribute_bake()->attribute_bake_vertices, *what, map, vertices_of(*what));
}

mmverify_attribute_support_t support() {
  mmverify_attribute_support_t s = *right_attribute_bake()->attribute_support;
  if (wrong_is("exact_by_its_word")) s.tolerance = 0;
  if (wrong_is("tolerance_above_16")) s.tolerance = 17;
  if (wrong_is("clamps_srgb_only")) {
    s.wraps = 1u << MMVERIFY_CLAMP_TO_EDGE;
    s.meanings = 1u << MMVERIFY_SRGB;
  }
  return s;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_attribute_bake();
  static const mmverify_attribute_support_t declared = support();
  subject.attribute_bake_faces = bake_faces;
  subject.attribute_bake_vertices = bake_vertices;
  subject.attribute_support = &declared;
  if (wrong_is("vertices_only")) subject.attribute_bake_faces = nullptr;
  if (wrong_is("old_header")) subject.size = offsetof(mmverify_subject_t, attribute_bake_faces);
  return &subject;
}
