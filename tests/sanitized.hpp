// The sanitized build takes tens of times as long, so it skips work that the release build does in full.
#pragma once

#ifdef __has_feature
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// For tests whose time goes to a prover, which no sanitizer sees into; other tests call the same code of
/// ours.
#define SKIP_A_PROVERS_WORK_UNDER_SANITIZERS() \
  if (sanitized) GTEST_SKIP() << "a prover's work; the release build runs it"

/// For tests that run the whole program for what another test runs it for, too: each start of a sanitized
/// one, with its worker, takes seconds.
#define SKIP_A_REPEAT_UNDER_SANITIZERS() \
  if (sanitized) GTEST_SKIP() << "the same code as under another test; the release build runs it"
