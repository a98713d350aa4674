// A library that means harm, in one way of many, chosen when it is linked.  It answers 0 for every point, and 1 where it
// could do what it tried.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/shm.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cfenv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "subjects/dock/futex.hpp"
#include "subjects/dock/layout.hpp"
#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

namespace {

using mmverify::dock::Mailbox;
using mmverify::dock::Outcome;

[[noreturn]] void sleep_on() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

/// The mailbox, where the first mapping of the shared memory says that it lies.
Mailbox& mailbox() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    if (line.find("memfd:mmverify-subject") != std::string::npos)
      return *reinterpret_cast<Mailbox*>(std::stoull(line, nullptr, 16));
  std::abort();
}

/// Gives the tool its turn in the worker's place, with what was written before.
[[noreturn]] void hand_over(std::uint32_t turn = 0) {
  mailbox().turn.store(turn);
  mmverify::dock::futex_wake(mailbox().turn);
  sleep_on();
}

// ---- What the kernel is to refuse.

bool can_end_itself() {
  const long x32 = 0x40000000;
  kill(getpid(), SIGKILL);
  raise(SIGKILL);
  raise(SIGSTOP);
  raise(SIGTSTP);
  syscall(SYS_tgkill, getpid(), gettid(), SIGKILL);
  syscall(SYS_tkill, gettid(), SIGKILL);
  syscall(x32 + SYS_kill, getpid(), SIGKILL);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGKILL;
  int timer = 0;
  const itimerspec soon{{0, 0}, {0, 1'000'000}};
  if (syscall(SYS_timer_create, CLOCK_MONOTONIC, &event, &timer) == 0)
    syscall(SYS_timer_settime, timer, 0, &soon, nullptr);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return false;
}

/// A pipe that sends a signal to somebody as soon as it can be read.
bool can_signal_by_a_file(pid_t whom, int signal) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  const bool owned = fcntl(ends[0], F_SETOWN, whom) == 0;
  const bool chosen = fcntl(ends[0], F_SETSIG, signal) == 0;
  fcntl(ends[0], F_SETFL, O_ASYNC | O_NONBLOCK);
  const bool sent = write(ends[1], "", 1) == 1 && (owned || chosen);
  close(ends[0]);
  close(ends[1]);
  return sent;
}

bool can_leave_its_group() {
  return setpgid(0, getpgid(getppid())) == 0 || setsid() > 0 || syscall(SYS_unshare, 0x10000000) == 0;
}

bool can_open(const std::string& path, int how) {
  const int fd = open(path.c_str(), how);
  if (fd >= 0) close(fd);
  return fd >= 0;
}

bool can_reach_the_tool() {
  const std::string tool = "/proc/" + std::to_string(getppid());
  char byte = 0;
  const iovec here{&byte, 1}, there{&byte, 1};
  const long pidfd = syscall(434, getppid(), 0);  // pidfd_open
  return can_open(tool + "/mem", O_RDWR) || can_open(tool + "/mem", O_RDONLY) ||
         can_open(tool + "/fd/1", O_WRONLY) || can_open(tool + "/environ", O_RDONLY) ||
         process_vm_readv(getppid(), &here, 1, &there, 1, 0) == 1 ||
         process_vm_writev(getppid(), &here, 1, &there, 1, 0) == 1 ||
         (pidfd >= 0 && syscall(438, pidfd, 1, 0) >= 0) || ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0;
}

/// Not where the worker could not be kept from it: a kernel without Landlock.
bool can_write_where_it_may_not() {
  const char byte = '\n';
  return can_open("/dev/tty", O_WRONLY) || can_open("/dev/ptmx", O_RDWR) ||
         can_open("/proc/self/oom_score_adj", O_WRONLY) || ioctl(0, TIOCSTI, &byte) == 0 ||
         read(0, const_cast<char*>(&byte), 1) > 0;
}

bool has_descriptors_of_the_tool() {
  for (int fd = 3; fd < 1024; ++fd)
    if (fcntl(fd, F_GETFD) != -1) return true;
  return false;
}

