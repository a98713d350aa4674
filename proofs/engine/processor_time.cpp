#include "proofs/engine/processor_time.hpp"

#include <ctime>

namespace mmverify::proofs {
namespace {
struct Counted {
  ProcessorTime* task = nullptr;
  bool alone = false;
  std::int64_t since = 0;
};
thread_local Counted counted;
}  // namespace

std::int64_t thread_nanoseconds() {
  timespec now{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return 0;
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void Counting::settle(std::int64_t now) {
  if (counted.task != nullptr) {
    counted.task->spent += now - counted.since;
    if (counted.alone) counted.task->path += now - counted.since;
  }
  counted.since = now;
}

Counting::Counting(ProcessorTime* task, bool alone)
    : displaced_(counted.task), displaced_alone_(counted.alone) {
  settle(thread_nanoseconds());
  counted.task = task;
  counted.alone = alone;
}

Counting::~Counting() {
  settle(thread_nanoseconds());
  counted.task = displaced_;
  counted.alone = displaced_alone_;
}

ProcessorTime* Counting::task() { return counted.task; }

}  // namespace mmverify::proofs
