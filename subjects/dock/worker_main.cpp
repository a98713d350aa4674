// mmverify-worker LIBRARY: calls a subject for the tool, in a process that may die of it.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "subjects/dock/desk/confine.hpp"
#include "subjects/dock/desk/desk.hpp"
#include "subjects/dock/desk/float_mode.hpp"
#include "subjects/dock/desk/memory.hpp"
#include "subjects/dock/desk/open_subject.hpp"
#include "subjects/dock/futex.hpp"

// A sanitizer's own handlers would turn a crash into an exit.
extern "C" const char* __asan_default_options() {
  return "handle_segv=0:handle_sigbus=0:handle_abort=0:handle_sigfpe=0:handle_sigill=0:detect_leaks=0";
}

int main(int argc, char** argv) {
  using namespace mmverify::dock;
  if (argc != 2) {
    std::fputs("mmverify-worker is started by mmverify\n", stderr);
    return 2;
  }
  // Ctrl-C is for the tool to handle.  Workers die with the tool, and leave no core file.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_DFL);
  // The user's limit of processor time ends the worker anyway: SIGKILL follows SIGXCPU a moment later.
  std::signal(SIGXCPU, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  // A subject's output must not get into the results.
  dup2(STDERR_FILENO, STDOUT_FILENO);

  // The subject must not get the tool's files, pipes and journals.
  close_from(shared_memory_descriptor + 1);

  const Layout layout(static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
  std::byte* base = map(shared_memory_descriptor, layout);
  if (base == nullptr) return 4;
  auto& mailbox = *reinterpret_cast<Mailbox*>(base);

  // A library that starts programs, such as a driver's compiler, needs MMVERIFY_UNCONFINED.
  if (std::getenv("MMVERIFY_UNCONFINED") == nullptr) confine();

  const std::uint64_t mode_before_loading = float_mode();
  mmverify_subject_t subject{};
  Promised promised;
  Outcome outcome = Outcome::cannot_load;
  mailbox.report.outcome = outcome;
  const std::string why = cannot_load(mailbox.description, argv[1], subject, promised, outcome);
  mailbox.report.outcome = outcome;
  std::snprintf(mailbox.report.message, sizeof mailbox.report.message, "%s", why.c_str());
  mailbox.turn.store(0, std::memory_order_release);
  futex_wake(mailbox.turn);
  if (!why.empty()) return 0;
  explain_faults(base, layout);
  const Caller caller(base, layout, subject, promised, mode_before_loading);
  Desk(caller).serve();
}
