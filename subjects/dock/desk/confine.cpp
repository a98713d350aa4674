#include "subjects/dock/desk/confine.hpp"

#include <asm/sockios.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "subjects/dock/desk/landlock.hpp"

namespace mmverify::dock {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;
#endif

// Numbers that the C library's header may not have yet; they are the same on all architectures.
constexpr int io_uring_setup = 425, pidfd_getfd = 438, memfd_secret = 447;

/// A seccomp filter, built instruction by instruction.
class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    // System calls of another word size have other numbers.
    jump(BPF_JEQ, architecture, 1, 0);
    answer(SECCOMP_RET_ERRNO | EPERM);
    load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
    // The system calls of x32 do too, on the same architecture.
    jump(BPF_JGE, 0x40000000u, 0, 1);
    answer(SECCOMP_RET_ERRNO | ENOSYS);
#endif
  }

  void refuse(long call, int error) {
    jump(BPF_JEQ, static_cast<std::uint32_t>(call), 0, 1);
    answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
  }

  /// Checks the arguments of a system call; it passes unless a check refuses it.
  /// Domain: `checks` uses only the refuse functions for arguments; each leaves the accumulator to the next.
  template <class Checks>
  void arguments(long call, Checks checks) {
    Filter of_call(nothing);
    checks(of_call);
    of_call.answer(SECCOMP_RET_ALLOW);
    // The jump's distance has eight bits.
    jump(BPF_JEQ, static_cast<std::uint32_t>(call), 0, static_cast<std::uint8_t>(of_call.code_.size()));
    code_.insert(code_.end(), of_call.code_.begin(), of_call.code_.end());
  }
  /// Refuses the call unless the lower half of an argument has all these bits.
  void refuse_without(unsigned argument, std::uint32_t bits, int error) {
    load(lower_half(argument));
    jump(BPF_JSET, bits, 1, 0);
    answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
  }
  /// Refuses the call unless an argument has this value.
  void refuse_unless(unsigned argument, std::uint64_t value, int error) {
    load(lower_half(argument));
    jump(BPF_JEQ, static_cast<std::uint32_t>(value), 1, 0);
    answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
    load(lower_half(argument) + 4);
    jump(BPF_JEQ, static_cast<std::uint32_t>(value >> 32), 1, 0);
    answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
  }
  /// Refuses the call if the lower half of an argument is one of these; the kernel reads only that half of an
  /// int.
  void refuse_values(unsigned argument, std::initializer_list<int> values, int error) {
    load(lower_half(argument));
    for (const int value : values) {
      jump(BPF_JEQ, static_cast<std::uint32_t>(value), 0, 1);
      answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
    }
  }

  /// Installs the filter; returns whether the kernel accepted it.
  bool install() {
    answer(SECCOMP_RET_ALLOW);
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
  }

 private:
  static constexpr struct Nothing {
  } nothing{};
  explicit Filter(Nothing) {}
  /// Both known architectures are little-endian.
  static std::uint32_t lower_half(unsigned argument) {
    return static_cast<std::uint32_t>(offsetof(seccomp_data, args)) + 8 * argument;
  }
  void load(std::size_t offset) { add({BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)}); }
  void jump(unsigned kind, std::uint32_t k, std::uint8_t if_so, std::uint8_t if_not) {
    add({static_cast<std::uint16_t>(BPF_JMP | kind | BPF_K), if_so, if_not, k});
  }
  void answer(std::uint32_t what) { add({BPF_RET | BPF_K, 0, 0, what}); }
  void add(const sock_filter& instruction) { code_.push_back(instruction); }

  std::vector<sock_filter> code_;
};

/// Drops root's capabilities, except for access to files of other users. The kernel lets a process with fewer
/// capabilities than the tool read and write none of the tool's memory. Other users have none, and keep none.
/// Returns whether there were any to drop.
bool drop_capabilities() {
  constexpr std::uint32_t kept = 1u << CAP_DAC_OVERRIDE | 1u << CAP_DAC_READ_SEARCH;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[_LINUX_CAPABILITY_U32S_3]{};
  if (syscall(SYS_capget, &header, sets) != 0) return false;
  const bool some = sets[0].permitted != 0 || sets[1].permitted != 0;
  sets[0].effective &= kept;
  sets[0].permitted &= kept;
  sets[0].inheritable = 0;
  sets[1] = {};
  return syscall(SYS_capset, &header, sets) == 0 && some;
}

