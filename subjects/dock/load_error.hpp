// The error message of dlopen.
#pragma once

#include <dlfcn.h>

#include <string>

namespace mmverify::dock {

/// dlerror's message without the file's name at its start: the caller names the file as it was given.
/// library: the argument of dlopen. Domain: directly after dlopen returned null.
inline std::string load_error(const std::string& library) {
  std::string words = dlerror();
  if (words.starts_with(library + ": ")) words.erase(0, library.size() + 2);
  return words;
}

}  // namespace mmverify::dock
