#include "proofs/engine/interrupt.hpp"

#include <csignal>

namespace mmverify::proofs {
namespace {
volatile std::sig_atomic_t stop_asked = 0;
int guards = 0;  ///< alive; all are the main thread's

extern "C" void ask_to_stop(int signal) {
  stop_asked = 1;
  std::signal(signal, SIG_DFL);
}
}  // namespace

bool interrupted() { return stop_asked != 0; }

InterruptGuard::InterruptGuard() {
  if (guards++ != 0) return;
  stop_asked = 0;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  std::signal(SIGHUP, ask_to_stop);
}

InterruptGuard::~InterruptGuard() {
  if (--guards != 0) return;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
}

}  // namespace mmverify::proofs
