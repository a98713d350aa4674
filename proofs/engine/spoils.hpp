// What a mutant changes, of any topic whose subjects are structs of functions.
#pragma once

#include <functional>
#include <type_traits>

namespace mmverify::proofs {

/// A change of a subject's functions: one entry point answers, and `spoil` gets what it got, and then its
/// answer, which it may alter.  Where answers go to an argument, it gets no other.  What is missing stays so.
template <class Functions, class Answer, class... Given, class Spoil>
auto spoils(std::function<Answer(Given...)> Functions::*entry, Spoil spoil) {
  return [=](Functions& functions) {
    if (!(functions.*entry)) return;
    functions.*entry = [spoil, real = functions.*entry](Given... given) -> Answer {
      if constexpr (std::is_void_v<Answer>) {
        real(given...);
        spoil(given...);
      } else {
        Answer answer = real(given...);
        spoil(given..., answer);
        return answer;
      }
    };
  };
}

}  // namespace mmverify::proofs
