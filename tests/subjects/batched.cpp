// Our batched index as a subject: about a nanosecond an index, fast enough to show what the isolation costs.
#include "impl/index.hpp"
#include "sdk/mmverify_subject.h"

namespace {

void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  mmverify::impl::index::from_barycentrics({u, count}, {v, count}, level, {index, count});
}

void corners(uint32_t level, const uint32_t* index, uint32_t* out, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const auto c = mmverify::impl::index::corners(index[k], level);
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      out[6 * k + 2 * vertex] = c[vertex].i;
      out[6 * k + 2 * vertex + 1] = c[vertex].j;
    }
  }
}

void index_f64(uint32_t level, const double* u, const double* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k)
    index[k] =
        mmverify::impl::index::from_barycentrics(static_cast<float>(u[k]), static_cast<float>(v[k]), level);
}

void row_index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  mmverify::impl::index::w_minor({u, count}, {v, count}, level, {index, count});
}

void row_corners(uint32_t, const uint32_t* index, uint32_t* out, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const auto c = mmverify::impl::index::w_minor_corners(index[k]);
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      out[6 * k + 2 * vertex] = c[vertex].i;
      out[6 * k + 2 * vertex + 1] = c[vertex].j;
    }
  }
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject{};
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "batched";
  subject.max_level = 16;
  subject.index_f32 = index_f32;
  subject.index_f64 = index_f64;
  subject.corners = corners;
  subject.row_index_f32 = row_index_f32;
  subject.row_corners = row_corners;
  return &subject;
}
