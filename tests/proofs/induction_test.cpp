// [release, night, long] The laws that a prover settles for all levels: the statements, the provers that agree, and that they can fail.
#include <gtest/gtest.h>

#include <cctype>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/kinds.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/index/induction/lemmas.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/induction/discharge.hpp"
#include "proofs/induction/paths.hpp"
#include "proofs/induction/prover.hpp"
#include "proofs/registry/registry.hpp"
#include "subjects/shaders/compile/sha256.hpp"
#include "tests/folder.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::proofs;
using namespace mmverify::tests;
using mmverify::proofs::index::induction::discharge;
using mmverify::proofs::index::induction::Provable;
using mmverify::proofs::induction::Answer;
using mmverify::proofs::induction::ask_z3;
using mmverify::proofs::induction::decided;
using mmverify::proofs::induction::Effort;
using mmverify::proofs::induction::every_path;
using mmverify::proofs::induction::on_statements;
using mmverify::proofs::induction::Statement;
using mmverify::proofs::induction::Term;
using LawRun = mmverify::proofs::Run;

/// A statement's line in the lock.
struct Locked {
  std::string sha256;
  std::uint64_t steps = 0;
  bool operator==(const Locked&) const = default;
};

std::map<std::string, Locked> locked_statements() {
  std::map<std::string, Locked> all;
  std::ifstream lock(MMVERIFY_STATEMENTS);
  for (std::string line; std::getline(lock, line);) {
    std::string name;
    Locked entry;
    if (!line.starts_with('#') && std::istringstream(line) >> name >> entry.sha256 >> entry.steps)
      all.emplace(name, entry);
  }
  return all;
}

const index::IndexSubject& subject(const char* name) {
  return dynamic_cast<const index::IndexSubject&>(*find_subject(name));
}

TEST(Statements, TheLockHasTheirSums) {
  std::map<std::string, std::string> made, locked;
  for (const auto& [name, statement] : shipped_statements())
    made.emplace(name, shaders::sha256(statement.text));
  for (const auto& [name, entry] : locked_statements()) locked.emplace(name, entry.sha256);
  EXPECT_EQ(made, locked) << "if the change is meant, run ./run statements";
}

/// Digits (0..3), the base 4, and halves (2). Of graphs: the children of a node, which a statement on N of them numbers
/// from 0 and counts, and the bits of a record and of a word.
bool is_no_level(const std::string& path, const std::string& number) {
  if (std::set<std::string>({"0", "1", "2", "3", "4", "0.0", "1.0", "2.0"}).contains(number)) return true;
  if (!path.starts_with("dag/") || number.find_first_not_of("0123456789") != std::string::npos) return false;
  if (path.ends_with("bound")) return number == "64" || number == "32";
  const std::size_t before_children = path.rfind('_');
  const std::string children = path.substr(before_children + 1);
  return before_children != std::string::npos &&
         std::set<std::string>({"4", "16", "64"}).contains(children) &&
         std::stoi(number) <= std::stoi(children);
}

// A level, or a power of two that stands for one, would be another number.
TEST(Statements, OfAllLevelsHaveNoLevel) {
  for (const auto& [path, statement] : shipped_statements()) {
    if (path.find("all_levels/") == std::string::npos) continue;
    bool comment = false;
    std::string token;
    for (const char c : statement.text) {
      if (c == ';') comment = true;
      if (c == '\n') comment = false;
      if (comment) continue;
      if (std::isspace(static_cast<unsigned char>(c)) == 0 && c != '(' && c != ')') {
        token += c;
        continue;
      }
      if (!token.empty() && std::isdigit(static_cast<unsigned char>(token.front())) != 0) {
        EXPECT_TRUE(is_no_level(path, token)) << path << ": " << token;
      }
      EXPECT_EQ(token.find("BitVec"), std::string::npos) << path;
      token.clear();
    }
  }
}

