// A subject that did something else than answer, and a machine that has no room to ask it.
#pragma once

#include <stdexcept>
#include <string>

namespace mmverify::dock {

/// what() says what the subject did, and on which input.
struct SubjectBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The same while it was asked of one case: it may answer the others.
struct CaseBroken : SubjectBroken {
  CaseBroken(const std::string& what, bool took_too_long) : SubjectBroken(what), hung(took_too_long) {}
  bool hung;  ///< it used up all the time that it may take
};

/// No process, no memory, no file: nothing is said of the subject.  what() says which.
struct NoResources : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::dock
