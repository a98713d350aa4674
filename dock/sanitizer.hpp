// Libraries that were built with a sanitizer: what a worker needs to load them, and how their reports end a call.
#pragma once

#include <string>
#include <vector>

namespace mmverify::dock {

/// The sanitizer's runtime that the library needs and that has to be loaded before all else, "libasan.so.8" for one:
/// by the list of needed libraries in its ELF file.  Empty: none, or no such file.
std::string runtime_to_load_first(const std::string& library);

/// "NAME=VALUE", of a worker that loads the library: this process's, with that runtime in LD_PRELOAD, and sanitizers
/// set so that a report ends the process by abort(), and a fault at a guard page stays the worker's to explain.
/// Options that the user gave come after these.
std::vector<std::string> worker_environment(const std::string& library);

}  // namespace mmverify::dock
