// [release, night] tree.all_levels: its statements have witnesses and definitions that fit the specification, and they can
// fail.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/tree/checks.hpp"
#include "proofs/tree/induction/lemmas.hpp"
#include "proofs/tree/induction/provable.hpp"
#include "tests/sanitized.hpp"

namespace tree_induction_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::tree;
using namespace mmverify::proofs::tree::induction;
using mmverify::proofs::induction::Answer;
using mmverify::proofs::induction::ask_z3;
using mmverify::proofs::induction::Script;
using LawRun = mmverify::proofs::Run;

const Law& law() { return *find_law("tree.all_levels"); }

TEST(TreeStatements, EachLemmaHasItsWitness) {
  std::set<std::string> lemmas, witnesses;
  for (const Statement& s : shipped_all_levels()) {
    const bool witness = s.name.starts_with("witness_");
    EXPECT_EQ(s.expected, witness ? Answer::sat : Answer::unsat) << s.name;
    (witness ? witnesses : lemmas).insert(witness ? s.name.substr(8) : s.name);
  }
  EXPECT_EQ(lemmas, witnesses);
  for (const char* name : {"skip", "lookup", "emit", "sizes"})
    for (const char* shape : {"_leaf", "_node"})
      EXPECT_TRUE(lemmas.contains(std::string(name) + shape)) << name;
}

/// The names of the statements that do not come out as expected.
std::set<std::string> failing(const std::vector<Statement>& statements) {
  std::set<std::string> names;
  for (const Statement& s : statements)
    if (ask_z3(s).answer != s.expected) names.insert(s.name);
  return names;
}

TEST(TreeMutants, FailInTheStatementsThatTheirMistakeIsIn) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  const std::map<std::string, std::set<std::string>> expected{
      {"an internal node owes three children", {"skip_node"}},
      {"d also counts internal nodes", {"skip_node"}},
      {"the child itself is passed over", {"lookup_node"}},
      {"children are pushed first to last", {"emit_node"}},
      {"the fourth child is not looked at when merging", {"merge_keeps_map"}},
      {"nothing merges", {"merge_settles", "witness_merge_keeps_map"}},
  };
  ASSERT_EQ(law().mutants.size(), expected.size());
  for (const Mutant& m : law().mutants) {
    const auto& own = dynamic_cast<const Provable&>(*m.subject);
    EXPECT_EQ(failing(own.statements()), expected.at(m.name)) << m.name;
  }
}

// The lowest level at which each mistake can show, by hand: below an internal child for what bitscan does.
TEST(TreeMutants, AreRefutedWithTheSmallestMap) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  const std::map<std::string, mmverify::proofs::Level> expected{
      {"an internal node owes three children", 2},
      {"d also counts internal nodes", 2},
      {"the child itself is passed over", 1},
      {"children are pushed first to last", 1},
      {"the fourth child is not looked at when merging", 1},
      {"nothing merges", 1},
  };
  for (const Mutant& m : law().mutants) {
    const Result r = run_level(law(), *m.subject, 0, LawRun{});
    EXPECT_EQ(r.verdict, Verdict::refuted) << m.name;
    ASSERT_EQ(r.counterexamples.size(), 1u) << m.name;
    const Counterexample& c = r.counterexamples.front();
    EXPECT_EQ(c.level, expected.at(m.name)) << m.name;
    EXPECT_FALSE(law().replay(*m.subject, c.level, c.at).holds) << m.name;
    EXPECT_TRUE(law().replay(*find_subject("tree-spec"), c.level, c.at).holds) << m.name;
  }
}

// The loop around the mutants' turns equals the specification when the turns do.
TEST(TreeMutants, HaveNoOtherMistake) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  const TreeSubjectPtr by_turns = specified_by_turns();
  for (mmverify::proofs::Level n = 0; n <= 2; ++n)
    for (std::uint64_t k = 0; k < map_count(n); ++k) {
      const Map map = map_number(n, k);
      ASSERT_TRUE(stream_is_specified(*by_turns, map).holds) << text_of_states(map);
      ASSERT_TRUE(lookups(*by_turns, map).holds) << text_of_states(map);
      ASSERT_TRUE(round_trip(*by_turns, map).holds) << text_of_states(map);
    }
}

TEST(TreeDischarge, WhatFailsWithoutACounterexampleIsNotProved) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  const auto& spec = dynamic_cast<const TreeSubject&>(*find_subject("tree-spec"));
  for (const Statement& s : {Statement{"vacuous", Answer::sat, "(assert false)"},
                             Statement{"wrong", Answer::unsat, "(declare-const k Int)(assert (= k 3))"}})
    try {
      discharge({s}, spec, LawRun{});
      ADD_FAILURE() << s.name;
    } catch (const NotProved& gap) {
      EXPECT_NE(std::string(gap.what()).find("statement " + s.name), std::string::npos) << gap.what();
    }
  Effort little;
  little.steps = 1;
  EXPECT_THROW(discharge(shipped_all_levels(), spec, LawRun{}, little), NotProved);
}