/// The tool reads there all the time: memory that a file no longer has ends it by SIGBUS.
bool can_shrink_the_shared_memory() {
  bool shrunk = false;
  for (const std::string& process : {std::string("self"), std::to_string(getppid())})
    for (int fd = 0; fd < 256; ++fd) {
      const std::string name = "/proc/" + process + "/fd/" + std::to_string(fd);
      char target[256]{};
      if (readlink(name.c_str(), target, sizeof target - 1) > 0 &&
          std::strstr(target, "memfd:mmverify") != nullptr)
        shrunk = truncate(name.c_str(), 0) == 0 || shrunk;
    }
  return shrunk;
}

bool can_take_memory_that_nobody_has() {
  std::FILE* const file = std::tmpfile();
  return syscall(SYS_memfd_create, "hidden", 0) >= 0 || shmget(IPC_PRIVATE, 1 << 20, IPC_CREAT | 0600) >= 0 ||
         (file != nullptr && fallocate(fileno(file), 0, 0, 1 << 20) == 0);
}

bool can_write_its_input(const float* u) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  void* const start = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(u) / page * page);
  return mprotect(start, page, PROT_READ | PROT_WRITE) == 0;
}

bool tries_what_is_refused(const float* u) {
  if (wrong_is("ends_itself")) return can_end_itself() || can_signal_by_a_file(getpid(), SIGKILL);
  if (wrong_is("signals_the_tool")) return can_signal_by_a_file(getppid(), SIGKILL);
  if (wrong_is("leaves_its_group")) return can_leave_its_group();
  if (wrong_is("reaches_the_tool")) return can_reach_the_tool();
  if (wrong_is("writes_to_terminals")) return can_write_where_it_may_not();
  if (wrong_is("looks_for_descriptors")) return has_descriptors_of_the_tool();
  if (wrong_is("shrinks_the_memory")) return can_shrink_the_shared_memory();
  if (wrong_is("hides_memory")) return can_take_memory_that_nobody_has();
  if (wrong_is("unlocks_its_input")) return can_write_its_input(u);
  return false;
}

// ---- What it writes into the memory that it shares with the tool.

volatile int* volatile nowhere = nullptr;

void crash() { *nowhere = 1; }

void write_into_the_mailbox() {
  Mailbox& m = mailbox();
  if (wrong_is("reports_no_such_outcome")) m.report.outcome = static_cast<Outcome>(0xffffffffu), hand_over();
  if (wrong_is("reports_without_end")) {
    m.report.outcome = Outcome::threw;
    std::memset(m.report.message, 'A', sizeof m.report.message);
    hand_over();
  }
  if (wrong_is("reports_no_such_element")) {
    m.report.outcome = Outcome::unwritten;
    m.report.element = ~std::uint64_t{0};
    hand_over();
  }
  if (wrong_is("takes_no_such_turn")) hand_over(7);
  if (wrong_is("fills_the_mailbox")) {
    std::memset(static_cast<void*>(&m.call), 0xAA, sizeof m - sizeof m.turn);
    hand_over();
  }
  if (wrong_is("begins_nowhere")) m.begun.store(~std::uint64_t{0} / 2), crash();
  if (wrong_is("is_at_another_level")) m.another_level.store(1), crash();
  if (wrong_is("reports_the_machine")) {
    m.report.outcome = Outcome::no_resources;
    hand_over();
  }
}

// ---- What it says.

constexpr char forged[] =
    "\r\x1b[2K\x1b[32mproved     index.equals_reference\nproved     everything\x9b"
    "0m\xff\xe2\x80\xae ##[error]";

void speak() {
  if (wrong_is("throws_escapes")) throw std::runtime_error(forged);
  if (wrong_is("throws_half_a_character"))
    throw std::runtime_error(std::string(511, 'x').replace(509, 2, "\xe2\x82") + "\xac");
  if (wrong_is("prints_commands")) {
    static bool said = false;
    if (!said) std::fprintf(stderr, "::error::forged\nproved     everything\n%s\nno end of line", forged);
    said = true;
  }
}

// ---- Modes and files.

void leave_a_mode() {
  static thread_local int calls = 0;
  static bool first = true;
  ++calls;
  if (wrong_is("rounds_in_its_first_call") && first) std::fesetround(FE_UPWARD);
#if defined(__x86_64__)
  if (wrong_is("halves_x87_precision")) {
    const unsigned short single = 0x007f;
    asm volatile("fldcw %0" : : "m"(single));
  }
#endif
  // The worker's own thread is the one that is as old as the process.
  if (wrong_is("rounds_in_threads") && gettid() != getpid()) std::fesetround(FE_UPWARD);
  first = false;
}

