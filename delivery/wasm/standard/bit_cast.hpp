// A std::bit_cast for the standard library of Debian 12's emscripten, which lacks it; included before every
// file.
#pragma once

#if defined(__cplusplus)
#include <bit>
#include <type_traits>

#if !defined(__cpp_lib_bit_cast)
namespace std {

template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> &&
         is_trivially_copyable_v<From>) constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

}  // namespace std
#endif
#endif
