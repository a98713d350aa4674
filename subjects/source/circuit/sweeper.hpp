// Merges equal nodes while a graph grows. Simulation finds candidates, a SAT solver decides.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "subjects/source/circuit/classes.hpp"
#include "subjects/source/circuit/graph.hpp"
#include "subjects/source/circuit/patterns.hpp"
#include "subjects/source/circuit/solver.hpp"

namespace mmverify::source::circuit {

struct SweepStatistics {
  std::uint64_t merged = 0, different = 0, undecided = 0;
  std::uint64_t impossible = 0, possible = 0, open = 0;
};

/// Values of all inputs, by their number in Graph::inputs().
using Inputs = std::vector<bool>;

class Sweeper : public Watcher {
 public:
  /// `merge_conflicts`: the effort for one merge. `merging`: false to make the plain graph.
  Sweeper(Graph& graph, Solver& solver, int merge_conflicts = 200, bool merging = true);

  /// The next inputs are the states of a map.
  void map(unsigned level, unsigned bits) { patterns_.map(level, bits); }

  /// Merges nodes that simulation cannot tell apart, unproved: a deliberate mistake, for a test.
  void believe_simulation() { believes_ = true; }

  /// Whether some inputs make both literals true. `impossible` becomes a clause.
  Answer both_possible(Literal a, Literal b, int conflicts);
  /// Notes in the certificate that no inputs make both true.
  void claim_never(Literal a, Literal b) { solver_.claim_never(a, b); }
  /// Inputs that count make this literal true. Values that break it are no examples from now on.
  void assume(Literal holds);
  /// Whether some inputs make all assumptions true; `possible` without one.
  Answer assumptions_possible();
  /// The inputs of the last `possible` of both_possible().
  const Inputs& example() const { return example_; }

  const SweepStatistics& statistics() const { return statistics_; }

  void input_made(Node n) override;
  Literal equal_to(Node n, Literal a, Literal b) override;

 private:
  Values values_of(Literal a, Literal b) const;
  std::uint64_t signature(const Values& values) const;
  /// The part of one word of a node's values in its signature.
  std::uint64_t share(const Values& values, std::size_t w) const;
  bool same(const Values& values, Node other, bool& inverted) const;
  /// Whether a AND b equals l.
  Answer equals(Literal a, Literal b, Literal l);
  void keep(Node n, const Values& values);
  /// Keeps the solver's inputs as a pattern; full patterns refine all classes.
  void take_model();
  void refine();
  std::uint64_t word_of(Literal l, std::size_t w) const;

  Graph& graph_;
  Solver& solver_;
  const int merge_conflicts_;
  const bool merging_;
  bool believes_ = false;
  Patterns patterns_;
  std::vector<Values> values_;  ///< by node
  Values counts_;               ///< patterns that keep all assumptions
  std::vector<Literal> assumed_;
  Classes classes_;
  std::unordered_map<std::uint64_t, Answer> asked_;
  std::vector<Inputs> models_;
  std::size_t refined_ = 0;
  Inputs example_;
  SweepStatistics statistics_;
};

}  // namespace mmverify::source::circuit
