#include "subjects/source/circuit/sweeper.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace mmverify::source::circuit {
namespace {

/// Members of a class that are tried for one node.
constexpr int tried_most = 2;
/// Models that make a new word of patterns: more in large graphs, in which a word costs more.
constexpr std::size_t least_models = 16, most_models = 64, nodes_a_model = 8192;

/// Nodes of a large graph.
constexpr std::size_t large = 40000;

constexpr std::uint64_t ones = ~std::uint64_t{0};

}  // namespace

Sweeper::Sweeper(Graph& graph, Solver& solver, int merge_conflicts, bool merging)
    : graph_(graph), solver_(solver), merge_conflicts_(merge_conflicts), merging_(merging) {
  for (std::uint64_t& word : counts_.words) word = ones;
  values_.push_back({});
  keep(0, values_.front());
  graph_.watch(this);
}

std::uint64_t Sweeper::word_of(Literal l, std::size_t w) const {
  return values_[node_of(l)].words[w] ^ (is_negated(l) ? ones : 0);
}

Values Sweeper::values_of(Literal a, Literal b) const {
  Values values;
  for (std::size_t w = 0; w < pattern_words; ++w) values.words[w] = word_of(a, w) & word_of(b, w);
  return values;
}

// A literal and its negation have one signature: the first pattern's value is taken for false.
std::uint64_t Sweeper::share(const Values& values, std::size_t w) const {
  const std::uint64_t flip = (values.words[0] & 1) != 0 ? ones : 0;
  std::uint64_t hash = ((values.words[w] ^ flip) & counts_.words[w]) + (w + 1) * 0x9e3779b97f4a7c15;
  hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9;
  hash = (hash ^ hash >> 27) * 0x94d049bb133111eb;
  return hash ^ hash >> 31;
}

std::uint64_t Sweeper::signature(const Values& values) const {
  std::uint64_t hash = 0;
  for (std::size_t w = 0; w < pattern_words; ++w) hash ^= share(values, w);
  return hash;
}

bool Sweeper::same(const Values& values, Node other, bool& inverted) const {
  inverted = ((values.words[0] ^ values_[other].words[0]) & 1) != 0;
  const std::uint64_t flip = inverted ? ones : 0;
  for (std::size_t w = 0; w < pattern_words; ++w)
    if (((values.words[w] ^ values_[other].words[w] ^ flip) & counts_.words[w]) != 0) return false;
  return true;
}

void Sweeper::keep(Node n, const Values& values) { classes_.add(n, signature(values)); }

void Sweeper::input_made(Node n) {
  values_.resize(n);
  values_.push_back(patterns_.next());
  keep(n, values_.back());
}

Answer Sweeper::equals(Literal a, Literal b, Literal l) {
  for (const auto& all :
       {std::array{a, b, negated(l)}, std::array{l, negated(a), always}, std::array{l, negated(b), always}}) {
    const Answer got = solver_.ask({all[0], all[1], all[2]}, merge_conflicts_);
    if (got != Answer::impossible && !believes_) return got;
  }
  solver_.learn({negated(a), negated(b), l});
  solver_.learn({negated(l), a});
  solver_.learn({negated(l), b});
  return Answer::impossible;
}

Literal Sweeper::equal_to(Node n, Literal a, Literal b) {
  Values values = values_of(a, b);
  // In a large graph a node that is merely rare is taken for `never` too often: each such question costs a model of all.
  const bool rare = values_.size() > large && signature(values) == signature(values_[0]);
  if (merging_ && !rare) {
    int tried = 0;
    // A model may refine the classes, so a candidate is found anew each time.
    const std::vector<Node> candidates = classes_.of(signature(values));
    for (const Node other : candidates) {
      bool inverted = false;
      if (!same(values, other, inverted)) continue;
      if (++tried > tried_most) break;
      const Literal l = literal_of(other) ^ (inverted ? 1U : 0U);
      const Answer got = equals(a, b, l);
      if (got == Answer::impossible) {
        ++statistics_.merged;
        return l;
      }
      if (got == Answer::possible) {
        ++statistics_.different;
        take_model();
        values = values_of(a, b);
      } else {
        ++statistics_.undecided;
      }
    }
  }
  values_.resize(n);
  values_.push_back(values);
  keep(n, values);
  return nothing;
}

