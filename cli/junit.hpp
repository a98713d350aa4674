// Results as JUnit XML, for the CI systems that read it.
#pragma once

#include <string>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// One suite a law, one test a subject and level; refuted and broken fail, incomplete is an error,
/// not_applicable a skip.
std::string to_junit(const proofs::Report& report);

}  // namespace mmverify::cli
