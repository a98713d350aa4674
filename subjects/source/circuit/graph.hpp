// An and-inverter graph: a node is an input or the conjunction of two literals, and equal conjunctions are one node.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace mmverify::source::circuit {

using Node = std::uint32_t;
/// A node with a sign: twice the node, plus one if it is negated. Node 0 is false.
using Literal = std::uint32_t;

inline constexpr Literal never = 0, always = 1;
/// No literal: the answer where there is none.
inline constexpr Literal nothing = ~Literal{0};

constexpr Literal negated(Literal l) { return l ^ 1; }
constexpr Node node_of(Literal l) { return l >> 1; }
constexpr bool is_negated(Literal l) { return (l & 1) != 0; }
constexpr Literal literal_of(Node n) { return 2 * n; }

/// Sees each node that a graph is about to make.
class Watcher {
 public:
  virtual ~Watcher() = default;
  /// An input has become node n.
  virtual void input_made(Node n) = 0;
  /// A literal that equals a AND b for all inputs; `nothing` if none is known, and then node n is a AND b.
  virtual Literal equal_to(Node n, Literal a, Literal b) = 0;
};

class Graph {
 public:
  Graph();

  Literal input();
  /// a AND b, after rules over two levels of the graph.
  Literal both(Literal a, Literal b);
  Literal either(Literal a, Literal b) { return negated(both(negated(a), negated(b))); }
  /// a XOR b.
  Literal differ(Literal a, Literal b);
  /// a where `when` holds, else b.
  Literal chosen(Literal when, Literal a, Literal b);
  /// Some one of them; `never` of none.
  Literal any_of(std::vector<Literal> some);

  bool is_input(Node n) const { return n != 0 && nodes_[n].first == nothing; }
  bool is_conjunction(Node n) const { return n != 0 && nodes_[n].first != nothing; }
  Literal first(Node n) const { return nodes_[n].first; }
  Literal second(Node n) const { return nodes_[n].second; }
  Node size() const { return static_cast<Node>(nodes_.size()); }
  const std::vector<Node>& inputs() const { return inputs_; }

  void watch(Watcher* watcher) { watcher_ = watcher; }

 private:
  struct Operands {
    Literal first, second;
  };
  /// a AND b where it is one of a, b, a constant or an existing operand; else `nothing`.
  Literal by_rule(Literal a, Literal b);
  /// The same where a is a conjunction, or a negated one, and b anything.
  Literal by_operands(Literal a, Literal b);
  /// The same where both are.
  Literal by_all_operands(Literal a, Literal b) const;

  std::vector<Operands> nodes_;
  std::vector<Node> inputs_;
  std::unordered_map<std::uint64_t, Literal> known_;
  Watcher* watcher_ = nullptr;
};

}  // namespace mmverify::source::circuit
