// A right subject but for one thing, chosen by MISBEHAVIOUR when it is compiled; it happens at one vertex of
// level 7.
#include <cfenv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "impl/index.hpp"
#include "sdk/mmverify_subject.h"

namespace {

enum Misbehaviour {
  none,
  crash,
  hang,
  overrun,
  underrun,
  exits,
  throws,
  rounds,
  counts_calls,
  sees_batch,
  sees_threads,
  writes_input,
  tie,
  prints,
  unwritten
};

constexpr bool at_the_vertex(uint32_t level, float u, float v) {
  return level == 7 && u == 0.375f && v == 0.25f;
}

volatile int* volatile nowhere = nullptr;

void misbehave(const float* u, uint32_t* index, size_t count, size_t k) {
  static int calls = 0;
  static volatile int inside = 0;
  switch (MISBEHAVIOUR) {
    case none:
      break;
    case crash:
      *nowhere = 1;
      break;
    case hang:
      std::this_thread::sleep_for(std::chrono::hours(1));
      break;
    case overrun:
      index[count] = 0;
      break;
    case underrun:
      index[-1] = 0;
      break;
    case exits:
      std::_Exit(0);
    case throws:
      throw std::runtime_error("no such triangle");
    case rounds:
      std::fesetround(FE_UPWARD);
      break;
    case counts_calls:
      index[k] ^= ++calls > 3 ? 1 : 0;
      break;
    case sees_batch:
      index[k] ^= count == 7 ? 1 : 0;
      break;
    case sees_threads: {
      inside = inside + 1;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      index[k] ^= inside > 1 ? 1 : 0;
      inside = inside - 1;
      break;
    }
    case writes_input:
      const_cast<float*>(u)[k] = 0;
      break;
    case tie:
      index[k] ^= 1;
      break;
    case prints:
      std::puts("{}");
      break;
    case unwritten:
      break;
  }
}

void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    if (MISBEHAVIOUR == unwritten && at_the_vertex(level, u[k], v[k])) continue;
    index[k] = mmverify::impl::index::from_barycentrics(u[k], v[k], level);
    if (at_the_vertex(level, u[k], v[k])) misbehave(u, index, count, k);
  }
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject{};
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "misbehaving";
  subject.max_level = 16;
  subject.index_f32 = index_f32;
  return &subject;
}
