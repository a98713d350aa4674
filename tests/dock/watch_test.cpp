// The watch over a worker: time that a process waits for a processor, which is not its own.
#include "subjects/dock/watch.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

namespace {

using mmverify::dock::Waiting;

/// A child that works, or sleeps, on processor `processor` until it is killed.
class Child {
 public:
  Child(int processor, bool works) : pid_(fork()) {
    if (pid_ != 0) return;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(processor, &only);
    sched_setaffinity(0, sizeof only, &only);
    for (volatile bool working = works;;)
      if (!working) pause();
  }
  ~Child() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

void for_a_while() { std::this_thread::sleep_for(std::chrono::milliseconds(300)); }

// Two children on one processor wait for each other; how long, the machine's other work decides.
TEST(Waiting, CountsTheTimeWithoutAProcessorAlone) {
  if (!std::filesystem::exists("/proc/self/schedstat")) GTEST_SKIP() << "this kernel counts no waiting";
  const int here = sched_getcpu();
  const Child one(here, true), other(here, true), sleeper(here, false);
  for_a_while();
  Waiting of_one(one.pid()), of_other(other.pid()), of_sleeper(sleeper.pid());
  for_a_while();
  EXPECT_GT(of_one.seconds() + of_other.seconds(), 0);
  EXPECT_EQ(of_sleeper.seconds(), 0);
  of_one.seconds();
  for_a_while();
  const double waited = of_one.seconds();
  EXPECT_LT(of_one.seconds(), waited) << "seconds since the last call, not since the start";
}

TEST(Waiting, IsNoneOfAProcessThatIsGone) {
  pid_t pid = 0;
  {
    const Child gone(sched_getcpu(), false);
    pid = gone.pid();
  }
  EXPECT_EQ(Waiting(pid).seconds(), 0);
}

}  // namespace
