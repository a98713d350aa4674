#include "dock/desk/confine.hpp"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmverify::dock {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;
#endif

/// A seccomp filter, written down instruction by instruction.
class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    // Calls of another word size have numbers of their own.
    jump(BPF_JEQ, architecture, 1, 0);
    answer(SECCOMP_RET_ERRNO | EPERM);
    load(offsetof(seccomp_data, nr));
  }

  void refuse(long call, int error) {
    jump(BPF_JEQ, static_cast<std::uint32_t>(call), 0, 1);
    answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
  }

  /// Lets the call through where the bits of an argument's lower half are all there.
  void refuse_without(long call, unsigned argument, std::uint32_t bits, int error) {
    jump(BPF_JEQ, static_cast<std::uint32_t>(call), 0, 4);
    load(lower_half(argument));
    jump(BPF_JSET, bits, 1, 0);
    answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
    answer(SECCOMP_RET_ALLOW);
  }

  /// Lets the call through where both halves of an argument are these.
  void refuse_unless(long call, unsigned argument, std::uint64_t value, int error) {
    jump(BPF_JEQ, static_cast<std::uint32_t>(call), 0, 6);
    load(lower_half(argument));
    jump(BPF_JEQ, static_cast<std::uint32_t>(value), 0, 3);
    load(lower_half(argument) + 4);
    jump(BPF_JEQ, static_cast<std::uint32_t>(value >> 32), 0, 1);
    answer(SECCOMP_RET_ALLOW);
    answer(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
  }

  /// From now on; whether the kernel took it.
  bool install() {
    answer(SECCOMP_RET_ALLOW);
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
  }

 private:
  /// Both architectures are little-endian.
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

}  // namespace

void confine() {
  const rlimit files{open_files, open_files}, bytes{file_bytes, file_bytes};
  setrlimit(RLIMIT_NOFILE, &files);
  setrlimit(RLIMIT_FSIZE, &bytes);
  if (architecture == 0) return;
  const auto self = static_cast<std::uint32_t>(getpid());
  Filter filter;
#ifdef SYS_fork
  filter.refuse(SYS_fork, EAGAIN);
  filter.refuse(SYS_vfork, EAGAIN);
#endif
  filter.refuse(SYS_clone3, ENOSYS);  // its flags lie in memory; the C library then calls clone
  filter.refuse(SYS_execve, EPERM);
  filter.refuse(SYS_execveat, EPERM);
  filter.refuse(SYS_ptrace, EPERM);
  filter.refuse(SYS_process_vm_writev, EPERM);
  filter.refuse(SYS_tkill, EPERM);
  filter.refuse(SYS_rt_sigqueueinfo, EPERM);
  filter.refuse(SYS_pidfd_send_signal, EPERM);
#ifdef SYS_setrlimit
  filter.refuse(SYS_setrlimit, EPERM);
#endif
  filter.refuse_without(SYS_clone, 0, CLONE_THREAD, EAGAIN);
  // After one of these the number is gone from the accumulator, whatever it answers: it ends the filter.
  filter.refuse_unless(SYS_kill, 0, self, EPERM);
  filter.refuse_unless(SYS_tgkill, 0, self, EPERM);
  filter.refuse_unless(SYS_rt_tgsigqueueinfo, 0, self, EPERM);
  filter.refuse_unless(SYS_prlimit64, 2, 0, EPERM);
  filter.install();
}

}  // namespace mmverify::dock
