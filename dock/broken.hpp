// A subject that did something else than answer.
#pragma once

#include <stdexcept>

namespace mmverify::dock {

/// what() says what the subject did, and on which input.
struct SubjectBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::dock
