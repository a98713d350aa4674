// Runs a program on names once for every combination of its branches.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "proofs/induction/term.hpp"

namespace mmverify::proofs::induction {

/// A branch's condition in a run, and the answer to it.
struct Decision {
  Term condition;
  bool answer;
};
using Trail = std::vector<Decision>;

/// The answer to a branch in the run that every_path has in progress on this thread: true first, and in a later run
/// false.  The prover finds out whether the conditions of a trail can hold together.
/// Outside of every_path: std::logic_error.
bool decided(const Term& condition);

/// The branches of one run, and its outcome.
template <class Outcome>
struct Path {
  Trail trail;
  Outcome outcome;
};

/// A run in progress: its answers follow the script, and are true beyond it.
class Walk {
 public:
  explicit Walk(std::vector<bool> script);
  ~Walk();
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;
  bool ask(const Term& condition);
  const Trail& trail() const { return trail_; }
  /// The script of the next walk, in which the last `true` becomes `false`; empty after the last walk.
  std::vector<bool> next() const;

 private:
  std::vector<bool> script_;
  Trail trail_;
  Walk* outer_;
};

/// Every path of a deterministic program with finitely many branches, `true` branches first.
template <class Program>
auto every_path(Program program) {
  std::vector<Path<decltype(program())>> paths;
  std::vector<bool> script;
  do {
    Walk walk(script);
    auto outcome = program();
    paths.push_back({walk.trail(), std::move(outcome)});
    script = walk.next();
  } while (!script.empty());
  return paths;
}

/// The projected outcome as one formula, with the branches as nested `ite`s.
template <class Outcome, class Project>
Term as_formula(const std::vector<Path<Outcome>>& paths, Project project) {
  const auto fold = [&](const auto& self, std::size_t first, std::size_t last, std::size_t depth) -> Term {
    const Trail& trail = paths[first].trail;
    if (depth == trail.size()) return project(paths[first].outcome);
    std::size_t turn = first;
    while (turn < last && paths[turn].trail[depth].answer) ++turn;
    return choose(trail[depth].condition, self(self, first, turn, depth + 1),
                  self(self, turn, last, depth + 1));
  };
  return fold(fold, 0, paths.size(), 0);
}

}  // namespace mmverify::proofs::induction
