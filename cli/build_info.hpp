// What this program was built from and with. The values are a file of their own, made by CMake: a change of the sources
// compiles that one anew, and not all who read it.
#pragma once

namespace mmverify::cli::build {

extern const char* const version;
extern const char* const compiler;
extern const char* const flags;
extern const char* const spec_hash;
extern const char* const source_hash;  ///< of spec, impl, scene, dock and proofs
extern const char* const libraries;

}  // namespace mmverify::cli::build
