// The short answer of a codec's proofs: a line a law, its levels and formats merged; faults first, each with a case.
#pragma once

#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// "unknown" for a law that is not settled, unless somebody interrupted it; else the verdict.
std::string codec_verdict(proofs::Verdict verdict, const std::string& reason);

/// "expected 0 got 1 in state[k] (the law's tree.c:49)"; the fault alone, if no two values were compared.
std::string codec_case(const proofs::Counterexample& c);

/// At most `most_lines` lines: each law's verdict, levels, formats, domain and seconds; under a refuted one its first case
/// and the command that runs it again, under an unsettled one the reason. If they do not fit, laws without a fault are
/// counted by topic, and faults lose their cases.  last: lines before the sum.
/// Test: codec_command_test.
std::vector<std::string> codec_answer(const proofs::Report& report, const std::vector<std::string>& last);

}  // namespace mmverify::cli
