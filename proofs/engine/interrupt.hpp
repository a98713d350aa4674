// Ctrl-C: the run stops at the next chunk and says so.
#pragma once

namespace mmverify::proofs {

/// True once SIGINT, SIGTERM or SIGHUP has come in while a guard was alive.
bool interrupted();

/// Leaves a wait that an interrupt cut short.
struct Interrupted {};

/// Turns SIGINT, SIGTERM and SIGHUP into `interrupted()` for its lifetime, or for that of the guard that it lives within;
/// the second one ends the process as usual.  An ignored SIGHUP stays ignored.
/// Domain: one thread, the last one made ends first.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// Bounds what a guard waits for: a process that still runs so long after its first signal ends with exit code `code`.
/// stderr says at the signal that a second one ends the process at once.
/// Domain: once, before the first guard; milliseconds > 0.
void end_after_interrupt(unsigned milliseconds, int code);

}  // namespace mmverify::proofs