/// Once: its own file, with a byte more.
void rewrite_itself() {
  static bool done = false;
  Dl_info about{};
  if (done || dladdr(reinterpret_cast<void*>(&mailbox), &about) == 0) return;
  done = true;
  const std::string file = about.dli_fname;
  std::ifstream from(file, std::ios::binary);
  std::ofstream(file + ".new", std::ios::binary) << from.rdbuf() << '\n';
  std::rename((file + ".new").c_str(), file.c_str());
}

void index_f32(uint32_t, const float* u, const float*, uint32_t* index, size_t count) {
  if (wrong_is("is_slow")) std::this_thread::sleep_for(std::chrono::milliseconds(200));
  if (wrong_is("crashes_then_hangs")) {
    if (count == 1) sleep_on();
    crash();
  }
  if (wrong_is("sleeps")) sleep_on();
  if (wrong_is("rewrites_itself")) rewrite_itself();
  if (wrong_is("fills_a_folder"))
    for (int k = 0; k < 64; ++k) {
      std::FILE* const file = std::tmpfile();
      for (std::size_t n = 0; file != nullptr && n < 4; ++n) std::fwrite(forged, 1, sizeof forged, file);
      static char block[8 << 20];
      if (file != nullptr) std::fwrite(block, 1, sizeof block, file), std::fclose(file);
    }
  write_into_the_mailbox();
  speak();
  leave_a_mode();
  static const uint32_t answer =
      tries_what_is_refused(u) ? 1 : 0;  // the first inputs lie in the shared memory
  for (size_t k = 0; k < count; ++k) index[k] = answer;
}

size_t tree_encode(uint32_t, uint32_t, const uint8_t*, uint8_t*, size_t) {
  Mailbox& m = mailbox();
  m.report.outcome = Outcome::answered;
  m.report.taken = 1;
  m.report.answer_bytes = ~std::uint64_t{0} / 2;
  hand_over();
}

int tree_decode(uint32_t, uint32_t, const uint8_t*, size_t, uint8_t*) {
  Mailbox& m = mailbox();
  m.report.outcome = Outcome::answered;
  m.report.taken = 1;
  m.report.answer_bytes = 0;
  hand_over();
}

/// How often it was loaded, by the file that MMVERIFY_TEST_LOADS names.
std::size_t loads() {
  const char* const file = std::getenv("MMVERIFY_TEST_LOADS");
  if (file == nullptr) return 0;
  std::ofstream(file, std::ios::app) << '.';
  std::ifstream in(file, std::ios::ate);
  return static_cast<std::size_t>(in.tellg());
}

struct Loaded {
  Loaded() {
    if (wrong_is("hangs_while_loaded")) sleep_on();
    if (wrong_is("hangs_when_loaded_again") && loads() > 1) sleep_on();
    if (wrong_is("crashes_when_loaded_again") && loads() > 1) crash();
#if defined(__x86_64__)
    if (wrong_is("flushes_when_loaded"))
      __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);  // as -ffast-math
#endif
    if (wrong_is("rounds_when_loaded")) std::fesetround(FE_UPWARD);
    if (wrong_is("describes_without_end")) {
      Mailbox& m = mailbox();
      std::memset(static_cast<void*>(&m.description), 0x7f, sizeof m.description);
      m.report.outcome = Outcome::ready;
      hand_over();
    }
    if (wrong_is("is_ready_before_it_is")) {
      mailbox().report.outcome = Outcome::answered;
      hand_over();
    }
  }
} loaded;

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  if (wrong_is("never_describes_itself")) sleep_on();
  static mmverify_subject_t subject{};
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = wrong_is("names_itself_badly") ? forged : "hostile";
  subject.runs_on = wrong_is("names_itself_badly") ? forged : nullptr;
  subject.max_level = 16;
  subject.index_f32 = index_f32;
  if (wrong_is("answers_without_bounds"))
    subject.tree_encode = tree_encode, subject.tree_decode = tree_decode;
  return &subject;
}
