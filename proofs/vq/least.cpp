#include "proofs/vq/maps.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;

constexpr std::uint32_t words = 32;
constexpr std::uint32_t unusable = 100;  ///< more than a vector can lose

std::uint32_t loss(const Vector<2>& from, const Vector<2>& to) {
  std::uint32_t lost = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (to[k] != C && to[k] != from[k]) return unusable;
    lost += to[k] != from[k] ? 1u : 0u;
  }
  return lost;
}

/// The losses of each word for each kind of vector in a quadrant under a transform; a uniform vector replaces the
/// word if it loses less.
using Losses = std::array<std::vector<std::uint32_t>, words>;

struct Part {
  std::vector<std::uint32_t> times;  ///< the number of vectors of each kind
  std::vector<Losses> by_transform;
};

bool no_worse(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](auto x, auto y) { return x <= y; });
}

/// The words that no other word replaces; of two with equal losses the first stays.
std::vector<std::uint32_t> not_replaced(const Losses& losses) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t w = 0; w < words; ++w) {
    bool replaced = false;
    for (std::uint32_t other = 0; other < words && !replaced; ++other)
      replaced = other != w && no_worse(losses[other], losses[w]) &&
                 (other < w || !no_worse(losses[w], losses[other]));
    if (!replaced) kept.push_back(w);
  }
  return kept;
}

Part part_of(const Map<Vq2>& map, std::size_t q) {
  std::map<Vector<2>, std::uint32_t> kinds;
  for (std::uint32_t vector = 0; vector < 64; ++vector)
    if (static_cast<std::size_t>(spec::vq::quadrant_of(vector % 8, vector / 8)) == q)
      ++kinds[vector_of<Vq2>(map, vector)];
  Part part;
  for (const auto& [v, times] : kinds) part.times.push_back(times);
  for (std::uint32_t t = 0; t < (q == 0 ? 1 : 8); ++t) {
    Losses losses;
    for (std::uint32_t w = 0; w < words; ++w)
      for (const auto& [v, times] : kinds) {
        std::uint32_t least = loss(v, spec::vq::applied<2>(Transform::of(t), spec::vq::decode_mini(w)));
        for (const State s : {T, C, O}) least = std::min(least, loss(v, spec::vq::uniform<2>(s)));
        losses[w].push_back(least);
      }
    part.by_transform.push_back(losses);
  }
  return part;
}

/// The words that may be worth sharing, by their losses in all quadrants and transforms.
std::vector<std::uint32_t> worth_sharing(const std::array<Part, 4>& functions) {
  Losses everywhere;
  for (const Part& part : functions)
    for (const Losses& losses : part.by_transform)
      for (std::uint32_t w = 0; w < words; ++w)
        everywhere[w].insert(everywhere[w].end(), losses[w].begin(), losses[w].end());
  return not_replaced(everywhere);
}

/// The least loss of a quadrant with three shared words and its own best pair.
std::uint32_t least_of(const Part& part, const std::vector<std::vector<std::uint32_t>>& own,
                       const std::array<std::uint32_t, 3>& shared) {
  std::uint32_t least = ~0u;
  const std::size_t kinds = part.times.size();
  std::vector<std::uint32_t> with(kinds), with_one(kinds);
  for (std::size_t t = 0; t < part.by_transform.size(); ++t) {
    const Losses& losses = part.by_transform[t];
    for (std::size_t k = 0; k < kinds; ++k)
      with[k] = std::min({losses[shared[0]][k], losses[shared[1]][k], losses[shared[2]][k]});
    for (std::size_t a = 0; a < own[t].size(); ++a) {
      for (std::size_t k = 0; k < kinds; ++k) with_one[k] = std::min(with[k], losses[own[t][a]][k]);
      for (std::size_t b = a; b < own[t].size(); ++b) {
        std::uint32_t lost = 0;
        for (std::size_t k = 0; k < kinds; ++k)
          lost += part.times[k] * std::min(with_one[k], losses[own[t][b]][k]);
        least = std::min(least, lost);
      }
    }
  }
  return least;
}

}  // namespace

std::uint32_t least_substitutions(const Map<Vq2>& map) {
  std::array<Part, 4> functions;
  std::array<std::vector<std::vector<std::uint32_t>>, 4> own;
  for (std::size_t q = 0; q < 4; ++q) {
    functions[q] = part_of(map, q);
    for (const Losses& losses : functions[q].by_transform) own[q].push_back(not_replaced(losses));
  }
  const std::vector<std::uint32_t> shared = worth_sharing(functions);
  std::uint32_t least = ~0u;
  for (std::size_t a = 0; a < shared.size(); ++a)
    for (std::size_t b = a; b < shared.size(); ++b)
      for (std::size_t c = b; c < shared.size(); ++c) {
        std::uint32_t lost = 0;
        for (std::size_t q = 0; q < 4 && lost < least; ++q)
          lost += least_of(functions[q], own[q], {shared[a], shared[b], shared[c]});
        least = std::min(least, lost);
      }
  return least;
}

}  // namespace mmverify::proofs::vq
