// [long] Subjects of another hand: written from the papers and the interface alone, right but for one fault.  Each fault
// is refuted by the laws that its row names; every law that they reach has three rows or mutants.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/engine/runner.hpp"
#include "proofs/index/options.hpp"
#include "proofs/registry/plugin.hpp"
#include "proofs/registry/registry.hpp"
#include "tests/foreign/attribute/subject.hpp"

namespace {

using namespace mmverify::proofs;
using LawRun = Run;  // inside a test, Run is a member function of GoogleTest's

/// A row of tests/foreign/TOPIC_faults.def: the laws that must refute the fault, "ID", or "ID@LEVEL" where those below
/// take their time; none where it takes the long tier or stands in docs/SOUNDNESS.md as a gap.
struct Fault {
  const char *topic, *name, *wrong, *laws;
};
/// The name alone: ctest reads what is printed of a parameter, and stumbles over punctuation.
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

#define MMVERIFY_FAULT(name, wrong, laws) {topic, #name, wrong, laws},
std::vector<Fault> faults_of_index() {
  static constexpr char topic[] = "index";
  return {
#include "tests/foreign/index_faults.def"
  };
}
std::vector<Fault> faults_of_micromap() {
  static constexpr char topic[] = "micromap";
  return {
#include "tests/foreign/micromap_faults.def"
  };
}
std::vector<Fault> faults_of_tree() {
  static constexpr char topic[] = "tree";
  return {
#include "tests/foreign/tree_faults.def"
  };
}
std::vector<Fault> faults_of_vq() {
  static constexpr char topic[] = "vq";
  return {
#include "tests/foreign/vq_faults.def"
  };
}
std::vector<Fault> faults_of_bake() {
  static constexpr char topic[] = "bake";
  return {
#include "tests/foreign/bake_faults.def"
  };
}
std::vector<Fault> faults_of_attribute() {
  static constexpr char topic[] = "attribute";
  return {
#include "tests/foreign/attribute_faults.def"
  };
}
std::vector<Fault> faults_of_traverse() {
  static constexpr char topic[] = "traverse";
  return {
#include "tests/foreign/traverse_faults.def"
  };
}
#undef MMVERIFY_FAULT

const std::vector<std::string> topics{"index", "micromap", "tree", "vq", "bake", "attribute", "traverse"};

std::vector<Fault> all_faults() {
  std::vector<Fault> all;
  for (const auto& of : {faults_of_index(), faults_of_micromap(), faults_of_tree(), faults_of_vq(),
                         faults_of_bake(), faults_of_attribute(), faults_of_traverse()})
    all.insert(all.end(), of.begin(), of.end());
  return all;
}

/// A law, and the one level that a row names of it, if it does.
struct Asks {
  std::string law;
  std::optional<Level> level;
};
std::vector<Asks> asked_of(const Fault& fault) {
  std::vector<Asks> all;
  std::istringstream words(fault.laws);
  for (std::string word; words >> word;) {
    const std::size_t at = word.find('@');
    if (at == std::string::npos)
      all.push_back({word, std::nullopt});
    else
      all.push_back({word.substr(0, at), static_cast<Level>(std::stoul(word.substr(at + 1)))});
  }
  return all;
}

/// Whether threads have a part in it, as its words say.
bool of_threads(const Fault& fault) {
  return std::string_view(fault.wrong).find("thread") != std::string_view::npos;
}

/// The topic's library with that fault; none where the name is empty.  Attribute micromaps are no library: most of
/// their laws ask for more than a library can offer.
std::vector<SubjectPtr> foreign(const std::string& topic, const std::string& fault, bool one_thread = false) {
  if (topic == "attribute") return {mmverify::tests::foreign::attribute::subject_with(fault)};
  setenv("MMVERIFY_WORKER", MMVERIFY_WORKER_PROGRAM, 1);
  setenv("MMVERIFY_FAULT", fault.c_str(), 1);
  if (one_thread)
    setenv("MMVERIFY_ONE_THREAD", "", 1);
  else
    unsetenv("MMVERIFY_ONE_THREAD");
  std::vector<SubjectPtr> subjects;
  for (const PluginSubject& s :
       plugin_subjects(open_library(std::string(MMVERIFY_SUBJECTS) + "/foreign_" + topic + ".so", {})))
    subjects.push_back(s.subject);
  return subjects;
}

/// The first level at which the law refutes one of the subjects, as a result.
std::optional<Result> refutation(const Asks& asks, const std::vector<SubjectPtr>& subjects) {
  const Law& law = *find_law(asks.law);
  LawRun run;
  run.options = {&index::in_fixed_point_alone};  // the slow numbers are for the right ones
  run.until_refuted = true;
  if (asks.level) {
    EXPECT_LE(*asks.level, law.tiers.fast.last) << law.id;
  }
  for (const SubjectPtr& s : subjects)
    for (Level n = asks.level.value_or(law.tiers.fast.first); n <= asks.level.value_or(law.tiers.fast.last);
         ++n) {
      Result r = run_level(law, *s, n, run);
      if (r.verdict == Verdict::refuted || r.verdict == Verdict::broken) return r;
    }
  return std::nullopt;
}

class ForeignFault : public testing::TestWithParam<Fault> {};

TEST_P(ForeignFault, IsRefutedByItsLaws) {
  const Fault& fault = GetParam();
  const std::vector<Asks> laws = asked_of(fault);
  if (laws.empty()) GTEST_SKIP() << "not in the fast tier: " << fault.wrong;
  const std::vector<SubjectPtr> subjects = foreign(fault.topic, fault.name, !of_threads(fault));
  for (const Asks& asks : laws) {
    ASSERT_NE(find_law(asks.law), nullptr) << asks.law;
    const auto found = refutation(asks, subjects);
    ASSERT_TRUE(found) << asks.law << " does not refute: " << fault.wrong;
    // A subject whose second answer differs, or that writes too much, is `broken`; the reason says where.
    if (found->verdict == Verdict::broken) {
      EXPECT_NE(found->reason, "") << asks.law;
    } else {
      EXPECT_FALSE(found->counterexamples.empty()) << asks.law;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(All, ForeignFault, testing::ValuesIn(all_faults()),
                         [](const testing::TestParamInfo<Fault>& fault) {
                           return std::string(fault.param.topic) + "_" + fault.param.name;
                         });

class RightForeigner : public testing::TestWithParam<std::string> {};

// Else a refutation would say nothing of the fault.
TEST_P(RightForeigner, PassesEveryLawAndEachKnowsThreeOfItsFaults) {
  std::map<std::string, int> rows;
  for (const Fault& fault : all_faults())
    for (const Asks& asks : asked_of(fault)) ++rows[asks.law];
  const std::vector<SubjectPtr> subjects = foreign(GetParam(), "");
  int reached = 0;
  for (const Law& law : laws()) {
    bool fits = false;
    for (const SubjectPtr& s : subjects) {
      if (!law.general || law.topic != s->topic()) continue;
      // The levels that a test can afford: a foreign library is slow. ./run prove runs every level of ours.
      const bool bakes = law.topic == "bake" || law.id.starts_with("attribute.bake_") ||
                         law.id == "attribute.face_mean_is_parent";
      const Level first = law.tiers.fast.first,
                  few = law.topic == "index" ? 5
                        : bakes              ? 0
                                             : 1,
                  last = law.method == Method::sample ? first
                                                      : std::max(first, std::min(law.tiers.fast.last, few));
      for (Level n = first; n <= last; ++n) {
        if (law.unfit(*s, n)) continue;
        fits = true;
        if (law.long_only) break;
        const Result r = run_level(law, *s, n, LawRun{});
        if (r.verdict == Verdict::not_applicable) continue;
        EXPECT_TRUE(r.verdict == Verdict::proved || r.verdict == Verdict::checked)
            << law.id << " level " << n << ": " << to_string(r.verdict) << " " << r.reason
            << (r.counterexamples.empty() ? "" : r.counterexamples.front().at);
      }
    }
    // An alternative stands in a law's place that has its rows.
    if (!fits || law.long_only || law.alternative) continue;
    ++reached;
    // A law that is younger than these libraries has mutants of its own.
    EXPECT_GE(rows[law.id] + static_cast<int>(law.mutants.size()), 3)
        << law.id << ": too few rows of tests/foreign, and mutants, name it";
  }
  EXPECT_GT(reached, 3);
}
INSTANTIATE_TEST_SUITE_P(All, RightForeigner, testing::ValuesIn(topics),
                         [](const testing::TestParamInfo<std::string>& topic) { return topic.param; });

// SOUNDNESS.md lists each fault that no law refutes.
TEST(ForeignFaults, ThoseWithoutALawStandInTheDocument) {
  std::ifstream in(MMVERIFY_SOUNDNESS);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const Fault& fault : all_faults())
    if (asked_of(fault).empty()) {
      EXPECT_NE(text.find("| `" + std::string(fault.name) + "` |"), std::string::npos) << fault.name;
    }
}

TEST(ForeignFaults, AMisspeltOneIsNoRightSubject) {
  for (const std::string& topic : topics) EXPECT_ANY_THROW(foreign(topic, "no_such_fault")) << topic;
}

}  // namespace