TEST(Statements, EachHypothesisHasAWitness) {
  std::set<std::string> names;
  for (const auto& [path, statement] : shipped_statements())
    names.insert((statement.expected == Answer::sat ? "sat " : "unsat ") + statement.name);
  for (const char* name :
       {"opening", "transition_hypotenuse", "transition_upright", "transition_middle", "agreement", "square"})
    EXPECT_TRUE(names.contains(std::string("unsat ") + name) &&
                names.contains(std::string("sat witness_") + name))
        << name;
  for (const char* name : {"scale", "parts", "carry", "square", "curve"})
    for (const std::string code : {"scalar_", "lanes_"})
      EXPECT_TRUE(names.contains("unsat " + code + name) &&
                  names.contains(std::string("sat witness_") + name))
          << code << name;
}

/// The first word that a program prints of a file.
std::string first_word(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  char word[64] = {};
  const bool read = std::fscanf(pipe, "%63s", word) == 1;
  pclose(pipe);
  return read ? word : "";
}

// Another team's prover, by the texts' own annotations.
TEST(Statements, Cvc5AgreesOnEveryFile) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  if (first_word("command -v cvc5").empty()) GTEST_SKIP() << "no cvc5 here (scripts/packages.txt)";
  const Folder folder;
  for (const auto& [name, statement] : shipped_statements()) {
    const std::string file = (folder / "statement.smt2").string();
    std::ofstream(file) << statement.text;
    EXPECT_EQ(first_word("cvc5 --tlimit=240000 '" + file + "'"), to_string(statement.expected)) << name;
    EXPECT_NE(statement.text.find("(set-info :status " + to_string(statement.expected) + ")"),
              std::string::npos);
  }
}

// Every statement has ten times the steps that it needs: a slow or a busy machine leaves none open.
TEST(Prover, SettlesEachStatementInATenthOfTheStepsItMayTake) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  Effort tenth;
  tenth.steps /= 10;
  for (const auto& [name, entry] : locked_statements()) EXPECT_LE(entry.steps, tenth.steps) << name;
  for (const auto& [name, statement] : shipped_statements())
    EXPECT_EQ(ask_z3(statement, tenth).answer, statement.expected) << name;
}

TEST(Prover, GivesUpAsUnknownAndSaysSo) {
  const Statement all = shipped_statements().at("index/wide_is_vulkan/agreement");
  Effort little;
  little.steps = 1;
  EXPECT_EQ(ask_z3(all, little).answer, Answer::unknown);
  Effort moment;
  moment.milliseconds = 1;
  EXPECT_EQ(ask_z3(all, moment).answer, Answer::unknown);
  EXPECT_EQ(ask_z3({"empty", Answer::unsat, "(check-sat)\n"}).answer, Answer::unknown);
  EXPECT_EQ(ask_z3({"garbage", Answer::unsat, "(assert (no such thing))"}).answer, Answer::unknown);
  EXPECT_EQ(ask_z3({"false", Answer::unsat, "(assert false)"}).answer, Answer::unsat);
  EXPECT_EQ(ask_z3({"true", Answer::sat, "(declare-const b Bool)(assert b)"}).answer, Answer::sat);
}

TEST(Discharge, UnknownIsNeverProved) {
  const auto statements = index::induction::shipped_all_levels();
  Effort little;
  little.steps = 1;
  EXPECT_THROW(discharge(statements, subject("step"), 2, LawRun{}, little), NotProved);
  try {
    discharge(statements, subject("step"), 2, LawRun{}, little);
  } catch (const NotProved& gap) {
    EXPECT_NE(std::string(gap.what()).find("unknown"), std::string::npos) << gap.what();
  }
}

TEST(Discharge, AVacuousStatementAndAModelWithoutACounterexampleAreNotProved) {
  for (const Statement& s : {Statement{"vacuous", Answer::sat, "(assert false)"},
                             Statement{"wrong", Answer::unsat, "(declare-const k Int)(assert (= k 3))"}})
    try {
      discharge({s}, subject("step"), 2, LawRun{});
      ADD_FAILURE() << s.name;
    } catch (const NotProved& gap) {
      EXPECT_NE(std::string(gap.what()).find("statement " + s.name), std::string::npos) << gap.what();
    }
}

TEST(Discharge, CutShortItHasProvedNothing) {
  struct Cleared {
    ~Cleared() { const InterruptGuard clears_what_was_raised; }
  } afterwards;
  const InterruptGuard guard;
  std::raise(SIGINT);
  EXPECT_THROW(discharge(index::induction::shipped_all_levels(), subject("step"), 2, LawRun{}), Interrupted);
}

