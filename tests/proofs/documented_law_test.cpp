// [release] docs/LAWS.md: its example is a law that compiles, holds and can fail.
#include <gtest/gtest.h>

#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::proofs::index {
Law last_law();
}

namespace {

using namespace mmverify::proofs;
using LawRun = Run;

TEST(DocumentedLaw, HoldsAndCanFail) {
  const Law law = index::last_law();
  for (const std::string& name : law.subjects)
    for (Level n = law.tiers.fast.first; n <= law.tiers.fast.last; ++n)
      EXPECT_EQ(run_level(law, *find_subject(name), n, LawRun{}).verdict, Verdict::proved)
          << name << " " << n;
  for (const MutantResult& m : run_mutants(law, LawRun{})) EXPECT_TRUE(m.killed) << m.mutant;
}

}  // namespace
