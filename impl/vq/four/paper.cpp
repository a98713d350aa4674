#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "impl/vq/four/sets.hpp"
#include "impl/vq/vq.hpp"

// Algorithm 2, in its order and with its names.  Where the print is open: among partitions with one score the oldest is
// taken, among splits with one score the first tried.  A partition with nothing left to split is represented by its
// only vector.  O beside T is taken apart before (codable), as no representative could hold both.  In the end every
// vector gets its best representative, as in section 4.2.
namespace mmverify::impl::vq {
namespace {

using namespace detail;

struct Member {
  Set4 v;
  std::uint32_t count;  ///< number of the merged vectors
};

/// The data for the score of a set of vectors.
struct Sum {
  Set4 common = ~Set4{0};
  std::uint32_t vectors = 0, states = 0;  ///< their number, and the number of their O and T

  void add(const Member& m) {
    common &= m.v;
    vectors += m.count;
    states += m.count * size(m.v);
  }
  /// The substitutions if all vectors used the best compatible vector, or all C.
  std::uint32_t score(bool all_c) const { return states - (all_c ? 0 : vectors * size(common)); }
};

struct Partition {
  std::vector<Member> members;
  bool all_c = false;
  Set4 rep = 0;
  std::uint32_t score = 0;
};

Partition partition_of(std::vector<Member> members, bool all_c) {
  Sum sum;
  for (const Member& m : members) sum.add(m);
  return {std::move(members), all_c, all_c ? 0 : sum.common, sum.score(all_c)};
}

/// The state of one region of a set: T, C or O.
State state_at(Set4 v, std::uint32_t dimension) {
  return (v >> dimension & 1) != 0 ? State::T : (v >> (16 + dimension) & 1) != 0 ? State::O : State::C;
}

/// The best two parts of a partition of more than one vector.
std::pair<Partition, Partition> best_parts(const Partition& p) {
  std::uint32_t best_score = std::numeric_limits<std::uint32_t>::max(), best_d = 0;
  State best_apart = State::T;
  bool best_a_keeps = false;
  for (std::uint32_t d = 0; d < 16; ++d) {
    std::array<Sum, 3> of_state;
    for (const Member& m : p.members) of_state[static_cast<std::size_t>(state_at(m.v, d))].add(m);
    for (std::size_t apart = 0; apart < 3; ++apart) {
      const Sum& a = of_state[apart];
      Sum b;
      for (std::size_t other = 0; other < 3; ++other)
        if (other != apart) {
          b.common &= of_state[other].common;
          b.vectors += of_state[other].vectors;
          b.states += of_state[other].states;
        }
      if (a.vectors == 0 || b.vectors == 0) continue;
      // Without an all-C entry to pass on, both choices are the same.
      for (const bool a_keeps : {false, true}) {
        if (a_keeps && !p.all_c) continue;
        const std::uint32_t score = a.score(p.all_c && a_keeps) + b.score(p.all_c && !a_keeps);
        if (score >= best_score) continue;
        best_score = score;
        best_d = d;
        best_apart = static_cast<State>(apart);
        best_a_keeps = a_keeps;
      }
    }
  }
  std::vector<Member> a, b;
  for (const Member& m : p.members) (state_at(m.v, best_d) == best_apart ? a : b).push_back(m);
  return {partition_of(std::move(a), p.all_c && best_a_keeps),
          partition_of(std::move(b), p.all_c && !best_a_keeps)};
}

/// Creates the codebook.  The print gives each partition an entry, also the one that is all C.
std::vector<Set4> create_codebook(std::vector<Member> merged, bool c_is_free) {
  std::vector<Partition> partitions{partition_of(std::move(merged), true)};
  const auto taken = [&] {
    return static_cast<std::size_t>(std::count_if(
        partitions.begin(), partitions.end(), [=](const Partition& p) { return !(p.all_c && c_is_free); }));
  };
  while (taken() < stored_entries) {
    const auto highest =
        std::max_element(partitions.begin(), partitions.end(),
                         [](const Partition& a, const Partition& b) { return a.score < b.score; });
    if (highest->score == 0) break;
    const Partition p = *highest;
    partitions.erase(highest);
    if (p.members.size() == 1) {
      partitions.push_back(partition_of(p.members, false));
      continue;
    }
    auto [a, b] = best_parts(p);
    partitions.push_back(std::move(a));
    partitions.push_back(std::move(b));
  }
  std::vector<Set4> codebook, sources;
  for (const Partition& p : partitions) {
    if (!p.all_c && p.rep != 0) codebook.push_back(p.rep);
    for (const Member& m : p.members) sources.insert(sources.end(), m.count, m.v);
  }
  fit_places(codebook, sources);
  return codebook;
}

Encoded4 encoded(const Map4& map, bool c_is_free) {
  const Vectors4 vectors = vectors_of(map);
  std::array<std::array<Set4, 8>, 64> as_stored;
  for (std::uint32_t k = 0; k < 64; ++k) as_stored[k] = stored(codable(vectors[k]));
  Encoded4 best{};
  for (std::uint32_t number = 0; number < 512; ++number) {
    const Transforms transforms = combination(number);
    std::map<Set4, std::uint32_t> counts;
    for (std::uint32_t k = 0; k < 64; ++k)
      if (const Set4 v = as_stored[k][transforms[quadrant_of_vector4(k)]]; !uniform(v)) ++counts[v];
    std::vector<Member> merged;
    for (const auto& [v, count] : counts) merged.push_back({v, count});
    const Encoded4 local =
        written(vectors, transforms,
                merged.empty() ? std::vector<Set4>{} : create_codebook(std::move(merged), c_is_free));
    if (number == 0 || local.substitutions < best.substitutions) best = local;
    if (best.substitutions == 0) break;
  }
  return best;
}

}  // namespace

Encoded4 encode_paper(const Map4& map) { return encoded(map, false); }
Encoded4 encode_paper_free_c(const Map4& map) { return encoded(map, true); }

}  // namespace mmverify::impl::vq
