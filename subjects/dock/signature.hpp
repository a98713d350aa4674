// Facts about an entry point, derived from its type in the C header.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::dock {

struct Signature {
  std::size_t arrays;        ///< arrays of input numbers, each with one number for an element
  std::size_t number_bytes;  ///< bytes of one of these numbers; 0 if there are none
  bool of_points;            ///< the numbers are coordinates, valid at every level
  std::size_t value_bytes;   ///< bytes of one number of the answer
  bool answers_floats;
  bool of_blob;       ///< takes a map, a code or a case, too
  bool sizes_answer;  ///< returns the size of its answer, which only it knows
};

template <class T, class... Of>
constexpr bool one_of = (std::is_same_v<T, Of> || ...);
/// The kinds of pointers that entry points take.
template <class T>
constexpr bool is_numbers = one_of<T, const float*, const double*, const std::uint32_t*>;
template <class T>
constexpr bool is_blob =
    one_of<T, const std::uint8_t*, const mmverify_bake_case_t*, const mmverify_attribute_case_t*,
           const mmverify_blend_case_t*, const mmverify_array_case_t*, const mmverify_mesh_case_t*>;
template <class T>
constexpr bool is_answer = one_of<T, std::uint32_t*, std::uint8_t*, float*>;
/// The size of the pointer's target; 0 for other types.
template <class T>
constexpr std::size_t bytes_behind = 0;
template <class T>
constexpr std::size_t bytes_behind<T*> = sizeof(T);

/// The signature of an entry point. Domain: function types whose pointers are of the kinds above, with input
/// numbers of one width and one answer; others do not compile.
template <class Returned, class... P>
constexpr Signature signature_of(Returned (*)(P...)) {
  constexpr std::size_t widest = std::max({is_numbers<P> ? bytes_behind<P> : 0 ...});
  static_assert(((!std::is_pointer_v<P> || is_numbers<P> || is_blob<P> || is_answer<P>)&&...));
  static_assert(((!is_numbers<P> || bytes_behind<P> == widest) && ...));
  static_assert((std::size_t{is_answer<P>} + ...) == 1);
  return {.arrays = (std::size_t{is_numbers<P>} + ...),
          .number_bytes = widest,
          .of_points = (one_of<P, const float*, const double*> || ...),
          .value_bytes = ((is_answer<P> ? bytes_behind<P> : 0) + ...),
          .answers_floats = (std::is_same_v<P, float*> || ...),
          .of_blob = (is_blob<P> || ...),
          .sizes_answer = std::is_same_v<Returned, std::size_t>};
}

}  // namespace mmverify::dock
