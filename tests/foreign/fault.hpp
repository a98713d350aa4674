// Which fault a foreign subject has: a row of its topic's table, named by the environment.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::tests::foreign {

/// The row of `names` that MMVERIFY_FAULT names, counted from 0; -1 where it is not set or empty.  Nothing
/// where it names no row, so that a misspelt fault is never taken for a right subject.
template <int rows>
std::optional<int> chosen_fault(const char* const (&names)[rows]) {
  const char* name = std::getenv("MMVERIFY_FAULT");
  if (name == nullptr || *name == '\0') return -1;
  for (int k = 0; k < rows; ++k)
    if (std::strcmp(names[k], name) == 0) return k;
  return std::nullopt;
}

/// The subject's declaration about threads. Two threads at once take several times as long as one, and most faults
/// answer the same either way: for those a test sets MMVERIFY_ONE_THREAD.
inline std::uint32_t threading() {
  return std::getenv("MMVERIFY_ONE_THREAD") != nullptr ? MMVERIFY_SINGLE_THREADED : 0u;
}

}  // namespace mmverify::tests::foreign
