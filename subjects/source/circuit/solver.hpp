// Asks a SAT solver about a graph's literals. Clauses of a node go to the solver when a question first needs them.
#pragma once

#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

#include "subjects/source/circuit/graph.hpp"

namespace CaDiCaL {
class Solver;
}

namespace mmverify::source::circuit {

enum class Answer { impossible, possible, unknown };

/// No bound on a question's conflicts.
inline constexpr int all_conflicts = -1;

class Solver {
 public:
  explicit Solver(const Graph& graph);
  ~Solver();
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Questions are `unknown` from then on.
  void stop_at(std::chrono::steady_clock::time_point deadline);

  /// Called now and then while a question takes long.
  void each_moment(std::function<void()> call);

  /// Whether some inputs make all of these literals true. `conflicts`: the effort, in conflicts of the search.
  Answer ask(std::initializer_list<Literal> all, int conflicts);

  /// States that one of these literals is true at least, for all inputs that count.
  void learn(std::initializer_list<Literal> some);

  /// After `possible`: the value of the input; false where the question did not need it.
  bool value(Node input) const;
  /// After `possible`: the question needed that node.
  bool needed(Node n) const { return n < variable_.size() && variable_[n] != 0; }

  std::uint64_t questions() const { return questions_; }

 private:
  class Clock;
  int number(Literal l);
  /// The solver's variable of a node, after the clauses of all nodes below.
  int variable(Node n);
  void define(Node n);
  void clause(std::initializer_list<int> numbers);

  const Graph& graph_;
  std::unique_ptr<CaDiCaL::Solver> solver_;
  std::unique_ptr<Clock> clock_;
  std::vector<int> variable_;  ///< by node; 0: none yet
  int variables_ = 0;
  std::uint64_t questions_ = 0;
};

}  // namespace mmverify::source::circuit
