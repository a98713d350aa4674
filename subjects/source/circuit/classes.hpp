// Nodes by their signatures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "subjects/source/circuit/graph.hpp"

namespace mmverify::source::circuit {

/// The signature of each node, and the nodes of a signature: a hash table whose chains are in the order of the nodes.
/// Signatures change rarely and all at once, which costs no allocation.
class Classes {
 public:
  /// Adds node n, the next one.
  void add(Node n, std::uint64_t signature) {
    signatures_.resize(n, 0);
    signatures_.push_back(signature);
    next_.resize(signatures_.size(), none);
    if (signatures_.size() > first_.size())
      sort();
    else
      chain(n);
  }
  /// Changes the signature of each node; sort() has to follow before the next question.
  template <class Signature>
  void change(const Signature& signature_of) {
    for (Node n = 0; n < signatures_.size(); ++n) signatures_[n] = signature_of(n, signatures_[n]);
  }
  void sort() {
    std::size_t size = first_.empty() ? least : first_.size();
    while (size < signatures_.size()) size *= 2;
    first_.assign(size, none);
    last_.assign(size, none);
    for (Node n = 0; n < signatures_.size(); ++n) chain(n);
  }
  /// The nodes of a signature, in their order.
  std::vector<Node> of(std::uint64_t signature) const {
    std::vector<Node> all;
    if (first_.empty()) return all;
    for (Node n = first_[signature & (first_.size() - 1)]; n != none; n = next_[n])
      if (signatures_[n] == signature) all.push_back(n);
    return all;
  }

 private:
  static constexpr Node none = ~Node{0};
  static constexpr std::size_t least = 1024;

  void chain(Node n) {
    const std::size_t at = signatures_[n] & (first_.size() - 1);
    next_[n] = none;
    (first_[at] == none ? first_[at] : next_[last_[at]]) = n;
    last_[at] = n;
  }

  std::vector<std::uint64_t> signatures_;  ///< by node
  std::vector<Node> next_;                 ///< by node: the next one of its chain
  std::vector<Node> first_, last_;         ///< by chain
};

}  // namespace mmverify::source::circuit
