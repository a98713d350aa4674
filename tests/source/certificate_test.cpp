// Certificates of proofs: a right one is accepted, and each damage of it is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "proofs/certificate/checker.hpp"
#include "proofs/certificate/statements.hpp"

namespace mmverify {
namespace {

using proofs::certificate::check;
using proofs::certificate::NotValid;
using proofs::certificate::Proved;

/// x AND y twice, by two nodes, and the claim that they never differ.
const std::vector<std::string> same_twice{"i 1 0",     "i 2 0",    "n 3 1 2 0", "n 4 -1 -2 0", "n 5 -4 1 0",
                                          "n 6 5 2 0", "m -6 3 0", "m 6 -3 0",  "n 7 3 -6 0",  "o -7 -7 0"};

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}
Proved checked(const std::string& text) {
  std::istringstream in(text);
  return check(in);
}
std::string refusal_of(const std::vector<std::string>& lines) {
  try {
    checked(text_of(lines));
  } catch (const NotValid& why) {
    return why.what();
  }
  return "accepted";
}

TEST(Certificate, RightOneIsAccepted) {
  const Proved proved = checked(text_of(same_twice));
  EXPECT_EQ(proved.inputs, 2u);
  EXPECT_EQ(proved.nodes, 5u);
  EXPECT_EQ(proved.steps, 2u);
  EXPECT_EQ(proved.claims, 1u);
  EXPECT_EQ(proved.assumptions, 0u);
}

TEST(Certificate, DamageIsFound) {
  const auto with = [](std::size_t at, const std::string& line) {
    std::vector<std::string> lines = same_twice;
    lines[at] = line;
    return refusal_of(lines);
  };
  EXPECT_EQ(with(6, "m -6 4 0"), "line 7: the clause does not follow by unit propagation");
  EXPECT_EQ(with(4, "n 5 4 1 0"), "line 8: the clause does not follow by unit propagation");
  EXPECT_EQ(with(9, "o 7 7 0"), "line 10: the clause does not follow by unit propagation");
  EXPECT_EQ(with(9, "o -7 0"), "line 10: the step has 1 numbers, not 2");
  EXPECT_EQ(with(2, "n 3 1 9 0"), "line 3: variable 9 has no line before");
  EXPECT_EQ(with(3, "n 3 -1 -2 0"), "line 4: variable 3 has a second line");
  EXPECT_EQ(with(5, "n 6 6 2 0"), "line 6: variable 6 has no line before");
  EXPECT_EQ(with(0, "i -1 0"), "line 1: it names no variable");
  EXPECT_EQ(with(7, "m 6 -3"), "line 8: a step is numbers with a 0 at the end");
  EXPECT_EQ(with(7, "x 6 -3 0"), "line 8: no step begins with 'x'");
  EXPECT_EQ(with(7, "m 6 -999999999999 0"), "line 8: a variable beyond 268435456");
  EXPECT_EQ(with(1, "i 2 0 0"), "line 2: a step is numbers with a 0 at the end");
}

TEST(Certificate, DeletedClauseIsGone) {
  std::vector<std::string> lines{"i 1 0",    "i 2 0",    "n 3 1 2 0", "m -3 1 0",
                                 "d -3 1 0", "d -3 1 0", "m -3 1 0"};
  EXPECT_EQ(refusal_of(lines), "line 7: the clause does not follow by unit propagation");
  lines[5] = "d -3 2 0";
  EXPECT_EQ(refusal_of(lines), "accepted");
}

TEST(Certificate, AssumptionsAreCounted) {
  const Proved proved = checked("i 1 0\ni 2 0\nn 3 1 2 0\na -3 0\na 1 0\no -2 -2 0\n");
  EXPECT_EQ(proved.assumptions, 2u);
}

// All pairs of a function's four values: the clauses of a circuit, by the circuit itself.
TEST(Certificate, AcceptsWhatHoldsAndNothingElse) {
  const std::string circuit = "i 1 0\ni 2 0\nn 3 1 -2 0\nn 4 -1 2 0\nn 5 -3 -4 0\n";
  for (const int a : {1, -1, 2, -2, 3, -3, 4, -4, 5, -5})
    for (const int b : {1, -1, 2, -2, 3, -3, 4, -4, 5, -5}) {
      bool holds = true;
      for (unsigned inputs = 0; inputs < 4; ++inputs) {
        const bool x = (inputs & 1) != 0, y = (inputs & 2) != 0;
        const bool values[] = {false, x, y, x && !y, !x && y, x == y};
        const auto value = [&](int l) { return l > 0 ? values[l] : !values[-l]; };
        holds = holds && (value(a) || value(b));
      }
      bool accepted = true;
      try {
        checked(circuit + "o " + std::to_string(a) + " " + std::to_string(b) + " 0\n");
      } catch (const NotValid&) {
        accepted = false;
      }
      EXPECT_TRUE(holds || !accepted) << a << " " << b;
    }
}

/// Whether some values satisfy a DIMACS text, by trying all.
bool satisfiable(const std::string& dimacs) {
  std::istringstream in(dimacs);
  std::string p, cnf;
  unsigned variables = 0, count = 0;
  in >> p >> cnf >> variables >> count;
  std::vector<std::vector<int>> clauses(count);
  for (std::vector<int>& clause : clauses)
    for (int l = 0; in >> l && l != 0;) clause.push_back(l);
  EXPECT_LT(variables, 20u);
  for (unsigned values = 0; values < 1u << variables; ++values)
    if (std::all_of(clauses.begin(), clauses.end(), [&](const std::vector<int>& clause) {
          return std::any_of(clause.begin(), clause.end(),
                             [&](int l) { return ((values >> (std::abs(l) - 1) & 1) != 0) == (l > 0); });
        }))
      return true;
  return false;
}

/// The questions about all statements, and about each one.
std::vector<bool> questions_satisfiable(const std::vector<std::string>& lines) {
  std::istringstream in(text_of(lines));
  const proofs::certificate::Statements statements(in);
  std::vector<bool> all;
  std::ostringstream whole;
  statements.write_all(whole);
  all.push_back(satisfiable(whole.str()));
  for (std::size_t k = 0; k < statements.size(); ++k) {
    std::ostringstream one;
    statements.write_one(one, k);
    all.push_back(satisfiable(one.str()));
  }
  return all;
}

TEST(SecondQuestion, HasNoValuesIfTheStatementHolds) {
  EXPECT_EQ(questions_satisfiable(same_twice), std::vector<bool>(4, false));
  // The solver's own steps and what it deletes are no part of it.
  std::vector<std::string> more = same_twice;
  more.insert(more.begin() + 6, {"3 0", "d 3 0"});
  EXPECT_EQ(questions_satisfiable(more), std::vector<bool>(4, false));
}

TEST(SecondQuestion, HasValuesIfAStatementIsWrong) {
  std::vector<std::string> wrong = same_twice;
  wrong[7] = "m 6 3 0";
  EXPECT_EQ(questions_satisfiable(wrong), (std::vector<bool>{true, false, true, false}));
  wrong = same_twice;
  wrong[9] = "o 7 7 0";
  EXPECT_EQ(questions_satisfiable(wrong), (std::vector<bool>{true, false, false, true}));
  // Under the assumption that y is false, x AND y never holds.
  EXPECT_EQ(questions_satisfiable({"i 1 0", "i 2 0", "n 3 1 2 0", "o -3 -3 0"}),
            (std::vector<bool>{true, true}));
  EXPECT_EQ(questions_satisfiable({"i 1 0", "i 2 0", "n 3 1 2 0", "a -2 0", "o -3 -3 0"}),
            (std::vector<bool>{false, false}));
}

TEST(SecondQuestion, RefusesWhatIsNoStep) {
  for (const char* text : {"n 3 1 0\n", "m 3\n", "i x 0\n", "o 0\n"}) {
    std::istringstream in(text);
    EXPECT_THROW(proofs::certificate::Statements{in}, NotValid) << text;
  }
}

}  // namespace
}  // namespace mmverify
