// The short answer of a run: verdicts and faults first, then a line for each law, at most 25 lines in all.
#pragma once

#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

constexpr std::size_t most_lines = 25;

/// The lines of a report. subjects: those that were named, in order; empty if the laws' own ones ran.
/// first, last: lines before the verdicts and after the laws. Laws that do not apply are counted; if the laws do
/// not fit line by line, topics are counted.
std::vector<std::string> short_answer(const proofs::Report& report,
                                      const std::vector<proofs::SubjectPtr>& subjects,
                                      const std::vector<std::string>& first,
                                      const std::vector<std::string>& last);

}  // namespace mmverify::cli
