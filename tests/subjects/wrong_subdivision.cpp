// The example of shapes but for one thing, chosen when it is linked.
#include <cstddef>
#include <utility>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_subdivision(void);

namespace {

volatile int* volatile nowhere = nullptr;

void index(std::uint32_t scheme, std::uint32_t level, const std::uint32_t* x, const std::uint32_t* y,
           const std::uint32_t* z, const std::uint32_t* denominator, std::uint32_t* out, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    std::uint32_t depth = z[k];
    const bool diagonal = x[k] == y[k];
    if (wrong_is("crash") && scheme == MMVERIFY_BISECTION && level == 4 && diagonal) *nowhere = 1;
    if (wrong_is("ignores_z") && scheme == MMVERIFY_TETRAHEDRON) depth = 0;
    const std::uint32_t as =
        wrong_is("hilbert_is_morton") && scheme == MMVERIFY_HILBERT ? MMVERIFY_MORTON : scheme;
    right_subdivision()->subdivision_index(as, level, x + k, y + k, &depth, denominator + k, out + k, 1);
    if (wrong_is("diagonal_goes_back") && scheme == MMVERIFY_BISECTION && level == 4 && diagonal &&
        out[k] > 0)
      --out[k];
  }
}

void corners(std::uint32_t scheme, std::uint32_t level, const std::uint32_t* index_of, std::uint32_t* out,
             std::size_t count) {
  right_subdivision()->subdivision_corners(scheme, level, index_of, out, count);
  for (std::size_t k = 0; k < count; ++k)
    if (wrong_is("turns_a_cell_of_nine") && scheme == MMVERIFY_TRIANGLE_9 && level == 2 && index_of[k] == 50)
      std::swap(out[12 * k], out[12 * k + 3]);
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_subdivision();
  if (!wrong_is("corners_only")) subject.subdivision_index = index;
  subject.subdivision_corners = corners;
  if (wrong_is("corners_only")) subject.subdivision_index = nullptr;
  return &subject;
}
