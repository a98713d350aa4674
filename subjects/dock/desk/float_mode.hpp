// The mode of a thread's floating-point unit.
#pragma once

#include <cfenv>
#include <cstdint>

namespace mmverify::dock {

/// The calling thread's modes: rounding, flush, precision and exception masks, without the flags of past
/// exceptions.
///   x86:     MXCSR bits 6 and 7..15, and the x87 control word above them
///   aarch64: FPCR
inline std::uint64_t float_mode() {
#if defined(__x86_64__)
  std::uint16_t x87 = 0;
  asm volatile("fnstcw %0" : "=m"(x87));
  return (__builtin_ia32_stmxcsr() & 0xffc0u) | std::uint64_t{x87} << 16;
#elif defined(__aarch64__)
  std::uint64_t fpcr = 0;
  asm volatile("mrs %0, fpcr" : "=r"(fpcr));
  return fpcr;
#else
  return static_cast<std::uint64_t>(std::fegetround());
#endif
}

/// Whether nothing but masks of exceptions differs in two modes.
inline bool differ_in_masks_alone(std::uint64_t mode, std::uint64_t other) {
#if defined(__x86_64__)
  constexpr std::uint64_t masks = 0x1f80u | std::uint64_t{0x3fu} << 16;
#elif defined(__aarch64__)
  constexpr std::uint64_t masks = 0x9f00u;
#else
  constexpr std::uint64_t masks = 0;
#endif
  return mode != other && ((mode ^ other) & ~masks) == 0;
}

}  // namespace mmverify::dock
