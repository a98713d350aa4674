// Results as JUnit XML, for the CI systems that read it.
#pragma once

#include <string>

#include "cli/arguments.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// One suite a law, one test a subject and level; refuted and broken fail, incomplete is an error,
/// not_applicable a skip.
/// A suite has properties "SUBJECT: KEY" of each of its subjects that say where they run.
std::string to_junit(const proofs::Report& report, const std::vector<RunsOn>& runs_on = {});

}  // namespace mmverify::cli
