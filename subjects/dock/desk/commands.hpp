// The two kinds of commands.
#pragma once

#include <cstdint>

#include "subjects/dock/desk/caller.hpp"
#include "subjects/dock/desk/worker_memory.hpp"

namespace mmverify::dock {

/// Runs command `number` of this process, on numbers in slots.
void run_on_numbers(const Caller& caller, WorkerMemory& kept, std::uint64_t number);
/// Runs a command on a map, a code or a case.
void run_on_blob(const Caller& caller, WorkerMemory& kept);

}  // namespace mmverify::dock
