// Shared libraries, judged by the built program.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/command.hpp"

namespace mmverify::tests {

/// One of tests/subjects, as it was built.
inline std::string library(const std::string& name) {
  return std::string(MMVERIFY_SUBJECTS) + "/" + name + ".so";
}

/// Runs `mmverify prove WHAT` on one of them, on one thread; `seconds`: what it may take for a batch.
inline Outcome judged(const std::string& name, const std::string& what, int seconds = 20) {
  return shell("mmverify prove " + what + " --details --quiet --no-mutants --timeout " +
               std::to_string(seconds) + " --threads 1 --subject " + library(name));
}

using Words = std::vector<std::string>;

/// The exit code, and words that stdout has, or has not.
inline void expect_said(const Outcome& o, int exit_code, const Words& words, const Words& others = {}) {
  EXPECT_EQ(o.exit_code, exit_code) << o.out << o.err;
  for (const std::string& w : words) EXPECT_THAT(o.out, testing::HasSubstr(w));
  for (const std::string& w : others) EXPECT_THAT(o.out, testing::Not(testing::HasSubstr(w)));
}
/// Each of `names` behind the same words.
inline Words each_of(const std::string& before, Words names) {
  for (std::string& name : names) name.insert(0, before);
  return names;
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

/// A library; its law, and how that is asked; words of what is said.
struct Asked {
  std::string name, what, says, and_says = {};

  std::string law() const { return what.substr(0, what.find(' ')); }
};

/// Each is refuted by its law, with its case, and replayed.
template <class Judge>
void expect_each_refuted(const Judge& judge, const std::vector<Asked>& all) {
  for (const Asked& one : all) {
    SCOPED_TRACE(one.name + " by " + one.what);
    const Outcome o = judge(one.name, one.what);
    expect_refuted_and_replayed(o, one.law());
    expect_said(o, 1, {one.says, one.and_says});
  }
}
/// Each breaks its law, with the case; `more` is asked of each, and `always` is said of it.
template <class Judge>
void expect_each_broken(const Judge& judge, const std::string& more, const std::string& always,
                        const std::vector<Asked>& all) {
  for (const Asked& one : all) {
    SCOPED_TRACE(one.name + " by " + one.what);
    expect_said(judge(one.name, one.what + more), 1,
                {"broken     " + one.law(), one.says, one.and_says, always});
  }
}

}  // namespace mmverify::tests
