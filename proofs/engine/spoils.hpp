// A mutant's change of one entry point, for any topic whose subjects are structs of functions.
#pragma once

#include <functional>
#include <type_traits>

namespace mmverify::proofs {

/// Replaces one entry point of a subject by the real one followed by `spoil`, which gets the arguments and then the
/// answer, and may alter the answer.  Without a return value, the answer is among the arguments.  A missing entry
/// point stays missing.
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

/// The same for an entry point of a part of the functions.
template <class Functions, class Part, class Answer, class... Given, class Spoil>
auto spoils(Part Functions::*part, std::function<Answer(Given...)> Part::*entry, Spoil spoil) {
  return [=](Functions& functions) { spoils(entry, spoil)(functions.*part); };
}

}  // namespace mmverify::proofs
