// Standard error, for words that must not end a run.
#pragma once

#include <string_view>

namespace mmverify::proofs {

/// Writes the text to standard error, as far as that takes it: a full disk or a reader that went away loses the
/// words, never the run.  The only place that writes there.
/// Precondition: SIGPIPE is ignored, or may end the program.
void to_standard_error(std::string_view text) noexcept;

}  // namespace mmverify::proofs