TEST(Discharge, StatementsOfOneTextAreCasesEach) {
  const Statement one{"one", Answer::unsat, "(assert false)"},
      other{"other", Answer::unsat, "(assert false)"};
  EXPECT_EQ(discharge({one, other}, subject("step"), 1, LawRun{}).cases(), 2u);
  // Each of them is held to its own expected answer.
  const Statement wrong{"wrong", Answer::sat, "(assert false)"};
  EXPECT_THROW(discharge({one, wrong}, subject("step"), 1, LawRun{}), NotProved);
}

// A mutant that the search refutes costs no proof; a subject that is judged costs one, and so does a mutant that it
// does not find.
TEST(Discharge, AMutantIsSearchedBeforeItIsProved) {
  std::vector<std::size_t> asked;
  bool found = true;
  const Law law = on_statements(
      *find_law("index.all_levels"), {{"step", index::induction::shipped_all_levels}},
      [&](const std::vector<Statement>& statements, const Subject&, const LawRun& run) {
        asked.push_back(statements.size());
        Tally tally(run.errors);
        tally.count(Kind::interior, statements.size());
        if (found)
          tally.mismatch(Kind::interior, {}, [] { return Counterexample{{}, 3, "here", {}, "a", "b"}; });
        return tally;
      });
  const std::size_t all = index::induction::shipped_all_levels().size();
  LawRun run;
  EXPECT_EQ(run_level(law, *find_subject("step"), 0, run).verdict, Verdict::refuted);
  EXPECT_EQ(asked, std::vector<std::size_t>{all});
  asked.clear();
  const MutantResult killed = *run_mutant(law, {"a mutant", find_subject("step"), {0, 0}}, run);
  EXPECT_TRUE(killed.killed);
  EXPECT_EQ(killed.level, 3u);
  EXPECT_EQ(asked, std::vector<std::size_t>{0});
  asked.clear();
  found = false;
  EXPECT_FALSE(run_mutant(law, {"a mutant", find_subject("step"), {0, 0}}, run)->killed);
  EXPECT_EQ(asked, (std::vector<std::size_t>{0, all}));
}

TEST(Discharge, NotProvedIsIncompleteInARun) {
  Law law = *find_law("index.all_levels");
  law.judge = [](const Subject&, Level, const LawRun&) -> Tally {
    throw NotProved("statement opening: unknown");
  };
  const Result r = run_level(law, *find_subject("step"), 0, LawRun{});
  EXPECT_EQ(r.verdict, Verdict::incomplete);
  EXPECT_EQ(r.reason, "statement opening: unknown");
}

/// The names of the statements that do not come out as expected.
std::set<std::string> failing(const std::vector<Statement>& statements) {
  std::set<std::string> names;
  for (const Statement& s : statements)
    if (ask_z3(s).answer != s.expected) names.insert(s.name);
  return names;
}

