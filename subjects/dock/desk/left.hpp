// The state of a thread that a call must leave as it was: registers, the floating-point mode, the signal mask.
#pragma once

#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace mmverify::dock {

/// Whether the x87 registers, which MMX shares, are free, as the ABI of x86-64 wants them at a return: a
/// caller's next long double is NaN otherwise.
inline bool x87_registers_are_free() {
#if defined(__x86_64__)
  constexpr std::size_t abridged_tags = 4;  // the byte of FXSAVE with a bit for each register in use
  struct alignas(16) {
    unsigned char bytes[512];
  } area;
  asm volatile("fxsave %0" : "=m"(area));
  return area.bytes[abridged_tags] == 0;
#else
  return true;
#endif
}

/// The calling thread's blocked signals, a bit each.
inline std::uint64_t blocked_signals() {
  std::uint64_t mask = 0;
  syscall(SYS_rt_sigprocmask, SIG_BLOCK, nullptr, &mask, sizeof mask);
  return mask;
}

/// Changes that a thread's calls left behind.
struct Left {
  std::optional<std::uint64_t> mode;  ///< the floating-point mode
  bool registers = false;             ///< values in x87 or MMX registers
  bool signals = false;               ///< the signal mask
};

}  // namespace mmverify::dock
