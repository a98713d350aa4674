// Results as JUnit XML, for the CI systems that read it.
#pragma once

#include <string>

#include "cli/arguments/arguments.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// A suite for each law, with a test for each subject and level: refuted and broken fail, incomplete is an
/// error, not_applicable is a skip.
/// A suite has properties "SUBJECT: KEY" for subjects that describe where they run.
std::string to_junit(const proofs::Report& report, const std::vector<RunsOn>& runs_on = {});

}  // namespace mmverify::cli
