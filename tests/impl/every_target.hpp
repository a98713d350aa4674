// Checks under every SIMD target.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace mmverify::tests {

/// Runs a check once under every SIMD target that this machine has and the library was built for, and under
/// the one that a program gets.
template <class Check>
void on_every_target(Check check) {
  const auto targets = hwy::SupportedAndGeneratedTargets();
  ASSERT_FALSE(targets.empty());
  for (const auto target : targets) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();  // the next call chooses again
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
  SCOPED_TRACE("the target that a program gets");
  check();
}

}  // namespace mmverify::tests