// Each mutant fails where its mistake is, and nowhere else is it noticed.
TEST(Mutants, FailInTheStatementsThatTheirMistakeIsIn) {
  SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  const std::map<std::string, std::set<std::string>> expected{
      {"the hypotenuse is not handled apart", {"opening"}},
      {"iw is lowered where uf+vf > 1, not at 1", {"opening"}},
      {"b1 without t", {"transition_hypotenuse", "transition_middle", "transition_upright"}},
      {"the prefix XOR is of a bit by itself",
       {"transition_hypotenuse", "transition_middle", "transition_upright"}},
      {"the prefix XOR reaches 8 bits only", {"agreement", "prefix_xor_64"}},
      {"one bit of a mask of spread is missing", {"agreement", "spread_64"}},
      {"iv is not kept below N", {"agreement"}},
      {"the upper half of a square is not told from the lower", {"square"}},
      {"u and v exchanged", {"square"}},
      {"bit 10 of the index is lost", {"bits"}},
      {"uf+vf >= 1 of the rounded sum", {"scalar_carry", "scalar_flush"}},
      {"1-uf-vf <= 0, both rounded", {"scalar_carry", "scalar_flush"}},
      {"greater >= 1 - lesser, which rounds", {"scalar_carry", "scalar_flush"}},
      {"uN + 1 - 1", {"scalar_scale"}},
      {"whole parts of uN + 2^-25", {"scalar_parts"}},
      {"uN below 2^-23 taken for 0", {"scalar_scale"}},
      {"the rounded sum in vectors alone", {"lanes_carry", "lanes_flush"}},
      {"N - 1 - floor(uN) in the place of floor((1-u)N)", {"scalar_rows"}},
      {"the hypotenuse in a row of its own", {"scalar_rows"}},
      {"uf up to 2^-21 taken for 0", {"scalar_more"}},
      {"uf+vf > 1 of the rounded sum", {"square"}},
      {"1 - uf - vf <= 0 in binary32", {"square"}},
      {"the comparison that does not round", {"square"}},
  };
  std::size_t met = 0;
  for (const char* id : {"index.all_levels", "index.wide_is_vulkan", "index.impl_wide_is_wide",
                         "index.floats", "index.row_floats", "index.published_differs_where"})
    for (const Mutant& m : find_law(id)->mutants)
      if (const auto* own = dynamic_cast<const Provable*>(m.subject.get())) {
        EXPECT_EQ(failing(own->statements()), expected.at(m.name)) << m.name;
        ++met;
      }
  EXPECT_EQ(met, expected.size());
}

TEST(Mutants, TheAppendixsReadingsFailInTheTransitionsThatTheyChange) {
  using index::induction::all_levels_statements;
  using index::induction::Specified;
  using mmverify::spec::index::Reading;
  using Names = std::set<std::string>;
  EXPECT_EQ(failing(all_levels_statements<Specified, Reading::printed>()), Names());
  EXPECT_EQ(failing(all_levels_statements<Specified, Reading::appendix_middle>()),
            Names({"transition_middle", "transition_upright"}));
  EXPECT_EQ(failing(all_levels_statements<Specified, Reading::appendix_ties>()),
            Names({"transition_middle"}));
  EXPECT_EQ(failing(all_levels_statements<Specified, Reading::appendix_names>()),
            Names({"transition_hypotenuse", "transition_middle", "transition_upright"}));
}

TEST(Mutants, TheAppendixsReadingsAreRefutedWithTheSimplestPoint) {
  const Law& law = *find_law("index.all_levels");
  for (const char* name : {"step-appendix-middle", "step-appendix-ties", "step-appendix-names"}) {
    const Result r = run_level(law, *find_subject(name), 0, LawRun{}),
                 sweep = run_level(*find_law("index.equals_reference"), *find_subject(name), 2, LawRun{});
    EXPECT_EQ(r.verdict, Verdict::refuted) << name;
    ASSERT_FALSE(r.counterexamples.empty());
    EXPECT_EQ(r.counterexamples.front().level, 2u);
    EXPECT_EQ(r.counterexamples.front().at, sweep.counterexamples.front().at);
    EXPECT_EQ(r.cases_run(), r.cases_expected);
  }
}

TEST(Laws, ApplyToWhoTheyHaveStatementsAbout) {
  const Law& all = *find_law("index.all_levels");
  EXPECT_EQ(run_level(all, *find_subject("step"), 0, LawRun{}).verdict, Verdict::proved);
  EXPECT_EQ(run_level(all, *find_subject("step"), 0, LawRun{}).proof, "induction");
  for (const char* name : {"impl", "reference", "step-f32"})
    EXPECT_EQ(run_level(all, *find_subject(name), 0, LawRun{}).verdict, Verdict::not_applicable) << name;
}

TEST(Paths, ComeInEveryCombinationAndOnlyOnce) {
  const auto sign = [] {
    if (decided(Term("p", "Bool"))) return 1;
    return decided(Term("q", "Bool")) ? 2 : 3;
  };
  const auto paths = every_path(sign);
  ASSERT_EQ(paths.size(), 3u);
  EXPECT_EQ(paths[0].outcome + paths[1].outcome * 10 + paths[2].outcome * 100, 321);
  EXPECT_THROW(decided(Term("p", "Bool")), std::logic_error);
}

}  // namespace
