#include "subjects/source/circuit/graph.hpp"

#include <utility>

namespace mmverify::source::circuit {

Graph::Graph() { nodes_.push_back({never, never}); }

Literal Graph::input() {
  const Node n = size();
  nodes_.push_back({nothing, nothing});
  inputs_.push_back(n);
  if (watcher_ != nullptr) watcher_->input_made(n);
  return literal_of(n);
}

Literal Graph::by_operands(Literal a, Literal b) {
  if (!is_conjunction(node_of(a))) return nothing;
  const Literal p = first(node_of(a)), q = second(node_of(a));
  if (!is_negated(a)) {
    if (b == p || b == q) return a;
    if (b == negated(p) || b == negated(q)) return never;
    return nothing;
  }
  if (b == negated(p) || b == negated(q)) return b;
  if (b == p) return both(b, negated(q));
  if (b == q) return both(b, negated(p));
  return nothing;
}

Literal Graph::by_all_operands(Literal a, Literal b) const {
  if (!is_conjunction(node_of(a)) || !is_conjunction(node_of(b))) return nothing;
  const Literal p = first(node_of(a)), q = second(node_of(a));
  const Literal r = first(node_of(b)), s = second(node_of(b));
  const auto clash = [&] { return p == negated(r) || p == negated(s) || q == negated(r) || q == negated(s); };
  if (!is_negated(a) && !is_negated(b)) return clash() ? never : nothing;
  // NOT (x AND y) AND NOT (x AND NOT y) is NOT x.
  if (is_negated(a) && is_negated(b)) {
    if ((p == r && q == negated(s)) || (p == s && q == negated(r))) return negated(p);
    if ((q == r && p == negated(s)) || (q == s && p == negated(r))) return negated(q);
    return nothing;
  }
  // A plain conjunction that contradicts the negated one implies it.
  return clash() ? (is_negated(a) ? b : a) : nothing;
}

Literal Graph::by_rule(Literal a, Literal b) {
  if (a == never || a == negated(b)) return never;
  if (a == always || a == b) return b;
  if (const Literal l = by_operands(a, b); l != nothing) return l;
  if (const Literal l = by_operands(b, a); l != nothing) return l;
  return by_all_operands(a, b);
}

Literal Graph::both(Literal a, Literal b) {
  if (a > b) std::swap(a, b);
  if (const Literal l = by_rule(a, b); l != nothing) return l;
  const std::uint64_t key = std::uint64_t{a} << 32 | b;
  if (const auto at = known_.find(key); at != known_.end()) return at->second;
  const Node n = size();
  if (watcher_ != nullptr)
    if (const Literal l = watcher_->equal_to(n, a, b); l != nothing) {
      known_.emplace(key, l);
      return l;
    }
  nodes_.push_back({a, b});
  known_.emplace(key, literal_of(n));
  return literal_of(n);
}

Literal Graph::differ(Literal a, Literal b) {
  if (a <= always) return a == never ? b : negated(b);
  if (b <= always) return b == never ? a : negated(a);
  if (node_of(a) == node_of(b)) return a == b ? never : always;
  return both(negated(both(a, b)), negated(both(negated(a), negated(b))));
}

Literal Graph::chosen(Literal when, Literal a, Literal b) {
  if (when <= always) return when == always ? a : b;
  if (a == b) return a;
  if (a == negated(b)) return differ(when, b);
  if (a == always || a == when) return either(when, b);
  if (a == never || a == negated(when)) return both(negated(when), b);
  if (b == always || b == negated(when)) return either(negated(when), a);
  if (b == never || b == when) return both(when, a);
  return either(both(when, a), both(negated(when), b));
}

Literal Graph::any_of(std::vector<Literal> some) {
  if (some.empty()) return never;
  while (some.size() > 1) {
    std::size_t made = 0;
    for (std::size_t k = 0; k + 1 < some.size(); k += 2) some[made++] = either(some[k], some[k + 1]);
    if (some.size() % 2 != 0) some[made++] = some.back();
    some.resize(made);
  }
  return some.front();
}

}  // namespace mmverify::source::circuit
