// [release] The trials of a search for a cause: which change wins, and which is doubted.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "proofs/scene/cause/trials.hpp"
#include "tests/scene/made_scene.hpp"

namespace mmverify::tests {
namespace cause_trials_test {

using namespace mmverify::scene;
using impl::micromap::Array;
using impl::micromap::Format;
using impl::micromap::State;
using proofs::scene::Examined;
using proofs::scene::Judged;
using proofs::scene::States;
using proofs::scene::Trials;

constexpr unsigned level = 3;
constexpr std::size_t states = 64;

/// The first triangle of the small scene, with a stored map that has each known state wrong.
class OneTriangle {
 public:
  OneTriangle() {
    scene_.primitives[0].triangles.resize(1);
    maps_.plan = plan(scene_);
    maps_.baked = bake(scene_, maps_.plan, std::vector<unsigned>{level});
    BakedTriangle& map = maps_.baked.triangles[0];
    right_ = proofs::scene::states_of(map);
    States wrong = right_;
    for (State& s : wrong)
      if (s == State::T || s == State::O) s = s == State::T ? State::O : State::T;
    impl::micromap::Bytes packed(impl::micromap::packed_bytes(states, Format::four_state));
    impl::micromap::pack(wrong, Format::four_state, packed);
    map = BakedTriangle{level, Format::four_state, map.states, {}, packed};
    Array array;
    array.records.push_back({0, level, 2});
    array.data = packed;
    maps_.arrays.push_back(std::make_shared<const Array>(array));
    maps_.first.push_back(0);
    maps_.links.push_back({0, 0, 0, 0, 0, 0});
  }

  /// Tries a change under which `needless` known states are stored as unknown, and all others are as expected.
  static bool attempt(Trials& trials, const std::string& code, std::size_t needless, std::size_t known = 60) {
    States expected(states, State::UT);
    for (std::size_t k = 0; k < known; ++k) expected[k] = k % 2 == 0 ? State::T : State::O;
    States stored = expected;
    for (std::size_t k = 0; k < needless; ++k) stored[k] = State::UT;
    return trials.attempt(code, code, [&](const std::vector<std::size_t>&) {
      return Trials::Maps{{stored}, {expected}};
    });
  }

  const Judged& judged() const { return judged_; }
  const States& right() const { return right_; }

 private:
  Scene scene_ = made_scene();
  StoredMaps maps_;
  States right_;
  Judged judged_{scene_, maps_};
};

TEST(CauseTrials, TheChangeOfFewestNeedlessStatesWins) {
  const OneTriangle one;
  const Examined examined(one.judged(), 1 << 20);
  Trials trials(examined);
  EXPECT_TRUE(OneTriangle::attempt(trials, "a", 2));
  EXPECT_FALSE(OneTriangle::attempt(trials, "b", 3));
  EXPECT_EQ(trials.best()->code, "a");
  EXPECT_TRUE(OneTriangle::attempt(trials, "c", 0));
  EXPECT_EQ(trials.best()->code, "c");
  EXPECT_TRUE(trials.is_exact());
}

TEST(CauseTrials, ARivalOfAnotherKindThatFitsNearlyAsWellIsADoubt) {
  const OneTriangle one;
  const Examined examined(one.judged(), 1 << 20);
  const auto doubtful = [&](std::size_t best, const std::string& rival, std::size_t needless) {
    Trials trials(examined);
    EXPECT_TRUE(OneTriangle::attempt(trials, "best", best));
    OneTriangle::attempt(trials, rival, needless);
    EXPECT_EQ(trials.best()->code, "best");
    return trials.is_doubtful();
  };
  EXPECT_TRUE(doubtful(2, "rival", 3));
  EXPECT_FALSE(doubtful(2, "rival", 4)) << "twice as many";
  EXPECT_FALSE(doubtful(2, "best", 3)) << "of one kind";
  EXPECT_FALSE(doubtful(0, "rival", 0)) << "the best one is exact";
}

// Ten needless states are a fifth of fifty equal ones, but more than half of the fourteen unknown ones.
TEST(CauseTrials, AChangeThatLeavesMostUnknownStatesNeedlessExplainsNothing) {
  const OneTriangle one;
  const Examined examined(one.judged(), 1 << 20);
  Trials trials(examined);
  EXPECT_FALSE(OneTriangle::attempt(trials, "a", 10, 60));
  EXPECT_TRUE(OneTriangle::attempt(trials, "a", 4, 60));
}

}  // namespace cause_trials_test
}  // namespace mmverify::tests
