// Libraries built with a sanitizer: the environment that a worker needs to load them, and the way their
// reports end a call.
#pragma once

#include <string>
#include <vector>

namespace mmverify::dock {

/// The sanitizer's runtime that the library needs first of all, such as "libasan.so.8", by the list of needed
/// libraries in its ELF file. Empty if there is none, or no such file.
std::string runtime_to_load_first(const std::string& library);

/// The environment of a worker that loads the library, "NAME=VALUE" each: this process's, with that runtime
/// in LD_PRELOAD, and with sanitizer options by which a report ends the process with abort() and a fault at a
/// guard page is left to the worker. Options that the user set come after these and win.
std::vector<std::string> worker_environment(const std::string& library);

}  // namespace mmverify::dock
