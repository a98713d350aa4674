#include "proofs/engine/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <ctime>

namespace mmverify::proofs {
namespace {
volatile std::sig_atomic_t stop_asked = 0;
timespec asked_at{};                      ///< written by the handler, before stop_asked
volatile std::sig_atomic_t patience = 0;  ///< milliseconds; 0: no end
volatile std::sig_atomic_t code_at_end = 0;
#ifndef __EMSCRIPTEN__
timer_t
    end_timer;  ///< timer_settime(), not setitimer(), is one of the functions that signal handlers may call
#endif
int guards = 0;  ///< alive; all are the main thread's

/// write(), which signal handlers may call.
template <std::size_t n>
void say(const char (&text)[n]) {
  if (write(STDERR_FILENO, text, n - 1) < 0) return;  // nobody reads
}

/// Seconds within which signals are one wish: timeout(1) signals its child, and then the group that holds it.
constexpr double one_wish = 0.3;

double seconds_since_asked() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - asked_at.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - asked_at.tv_nsec);
}

extern "C" void ask_to_stop(int signal) {
  if (stop_asked != 0) {
    if (seconds_since_asked() < one_wish) return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  clock_gettime(CLOCK_MONOTONIC, &asked_at);
  stop_asked = 1;
#ifndef __EMSCRIPTEN__
  if (patience == 0) return;
  say("mmverify: interrupted, ending; a second signal ends it at once\n");
  itimerspec end{};
  end.it_value.tv_sec = patience / 1000;
  end.it_value.tv_nsec = 1'000'000L * (patience % 1000);
  timer_settime(end_timer, 0, &end, nullptr);
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

void end_after_interrupt(unsigned milliseconds, int code) {
  code_at_end = code;
#ifndef __EMSCRIPTEN__
  std::signal(SIGALRM, end_at_once);
  if (timer_create(CLOCK_MONOTONIC, nullptr, &end_timer) != 0) return;  // it ends when it is ready
#endif
  patience = static_cast<std::sig_atomic_t>(milliseconds);
}

}  // namespace mmverify::proofs
