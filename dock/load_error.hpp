// What dlopen says of a library that it cannot load.
#pragma once

#include <dlfcn.h>

#include <string>

namespace mmverify::dock {

/// dlerror's words, without the file's name before them: whoever reports them names the file as it was given.
/// library: as dlopen was given it.  Domain: directly after dlopen returned null.
inline std::string load_error(const std::string& library) {
  std::string words = dlerror();
  if (words.starts_with(library + ": ")) words.erase(0, library.size() + 2);
  return words;
}

}  // namespace mmverify::dock
