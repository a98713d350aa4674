// A subject is a struct of functions, one an entry point; what a mutant does to one of them.
#pragma once

#include <functional>
#include <utility>

namespace mmverify::proofs {

/// The function's answer goes through `change`, which gets what was asked and may alter the answer.  An empty
/// change leaves it alone.  Domain: the function is there.
template <class Answer, class... Asked, class Change>
void alter(std::function<Answer(Asked...)>& function, const Change& change) {
  if constexpr (requires { static_cast<bool>(change); })
    if (!change) return;
  function = [before = std::move(function), change](Asked... asked) {
    Answer answer = before(asked...);
    change(asked..., answer);
    return answer;
  };
}

}  // namespace mmverify::proofs
