// [memory] A worker that takes a dead one's place: what was asked often enough is not asked in every way again.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "subjects/dock/broken.hpp"
#include "subjects/dock/library.hpp"

namespace {

using namespace mmverify::dock;

constexpr Question question_about(const std::array<std::uint8_t, 1>& map) {
  return {Call::tree_encode, 0, MMVERIFY_2_STATE, map, 64};
}

TEST(AWorkersPlace, IsTakenWithTheCountOfWhatWasAsked) {
  setenv("MMVERIFY_WORKER", MMVERIFY_WORKER_PROGRAM, 1);
  const Library library(std::string(MMVERIFY_SUBJECTS) + "/tree_example.so", {});
  const std::array<std::uint8_t, 1> map{1};
  const auto kind = std::tuple{Call::tree_encode, 0u, std::uint32_t{MMVERIFY_2_STATE}};
  {
    Borrowed worker(library.pool());
    for (int k = 0; k < 3; ++k) worker->ask(question_about(map));
    // Not given back: as one that crashed.
  }
  Borrowed next(library.pool());
  EXPECT_EQ(next->asked().at(kind), 3u);
  next->ask(question_about(map));
  EXPECT_EQ(next->asked().at(kind), 4u);
  next.give_back();
}

TEST(AWorkersPlace, IsNewWhereNoneDied) {
  setenv("MMVERIFY_WORKER", MMVERIFY_WORKER_PROGRAM, 1);
  const Library library(std::string(MMVERIFY_SUBJECTS) + "/tree_example.so", {});
  Borrowed first(library.pool());
  first->ask(question_about({1}));
  Borrowed second(library.pool());
  EXPECT_TRUE(second->asked().empty());
  first.give_back();
  second.give_back();
}

}  // namespace