/// Enters a user namespace of its own, with the same user and group: the kernel then lets the process read
/// and write no memory of a process outside.
void leave_for_a_user_namespace() {
  const unsigned user = geteuid(), group = getegid();
  if (unshare(CLONE_NEWUSER) != 0) return;
  const auto write_to = [](const char* file, const std::string& text) {
    const int fd = open(file, O_WRONLY | O_CLOEXEC);
    if (fd < 0) return;
    // If the write is refused, files of this user stay readable all the same.
    [[maybe_unused]] const ssize_t written = write(fd, text.data(), text.size());
    close(fd);
  };
  const auto itself = [](unsigned id) { return std::to_string(id) + " " + std::to_string(id) + " 1"; };
  write_to("/proc/self/setgroups", "deny");
  write_to("/proc/self/uid_map", itself(user));
  write_to("/proc/self/gid_map", itself(group));
  drop_capabilities();
}

}  // namespace

void close_from(int first) {
  constexpr long close_range = 436;  // Linux 5.9
  if (syscall(close_range, first, ~0u, 0) == 0) return;
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  constexpr rlim_t most = 1 << 16;
  for (int fd = first; fd < static_cast<int>(std::min(files.rlim_cur, most)); ++fd) close(fd);
}

void confine() {
  const rlimit files{open_files, open_files}, bytes{file_bytes, file_bytes};
  setrlimit(RLIMIT_NOFILE, &files);
  setrlimit(RLIMIT_FSIZE, &bytes);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const bool locked_out = lock_out_terminals_and_processes();
  if (!drop_capabilities() && !locked_out) leave_for_a_user_namespace();
  if (architecture == 0) return;
  const auto self = static_cast<std::uint32_t>(getpid());
  Filter filter;
#ifdef SYS_fork
  filter.refuse(SYS_fork, EAGAIN);
  filter.refuse(SYS_vfork, EAGAIN);
#endif
  filter.refuse(SYS_clone3, ENOSYS);  // its flags are in memory; the C library falls back to clone
  // The tool kills a worker by its process group and waits for it by its number.
  for (const long call : {SYS_setpgid, SYS_setsid, SYS_execve, SYS_execveat, SYS_unshare, SYS_setns})
    filter.refuse(call, EPERM);
  for (const long call : {SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, pidfd_getfd})
    filter.refuse(call, EPERM);
  // The last two can send any signal to the process itself, SIGKILL included.
  for (const long call :
       {SYS_tkill, SYS_rt_sigqueueinfo, SYS_pidfd_send_signal, SYS_timer_create, SYS_mq_notify})
    filter.refuse(call, EPERM);
  // The filter does not see calls that are made in a ring.
  filter.refuse(io_uring_setup, ENOSYS);
  // These make memory outside every process's resident set; for fallocate() the C library writes zeros
  // instead.
  filter.refuse(SYS_memfd_create, ENOSYS);
  filter.refuse(memfd_secret, ENOSYS);
  filter.refuse(SYS_shmget, EPERM);
  filter.refuse(SYS_fallocate, EOPNOTSUPP);
#ifdef SYS_setrlimit
  filter.refuse(SYS_setrlimit, EPERM);
#endif
  filter.arguments(SYS_clone, [](Filter& f) { f.refuse_without(0, CLONE_THREAD, EAGAIN); });
  const auto none_of_outside = {SIGKILL, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU};
  filter.arguments(SYS_kill, [&](Filter& f) {
    f.refuse_unless(0, self, EPERM);
    f.refuse_values(1, none_of_outside, EPERM);
  });
  for (const long call : {SYS_tgkill, SYS_rt_tgsigqueueinfo})
    filter.arguments(call, [&](Filter& f) {
      f.refuse_unless(0, self, EPERM);
      f.refuse_values(2, none_of_outside, EPERM);
    });
  // fcntl and ioctl can make a file send signals, even to the tool, and a terminal accept input that was
  // never typed.
  filter.arguments(SYS_fcntl, [](Filter& f) {
    f.refuse_values(1, {F_SETOWN, F_SETOWN_EX, F_SETSIG}, EPERM);
  });
  filter.arguments(SYS_ioctl, [](Filter& f) {
    f.refuse_values(1, {FIOSETOWN, SIOCSPGRP, TIOCSTI, TIOCLINUX}, EPERM);
  });
  filter.arguments(SYS_prlimit64, [](Filter& f) { f.refuse_unless(2, 0, EPERM); });
  filter.install();
}

}  // namespace mmverify::dock
