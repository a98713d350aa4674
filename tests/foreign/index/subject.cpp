// The index of a micro-triangle along Vulkan's curve and in rows, and back, written from the header, docs/INDEX.md
// and the papers alone: exact for all numbers that it is given.  Each fault of the table is one slip inside this
// code.
#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/index/entry_points.hpp"
#include "tests/foreign/index/faults.hpp"

namespace mmverify::tests::foreign::index {
namespace {

mmverify_subject_t make() {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "a stranger's index";
  s.max_level = 16;
  s.flags = threading() | MMVERIFY_CORNERS_OF_CHILDREN;
  s.index_f32 = indices<float>;
  s.index_f64 = indices<double>;
  s.corners = corners;
  s.row_index_f32 = row_indices;
  s.row_corners = row_corners;
  return s;
}

}  // namespace
}  // namespace mmverify::tests::foreign::index

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  using namespace mmverify::tests::foreign::index;
  static const mmverify_subject_t subject = make();
  return fault ? &subject : nullptr;
}
