// A right subject but for one thing, chosen when it is linked; it happens at one vertex of level 7.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "impl/index/index.hpp"
#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

namespace {

constexpr bool at_the_vertex(uint32_t level, float u, float v) {
  return level == 7 && u == 0.375f && v == 0.25f;
}

volatile int* volatile nowhere = nullptr;

void misbehave(const float* u, uint32_t* index, size_t count, size_t k) {
  static int calls = 0;
  static volatile int inside = 0;
  if (wrong_is("crash") || wrong_is("crash_and_tie")) *nowhere = 1;
  if (wrong_is("hang")) std::this_thread::sleep_for(std::chrono::hours(1));
  if (wrong_is("overrun")) index[count] = 0;
  if (wrong_is("underrun")) index[-1] = 0;
  if (wrong_is("exits")) std::_Exit(0);
  if (wrong_is("throws")) throw std::runtime_error("no such triangle");
  if (wrong_is("rounds")) std::fesetround(FE_UPWARD);
  if (wrong_is("counts_calls")) index[k] ^= ++calls > 3 ? 1 : 0;
  if (wrong_is("sees_batch")) index[k] ^= count == 7 ? 1 : 0;
  if (wrong_is("sees_threads")) {
    inside = inside + 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    index[k] ^= inside > 1 ? 1 : 0;
    inside = inside - 1;
  }
  if (wrong_is("writes_input")) const_cast<float*>(u)[k] = 0;
  if (wrong_is("tie")) index[k] ^= 1;
  if (wrong_is("prints")) std::puts("{}");
  if (wrong_is("forks"))
    for (;;) fork();
  if (wrong_is("fills_memory"))
    for (;;) std::memset(std::malloc(16 << 20), 1, 16 << 20);
  if (wrong_is("opens_files"))
    while (open("/dev/null", O_RDONLY) >= 0) continue;
  if (wrong_is("writes_a_file"))
    for (std::FILE* file = std::tmpfile();;) std::fputs("written without end ", file);
  if (wrong_is("prints_on"))
    for (;;) std::puts("printed without end");
  if (wrong_is("starts_threads"))
    for (;;) std::thread([] { std::this_thread::sleep_for(std::chrono::hours(1)); }).detach();
  if (wrong_is("kills_parent")) {
    kill(getppid(), SIGKILL);
    kill(-1, SIGTERM);
    const rlimit more{1 << 20, 1 << 20};
    setrlimit(RLIMIT_NOFILE, &more);
  }
}

/// The last question of a thread and its answer, without the level.
struct Last {
  float u = -1, v = -1;
  uint32_t index = 0;
};

/// A table that is published before it is filled: wrong for whoever asks while another thread fills it.
bool table_is_whole() {
  static std::atomic<bool> published = false, filled = false;
  if (!published.exchange(true)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    filled = true;
  }
  return filled;
}

std::uintptr_t address(const void* p) { return reinterpret_cast<std::uintptr_t>(p); }

void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  thread_local Last last;
  static float shared[1 << 17];
  if ((wrong_is("shares_a_buffer") && count == 4096) || (wrong_is("shares_a_large_buffer") && count > 4096)) {
    std::memcpy(shared, u, count * sizeof *u);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // long enough for another thread's copy
    u = shared;
  }
  if (wrong_is("takes_its_time") && count > 4096) std::this_thread::sleep_for(std::chrono::milliseconds(400));
  if (wrong_is("counts_in_16_bits")) count %= 1 << 16;
  if (wrong_is("crash_on_all")) *nowhere = 1;
  // A table for levels 0 to 8, and one for all: what is asked in vain lies at their ends.
  const bool ends_at_8 = wrong_is("fills_its_end_last"), ends_at_16 = wrong_is("fills_level_16_last"),
             whole = (!wrong_is("publishes_early") && !ends_at_8 && !ends_at_16) || table_is_whole(),
             table = whole || (ends_at_8 && level != 8) || (ends_at_16 && level != 16);
  for (size_t k = 0; k < count; ++k) {
    if (at_the_vertex(level, u[k], v[k]) && wrong_is("unwritten")) continue;
    if (wrong_is("keeps_the_last") && u[k] == last.u && v[k] == last.v) {
      index[k] = last.index;
      continue;
    }
    index[k] = mmverify::impl::index::from_barycentrics(u[k], v[k], level);
    last = {u[k], v[k], index[k]};
    if (!table) index[k] ^= 1;
    // Whole batches are of neighbours, unless they are asked in another order.
    if (wrong_is("sees_order") && k == 1 && count == 4096 &&
        std::fabs(u[1] - u[0]) + std::fabs(v[1] - v[0]) > 0.125f)
      index[k] ^= 1;
    if (wrong_is("sees_addresses") && (address(u) ^ address(v)) % 16 != 0) index[k] ^= 1;
    if (wrong_is("crash_at_5") && level == 5 && u[k] == 0.25f && v[k] == 0.25f) *nowhere = 1;
    if (wrong_is("crash_and_tie") && level == 7 && u[k] == 0.25f && v[k] == 0.25f) index[k] ^= 1;
    if (at_the_vertex(level, u[k], v[k])) misbehave(u, index, count, k);
  }
}

/// Siblings share the way down to their parent, whose key has no room for the level: at 16 it is lost.
void corners(uint32_t level, const uint32_t* index, uint32_t* out, size_t count) {
  struct Parent {
    uint32_t key = 0, level = 0, index = 0;
  };
  thread_local Parent kept[4096];
  for (size_t k = 0; k < count; ++k) {
    const uint32_t key = level << 28 | index[k] >> 2;
    Parent& parent = kept[key % 4096];
    if (parent.key != key || key == 0) parent = {key, level, index[k] >> 2};
    const auto c = mmverify::impl::index::corners(parent.index << 2 | (index[k] & 3), parent.level);
    for (size_t corner = 0; corner < 3; ++corner) {
      out[6 * k + 2 * corner] = c[corner].i;
      out[6 * k + 2 * corner + 1] = c[corner].j;
    }
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
  if (wrong_is("keeps_parents")) subject.corners = corners;
  return &subject;
}
