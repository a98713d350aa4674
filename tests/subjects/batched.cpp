// Our batched index as a subject: about a nanosecond an index, fast enough to show what the isolation costs.
#include <algorithm>

#include "impl/index/index.hpp"
#include "subjects/sdk/mmverify_subject.h"

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

/// The same formula in binary64: a number that became a float first would cross lines on the way.
uint32_t index_of(uint32_t level, double u, double v) {
  namespace detail = mmverify::impl::index::detail;
  const uint32_t N = 1u << level;
  const double un = std::clamp(u, 0.0, 1.0) * N, vn = std::clamp(v, 0.0, 1.0) * N;
  const auto i = static_cast<uint32_t>(un), j = static_cast<uint32_t>(vn);
  const double uf = un - i, vf = vn - j;
  const uint32_t carry = std::min(uf, vf) >= 1 - std::max(uf, vf) ? 1 : 0,
                 row = std::min(N - 1, i + j + carry);
  const uint32_t iv = std::min(j, N - 1), iu = std::min(i, N - 1 - iv), b0 = iu ^ row, t = (iu ^ iv) & b0;
  return detail::interleaved(b0, ((detail::xor_from_above(t) ^ iu) & ~b0) | t);
}

void index_f64(uint32_t level, const double* u, const double* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) index[k] = index_of(level, u[k], v[k]);
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
  subject.flags = DECLARED;
  subject.corners = corners;
  subject.row_index_f32 = row_index_f32;
  subject.row_corners = row_corners;
  return &subject;
}
