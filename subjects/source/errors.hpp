// The reasons why a source is not judged.
#pragma once

#include <stdexcept>

namespace mmverify::source {

/// A file that does not compile, or has no such function; what() has the compiler's message.
struct BadSource : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// There is no such file.
struct NoSource : BadSource {
  using BadSource::BadSource;
};
/// There is no clang, or this build has no reader of bitcode; what() names the tool and its package.
struct NotAvailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Something has no operation here: an instruction, a promise, a flag; what() begins with file and line.
struct UnknownInstruction : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::source
