// Shared libraries, judged by the built program.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/command.hpp"

namespace mmverify::tests {

/// One of tests/subjects, as it was built.
inline std::string library(const std::string& name) {
  return std::string(MMVERIFY_SUBJECTS) + "/" + name + ".so";
}

/// Runs the command that a counterexample's line ends with.
inline Outcome replayed(const Outcome& o) {
  const auto at = o.out.find("replay: ");
  return shell(at == std::string::npos ? "false" : o.out.substr(at + 8, o.out.find('\n', at) - at - 8));
}

/// The law refutes it, and the command on the counterexample's line shows that again.
inline void expect_refuted_and_replayed(const Outcome& o, const std::string& law) {
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, testing::HasSubstr("refuted    " + law));
  const Outcome again = replayed(o);
  EXPECT_EQ(again.exit_code, 1) << again.out << again.err;
  EXPECT_THAT(again.out, testing::HasSubstr("refuted " + law));
}

}  // namespace mmverify::tests
