// The main loop of a worker process. It runs the commands in the mailbox, and repeats every question to see
// whether the subject's answers stay the same.
#pragma once

#include <unistd.h>

#include <cstdint>

#include "subjects/dock/desk/caller.hpp"
#include "subjects/dock/desk/worker_memory.hpp"

namespace mmverify::dock {

class Desk {
 public:
  explicit Desk(const Caller& caller) : caller_(caller) {}

  /// Runs commands until the tool ends the process.
  [[noreturn]] void serve();

 private:
  /// Runs the command in the mailbox, command `number` of this process.
  void run(std::uint64_t number);

  const Caller& caller_;
  WorkerMemory kept_;
  const pid_t self_ = getpid();
};

}  // namespace mmverify::dock