TEST(TreeLaw, IsAboutTheSpecification) {
  const Result r = run_level(law(), *find_subject("tree-spec"), 0, LawRun{});
  EXPECT_EQ(r.verdict, Verdict::proved);
  EXPECT_EQ(r.proof, "induction");
  EXPECT_EQ(r.cases_run(), shipped_all_levels().size());
  for (const char* name : {"tree-stream", "tree-ranked", "step"})
    EXPECT_EQ(run_level(law(), *find_subject(name), 0, LawRun{}).verdict, Verdict::not_applicable) << name;
}

// ---- The statements' own definitions, on a tree worked by hand

// The root's children are T, a node of T O UT UO, UO and O; its map of level 2 is written beside it.
const mmverify::spec::micromap::States map_by_hand = [] {
  std::vector<unsigned> codes{0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 1, 1, 1, 1};
  mmverify::spec::micromap::States states;
  for (const unsigned code : codes) states.push_back(static_cast<State>(code));
  return states;
}();

constexpr char tree_by_hand[] = R"(
(declare-const T0 State) (declare-const O1 State) (declare-const UT2 State) (declare-const UO3 State)
(assert (distinct T0 O1 UT2 UO3))
(define-fun inside () Tree (node (leaf T0) (leaf O1) (leaf UT2) (leaf UO3)))
(define-fun root () Tree (node (leaf T0) inside (leaf UO3) (leaf O1)))
)";
const char* const names_by_hand[] = {"T0", "O1", "UT2", "UO3"};

Answer of_definitions(const std::string& assertions, Answer expected) {
  Script script("by_hand", expected, "");
  define_trees(script);
  define_counts(script);
  define_sequences(script);
  define_maps(script);
  script.raw(tree_by_hand + assertions);
  return ask_z3(script.finish()).answer;
}

/// Every tree in sight has its definitions asserted: its counts, and its place at each (t, d) there is.
std::string defined_everywhere() {
  std::string all;
  for (const char* tree : {"root", "inside", "(leaf T0)", "(leaf O1)", "(leaf UT2)", "(leaf UO3)"}) {
    all += fmt::format("(assert (counted {}))\n", tree);
    for (unsigned t = 0; t < 10; ++t)
      for (unsigned d = 0; d < 8; ++d) all += fmt::format("(assert (placed {} {} {}))\n", tree, t, d);
  }
  return all;
}

std::string sequences_of(const mmverify::spec::tree::Succinct& s) {
  std::string all = fmt::format("(assert (= size {}))\n", s.tree.size());
  for (std::size_t t = 0; t < s.tree.size(); ++t)
    all += fmt::format("(assert (= (internal {}) {}))\n", t, s.tree[t] ? "true" : "false");
  for (std::size_t d = 0; d < s.data.size(); ++d)
    all += fmt::format("(assert (= (data {}) {}))\n", d, names_by_hand[static_cast<std::size_t>(s.data[d])]);
  return all;
}

TEST(TreeDefinitions, StandWhereTheSpecificationEncodes) {
  auto s = mmverify::spec::tree::encode(map_by_hand, 2);
  const std::string there = defined_everywhere() + sequences_of(s);
  EXPECT_EQ(of_definitions(there, Answer::sat), Answer::sat);
  EXPECT_EQ(of_definitions(there + "(assert (not (stands root 0 0)))", Answer::unsat), Answer::unsat);
  EXPECT_EQ(of_definitions(there + "(assert (not (= (nodes root) size)))", Answer::unsat), Answer::unsat);
  EXPECT_EQ(of_definitions(fmt::format("{}(assert (not (= (leaves root) {})))", there, s.data.size()),
                           Answer::unsat),
            Answer::unsat);
  // One value or one bit changed, and it does not.
  s.data[3] = State::T;
  EXPECT_EQ(
      of_definitions(defined_everywhere() + sequences_of(s) + "(assert (stands root 0 0))", Answer::unsat),
      Answer::unsat);
  s = mmverify::spec::tree::encode(map_by_hand, 2);
  s.tree[2] = false;
  EXPECT_EQ(
      of_definitions(defined_everywhere() + sequences_of(s) + "(assert (stands root 0 0))", Answer::unsat),
      Answer::unsat);
}

TEST(TreeDefinitions, MeanTheMapDigitByDigit) {
  for (unsigned k = 0; k < 16; ++k) {
    const std::string path =
        fmt::format(
            "(declare-const p Path)(assert (= (first p) {}))(assert (= (first (rest p)) {}))\n"
            "(assert (meant root p))\n",
            k / 4, k % 4) +
        [] {
          std::string all;
          for (const char* tree : {"inside", "(leaf T0)", "(leaf O1)", "(leaf UO3)"})
            all += fmt::format("(assert (meant {} (rest p)))\n", tree);
          for (const char* tree : {"(leaf T0)", "(leaf O1)", "(leaf UT2)", "(leaf UO3)"})
            all += fmt::format("(assert (meant {} (rest (rest p))))\n", tree);
          return all;
        }();
    EXPECT_EQ(of_definitions(path, Answer::sat), Answer::sat) << k;
    EXPECT_EQ(of_definitions(fmt::format("{}(assert (not (= (state_at root p) {})))", path,
                                         names_by_hand[static_cast<std::size_t>(map_by_hand[k])]),
                             Answer::unsat),
              Answer::unsat)
        << k;
  }
}

}  // namespace tree_induction_test
