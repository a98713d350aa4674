// The faults of one subject, for the short answer: its mistake in words, and the simplest input that shows it.
#pragma once

#include <string>
#include <vector>

#include "cli/prove/short/rows.hpp"

namespace mmverify::cli {

/// A subject's verdict and, below it, each fault. rows: those of the subject, at least one. subject: null if it
/// cannot be asked again, as a program on a pipe cannot.
std::vector<std::string> subject_lines(const std::vector<Row>& rows, const proofs::Subject* subject,
                                       const std::vector<proofs::Diagnosis>& diagnoses);

}  // namespace mmverify::cli
