// Asks a SAT solver about a graph's literals. Clauses of a node go to the solver when a question first needs them.
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
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

  /// Adds the clause that one of these literals is true, which follows from the last question's answer.
  void learn(std::initializer_list<Literal> some);
  /// Inputs that make the literal false count no more.
  void assume(Literal holds);

  /// Writes each step from now on, and the graph's nodes, in the form of proofs/certificate/checker.hpp. The file
  /// outlives the solver. Call it before the first question.
  void write_certificate(std::FILE* file);
  /// Writes the claim that no inputs make both true.
  void claim_never(Literal a, Literal b);

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
  /// Writes a line of the certificate, if there is one.
  void write(char kind, std::span<const int> numbers);

  const Graph& graph_;
  std::unique_ptr<CaDiCaL::Solver> solver_;
  std::unique_ptr<Clock> clock_;
  std::FILE* certificate_ = nullptr;
  std::vector<int> variable_;  ///< by node; 0: none yet
  int variables_ = 0;
  std::uint64_t questions_ = 0;
};

}  // namespace mmverify::source::circuit
