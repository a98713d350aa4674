// Facts about this build. CMake writes their values into a source file of their own: a change of the sources
// recompiles that file only.
#pragma once

namespace mmverify::cli::build {

extern const char* const version;
extern const char* const compiler;
extern const char* const flags;
extern const char* const spec_hash;
extern const char* const source_hash;  ///< of spec, impl, scene, dock and proofs
extern const char* const libraries;

}  // namespace mmverify::cli::build
