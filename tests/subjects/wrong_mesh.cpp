// The example of a baker of meshes but for one thing, chosen when it is linked: the bugs that such bakers have had.  What
// happens at one place happens with meshes of two triangles at level 1.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_mesh(void);

namespace {

volatile unsigned seen = 0;

/// The coordinate of a triangle's corner along an axis.
float along(const mmverify_mesh_case_t& c, const std::uint32_t* corners, std::size_t corner,
            std::size_t axis) {
  return c.uvs[2 * corners[corner] + axis];
}

/// Whether corner k of one triangle is corner (k + turn) % 3 of the other, both seen in steps of a part of a texel; 0
/// parts: exactly.
bool alike(const mmverify_mesh_case_t& c, const std::uint32_t* a, const std::uint32_t* b, std::size_t turn,
           float parts) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto size = static_cast<float>(axis == 0 ? c.surface->width : c.surface->height);
      const float x = along(c, a, k, axis), y = along(c, b, (k + turn) % 3, axis);
      if (parts == 0 ? x != y : std::round(x * size * parts) != std::round(y * size * parts)) return false;
    }
  return true;
}

/// Whether the wrong baker takes an earlier triangle's map for a later one's.
bool shares(const mmverify_mesh_case_t& c, const std::uint32_t* earlier, const std::uint32_t* later) {
  constexpr float quarters = 4;  // as meshoptimizer's opacityMapMeasure has it
  if (wrong_is("shares_by_quarters")) return alike(c, earlier, later, 0, quarters);
  if (wrong_is("shares_turned")) return alike(c, earlier, later, 1, 0) || alike(c, earlier, later, 2, 0);
  if (!wrong_is("shares_rewound")) return false;
  const std::uint32_t rewound[] = {later[0], later[2], later[1]};
  return alike(c, earlier, rewound, 0, 0);
}

std::uint32_t level_of(const mmverify_mesh_case_t& c, std::uint32_t triangle) {
  return c.levels != nullptr ? c.levels[triangle] : c.surface->level;
}

/// The case with other corners where a map is shared.
std::vector<std::uint32_t> shared_corners(const mmverify_mesh_case_t& c) {
  std::vector<std::uint32_t> corners(c.indices, c.indices + std::size_t{3} * c.triangles);
  for (std::uint32_t later = 0; later < c.triangles; ++later)
    for (std::uint32_t earlier = 0; earlier < later; ++earlier)
      if (level_of(c, earlier) == level_of(c, later) &&
          shares(c, &c.indices[3 * earlier], &c.indices[3 * later])) {
        std::memcpy(&corners[3 * later], &corners[3 * earlier], 3 * sizeof corners[0]);
        break;
      }
  return corners;
}

/// The parts of an answer.
struct Parts {
  explicit Parts(std::uint8_t* answer) {
    std::memcpy(&head, answer, sizeof head);
    records = answer + sizeof head;
    counts = records + std::size_t{8} * head.records;
    indices = counts + std::size_t{12} * (head.array_counts + head.geometry_counts);
    data = indices + head.index_bytes;
  }
  mmverify_array_answer_t head{};
  std::uint8_t *records, *counts, *indices, *data;
};

/// A triangle with the coordinates of an earlier one has the special index of zeros: its map was never baked.
void spoil_sharers(const mmverify_mesh_case_t& c, const Parts& parts) {
  const std::size_t width = parts.head.index_bytes / c.triangles;
  for (std::uint32_t later = 1; later < c.triangles; ++later)
    for (std::uint32_t earlier = 0; earlier < later; ++earlier)
      if (level_of(c, earlier) == level_of(c, later) &&
          alike(c, &c.indices[3 * earlier], &c.indices[3 * later], 0, 0))
        std::memset(parts.indices + later * width, 0xff, width);
}

void spoil(const mmverify_mesh_case_t& c, std::uint8_t* answer) {
  const Parts parts(answer);
  if (wrong_is("special_of_unbaked")) spoil_sharers(c, parts);
  if (wrong_is("overlaps") && parts.head.records == 2 && parts.records[8] > 1) --parts.records[8];
  if (wrong_is("counts_triangles") && parts.head.array_counts > 0)
    std::memcpy(parts.counts, &c.triangles, sizeof c.triangles);
  if (wrong_is("pads_with_ones") && parts.head.data_bytes == 1 && c.surface->format == MMVERIFY_2_STATE)
    parts.data[0] = static_cast<std::uint8_t>(parts.data[0] | 0xf0);
}

std::size_t bake_mesh(const mmverify_mesh_case_t* what, std::uint8_t* answer, std::size_t capacity) {
  mmverify_mesh_case_t c = *what;
  mmverify_bake_case_t surface = *what->surface;
  const bool here = c.triangles == 2 && surface.level == 1;
  const std::vector<std::uint32_t> corners = shared_corners(c);
  c.indices = corners.data();
  c.surface = &surface;
  if (wrong_is("declines_levels") && c.levels != nullptr) return 0;
  if (wrong_is("takes_one_level")) c.levels = nullptr;
  if (wrong_is("chooses_levels") || wrong_is("chooses_levels_untold")) {
    surface.level = surface.level / 2;
    c.levels = nullptr;
    if (what->levels != nullptr) surface.level = 0;
  }
  if (here && wrong_is("crash")) std::abort();
  if (here && wrong_is("throws")) throw std::runtime_error("no second triangle");
  if (here && wrong_is("reads_past") && surface.texel == MMVERIFY_UNORM8 && surface.mips == 1)
    seen = static_cast<const std::uint8_t*>(surface.texels)[std::size_t{surface.width} * surface.height];
  const std::size_t size = right_mesh()->bake_mesh(&c, answer, capacity);
  if (size == 0 || size > capacity) return size;
  if (here && wrong_is("overrun")) answer[size] = 1;
  spoil(*what, answer);
  static volatile int calls = 0;
  if (here && wrong_is("counts_calls")) {
    calls = calls + 1;
    if (calls > 1) Parts(answer).indices[0] ^= 1;
  }
  return size;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_mesh();
  subject.name = "a wrong baker of meshes";
  subject.bake_mesh = bake_mesh;
  subject.flags |= MMVERIFY_BAKE_TIGHT;
  if (wrong_is("chooses_levels")) subject.flags |= MMVERIFY_MESH_OWN_LEVELS;
  if (!wrong_is("bakes_triangles_too")) subject.bake = nullptr;
  if (wrong_is("old_header")) subject.size = offsetof(mmverify_subject_t, bake_mesh);
  return &subject;
}
