#include "subjects/dock/desk/manner.hpp"

#include <alloca.h>
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <cfenv>
#include <cstddef>

namespace mmverify::dock {
namespace {

constexpr std::size_t deep = std::size_t{1} << 20, shallow = 4096;

/// Bytes of the stack that may be filled: a quarter of it at most.
std::size_t within_the_stack(std::size_t bytes) {
  static const std::size_t most = [] {
    rlimit stack{};
    constexpr rlim_t usual = rlim_t{8} << 20;
    if (getrlimit(RLIMIT_STACK, &stack) != 0) stack.rlim_cur = usual;
    return static_cast<std::size_t>(std::min(stack.rlim_cur, usual) / 4);
  }();
  return std::min(bytes, most);
}

/// Leaves garbage below its caller's frame. A byte and its inverse alternate: neither zeros nor one value.
[[gnu::noinline]] void leave_garbage(std::size_t bytes) {
  constexpr std::uint64_t word = 0x5AA55AA55AA55AA5u;
  auto* const garbage = static_cast<volatile std::uint64_t*>(alloca(bytes));
  for (std::size_t k = 0; k < bytes / sizeof word; ++k) garbage[k] = word;
}

void raise_all_exceptions() {
  std::feraiseexcept(FE_ALL_EXCEPT);
#if defined(__x86_64__)
  // feraiseexcept() may raise some flags in the x87 status word alone.
  constexpr unsigned flags = 0x3f;
  __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | flags);
#endif
}

/// The locale C.UTF-8; null if the system lacks it.
locale_t utf_8_locale() {
  static const locale_t found = newlocale(LC_ALL_MASK, "C.UTF-8", nullptr);
  return found;
}

}  // namespace

Surroundings::Surroundings(Manner manner) : manner_(manner) {
  switch (manner) {
    case Manner::plain:
    case Manner::upper_halves: break;
    case Manner::errno_range: errno = ERANGE; break;
    case Manner::errno_invalid: errno = EINVAL; break;
    case Manner::exceptions: raise_all_exceptions(); break;
    case Manner::utf_8:
      if (const locale_t it = utf_8_locale(); it != nullptr) before_ = uselocale(it);
      break;
    case Manner::deep_stack: leave_garbage(within_the_stack(deep)); break;
    case Manner::shallow_stack: leave_garbage(within_the_stack(shallow)); break;
  }
}

Surroundings::~Surroundings() {
  if (before_ != nullptr) uselocale(before_);
  if (manner_ == Manner::exceptions) std::feclearexcept(FE_ALL_EXCEPT);
}

}  // namespace mmverify::dock
