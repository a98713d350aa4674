// The subject's struct, which its library has to keep as it was for the life of the process.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::dock {

class Promised {
 public:
  using Get = const mmverify_subject_t* (*)();
  /// No library yet.
  Promised() = default;
  /// Domain: `theirs` is what `get` has returned.
  Promised(Get get, const mmverify_subject_t* theirs);

  /// A sentence on what has changed since; empty if nothing has.
  std::string change() const;
  /// The same after mmverify_subject_v1() was called once more.
  std::string change_when_asked_again() const;

 private:
  /// The first field of another struct that differs, or that the struct cannot be read; empty if neither.
  std::string difference(const mmverify_subject_t* with) const;

  Get get_ = nullptr;
  const mmverify_subject_t* theirs_ = nullptr;
  std::vector<std::byte> bytes_;
};

}  // namespace mmverify::dock
