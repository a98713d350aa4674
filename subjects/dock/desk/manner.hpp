// The state of a caller when it calls: what its earlier work may have left behind.
#pragma once

#include <clocale>
#include <cstdint>

namespace mmverify::dock {

enum class Manner : std::uint8_t {
  plain,
  upper_halves,   ///< garbage in the upper halves of the registers of 32-bit arguments
  errno_range,    ///< errno is ERANGE
  errno_invalid,  ///< errno is EINVAL
  exceptions,     ///< all flags of past floating-point exceptions are raised
  utf_8,          ///< the thread's locale is C.UTF-8, where the system has it
  deep_stack,     ///< garbage in 1 MiB of the stack below the caller
  shallow_stack   ///< garbage in 4 KiB of it
};

/// Puts the calling thread into a caller's state, and back at its end. The call comes next: anything in
/// between would write over the stack's garbage.
class Surroundings {
 public:
  explicit Surroundings(Manner manner);
  ~Surroundings();
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  Manner manner_;
  locale_t before_ = nullptr;
};

}  // namespace mmverify::dock
