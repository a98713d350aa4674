#include "proofs/engine/interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace mmverify::proofs {
namespace {
volatile std::sig_atomic_t stop_asked = 0;
volatile std::sig_atomic_t patience = 0;  ///< seconds; 0: no end
volatile std::sig_atomic_t code_at_end = 0;
int guards = 0;  ///< alive; all are the main thread's

/// write(), which signal handlers may call.
template <std::size_t n>
void say(const char (&text)[n]) {
  if (write(STDERR_FILENO, text, n - 1) < 0) return;  // nobody reads
}

extern "C" void ask_to_stop(int signal) {
  std::signal(signal, SIG_DFL);
  if (stop_asked != 0) return;
  stop_asked = 1;
#ifndef __EMSCRIPTEN__
  if (patience == 0) return;
  say("mmverify: interrupted, ending; a second signal ends it at once\n");
  alarm(static_cast<unsigned>(patience));
#endif
}

extern "C" void end_at_once(int) {
  say("mmverify: interrupted; no file was left half written\n");
  _exit(code_at_end);
}
}  // namespace

bool interrupted() { return stop_asked != 0; }

InterruptGuard::InterruptGuard() {
  if (guards++ != 0) return;
  stop_asked = 0;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  if (std::signal(SIGHUP, ask_to_stop) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  if (--guards != 0) return;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
}

void end_after_interrupt(unsigned seconds, int code) {
  patience = static_cast<std::sig_atomic_t>(seconds);
  code_at_end = code;
#ifndef __EMSCRIPTEN__
  std::signal(SIGALRM, end_at_once);
#endif
}

}  // namespace mmverify::proofs
