// Errors: a subject that misbehaves, and a machine without room to run it.
#pragma once

#include <stdexcept>
#include <string>

namespace mmverify::dock {

/// A subject that did not answer; what() says what it did, and on which input.
struct SubjectBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A subject that did not answer one case; it may answer others.
struct CaseBroken : SubjectBroken {
  CaseBroken(const std::string& what, bool took_too_long) : SubjectBroken(what), hung(took_too_long) {}
  bool hung;  ///< it used up its time
};

/// There was no process, memory or file, so there is no verdict on the subject; what() says which was
/// missing.
struct NoResources : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::dock
