// Which fault a foreign subject has: a row of its topic's table, named by the environment.
#pragma once

#include <cstdlib>
#include <cstring>
#include <optional>

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

}  // namespace mmverify::tests::foreign