void Sweeper::take_model() {
  const std::vector<Node>& inputs = graph_.inputs();
  Inputs model(inputs.size());
  for (std::size_t k = 0; k < inputs.size(); ++k)
    model[k] = solver_.needed(inputs[k]) ? solver_.value(inputs[k]) : (patterns_.random() & 1) != 0;
  models_.push_back(std::move(model));
  if (models_.size() >= std::min(most_models, least_models + values_.size() / nodes_a_model)) refine();
}

void Sweeper::refine() {
  const std::size_t w = pattern_words / 2 + refined_++ % (pattern_words / 2);
  const std::vector<Node>& inputs = graph_.inputs();
  classes_.change([&](Node n, std::uint64_t all) { return all ^ share(values_[n], w); });
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 64; ++k) {
      const Inputs& model = models_[k % models_.size()];
      bool bit = i < model.size() ? model[i] : (patterns_.random() & 1) != 0;
      // Neighbours of a model: some of its bits turned.
      if (k >= models_.size() && patterns_.random() % 32 == 0) bit = !bit;
      word |= std::uint64_t{bit} << k;
    }
    values_[inputs[i]].words[w] = word;
  }
  models_.clear();
  for (Node n = 1; n < values_.size(); ++n)
    if (graph_.is_conjunction(n))
      values_[n].words[w] = word_of(graph_.first(n), w) & word_of(graph_.second(n), w);
  counts_.words[w] = ones;
  for (const Literal l : assumed_) counts_.words[w] &= word_of(l, w);
  classes_.change([&](Node n, std::uint64_t rest) { return rest ^ share(values_[n], w); });
  classes_.sort();
}

Answer Sweeper::both_possible(Literal a, Literal b, int conflicts) {
  if (a == never || b == never || a == negated(b)) return Answer::impossible;
  const std::vector<Node>& inputs = graph_.inputs();
  for (std::size_t w = 0; w < pattern_words; ++w)
    if (const std::uint64_t hits = word_of(a, w) & word_of(b, w) & counts_.words[w]; hits != 0) {
      const int bit = std::countr_zero(hits);
      example_.resize(inputs.size());
      for (std::size_t k = 0; k < inputs.size(); ++k)
        example_[k] = (values_[inputs[k]].words[w] >> bit & 1) != 0;
      return Answer::possible;
    }
  const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  if (const auto at = asked_.find(key); at != asked_.end() && at->second == Answer::impossible)
    return at->second;
  const Answer got = solver_.ask({a, b}, conflicts);
  if (got == Answer::possible) {
    ++statistics_.possible;
    example_.resize(inputs.size());
    for (std::size_t k = 0; k < inputs.size(); ++k) example_[k] = solver_.value(inputs[k]);
    take_model();
  } else if (got == Answer::impossible) {
    ++statistics_.impossible;
    solver_.learn({negated(a), negated(b)});
  } else {
    ++statistics_.open;
  }
  asked_[key] = got;
  return got;
}

Answer Sweeper::assumptions_possible() {
  for (const std::uint64_t word : counts_.words)
    if (word != 0) return Answer::possible;
  // The assumptions are clauses: the solver has to keep them.
  return solver_.ask({always}, all_conflicts);
}

void Sweeper::assume(Literal holds) {
  assumed_.push_back(holds);
  solver_.assume(holds);
  for (std::size_t w = 0; w < pattern_words; ++w) counts_.words[w] &= word_of(holds, w);
  classes_.change([&](Node n, std::uint64_t) { return signature(values_[n]); });
  classes_.sort();
}

}  // namespace mmverify::source::circuit
