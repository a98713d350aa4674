// [release] impl/vq/vq.hpp, the paper's encoders: Algorithms 1 and 2 written down once more, from the print, over arrays
// of states and without anything of impl/, must lose as much.  Source: Compressed Opacity Maps, 4.2 and 5.2.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "impl/vq/vq.hpp"
#include "spec/vq/block.hpp"
#include "spec/vq/vq.hpp"
#include "tests/sanitized.hpp"
#include "tests/vq_cases.hpp"

namespace impl_vq_paper_test {

namespace vq = mmverify::impl::vq;
using mmverify::spec::vq::applied, mmverify::spec::vq::uniform;
using mmverify::spec::vq::encode_vector, mmverify::spec::vq::Code4;
using mmverify::spec::vq::State, mmverify::spec::vq::Transform, mmverify::spec::vq::Vector;
using mmverify::tests::blob, mmverify::tests::noise;

/// No entry holds O beside T, so the lesser part of a 2x2 that does becomes C; of two and two, O.
template <std::size_t side>
Vector<side> taken_apart(Vector<side> v) {
  for (std::size_t corner = 0; corner < side * side; ++corner) {
    if (corner % side % 2 != 0 || corner / side % 2 != 0) continue;
    const std::array<std::size_t, 4> square{corner, corner + 1, corner + side, corner + side + 1};
    const auto count = [&](State s) {
      return std::ranges::count(square, s, [&](std::size_t k) { return v[k]; });
    };
    const auto o = count(State::O), t = count(State::T);
    if (o == 0 || t == 0) continue;
    for (const std::size_t k : square)
      if (v[k] == (o > t ? State::T : State::O)) v[k] = State::C;
  }
  return v;
}

/// A vector of the map, or of the map transformed.
template <std::size_t side>
struct Vec {
  Vector<side> states, codable;
  std::size_t quadrant;
};

template <std::size_t side>
using Vecs = std::vector<Vec<side>>;

template <std::size_t side, class Map>
Vecs<side> without_uniform_vectors(const Map& map) {
  Vecs<side> vecs;
  for (std::uint32_t y = 0; y < 8; ++y)
    for (std::uint32_t x = 0; x < 8; ++x) {
      Vector<side> v{};
      for (std::uint32_t k = 0; k < side * side; ++k)
        v[k] = static_cast<State>(map[x * side + k % side + 8 * side * (y * side + k / side)]);
      if (std::ranges::count(v, v[0]) == side * side) continue;
      vecs.push_back(
          {v, taken_apart<side>(v), static_cast<std::size_t>(mmverify::spec::vq::quadrant_of(x, y))});
    }
  return vecs;
}

/// The entry of which the transform makes this vector.
template <std::size_t side>
Vector<side> undone(Transform t, const Vector<side>& v) {
  Vector<side> out{};
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const auto to = mmverify::spec::vq::moved<side>(t, {x, y});
      out[x + side * y] = v[to.x + side * to.y];
    }
  return out;
}

/// Combination 0..511: of TR in the low three bits, of BL, of BR; TL has none.
template <std::size_t side>
Vecs<side> transformed(Vecs<side> vecs, std::uint32_t combination) {
  const std::array<Transform, 4> of{Transform{}, Transform::of(combination % 8),
                                    Transform::of(combination / 8 % 8), Transform::of(combination / 64)};
  for (Vec<side>& v : vecs) {
    v.states = undone<side>(of[v.quadrant], v.states);
    v.codable = undone<side>(of[v.quadrant], v.codable);
  }
  return vecs;
}

constexpr std::uint32_t none = ~0u;

/// The O and T that became C; none where the entry says other than C and the vector.
template <std::size_t regions>
std::uint32_t substitutions(const std::array<State, regions>& v, const std::array<State, regions>& entry) {
  std::uint32_t count = 0;
  const State *from = v.data(), *to = entry.data();
  for (std::size_t k = 0; k < regions; ++k) {
    if (to[k] == from[k]) continue;
    if (to[k] != State::C) return none;
    ++count;
  }
  return count;
}

/// "each source vector is assigned the best available representative"; all C always is one.
template <std::size_t side>
std::uint32_t least_substitutions(const Vector<side>& v, const std::vector<Vector<side>>& entries) {
  std::uint32_t least = substitutions(v, uniform<side>(State::C));
  for (const auto& entry : entries) least = std::min(least, substitutions(v, entry));
  return least;
}

// ---- Algorithm 1

struct MergedVec {
  Vector<2> states{};
  std::uint32_t score = 0;
  std::array<bool, 4> quadrants{};
};

struct CodeBook {
  std::vector<Vector<2>> globals;
  std::array<std::vector<Vector<2>>, 4> quadrants;

  bool globals_full() const { return globals.size() == 3; }
  bool quadrant_full(std::size_t q) const { return quadrants[q].size() == 2; }
  bool full() const {
    return globals_full() && quadrant_full(0) && quadrant_full(1) && quadrant_full(2) && quadrant_full(3);
  }
};

/// The order of equal scores, which the print leaves open: {T, C} before {O, C}, then by which regions are
/// not C, the first weighing least.
std::uint32_t entry_number(const Vector<2>& v) {
  std::uint32_t set = 0;
  for (std::uint32_t k = 0; k < 4; ++k)
    if (v[k] != State::C) set += 1u << k;
  return std::count(v.begin(), v.end(), State::O) != 0 ? set - 1 + 14 : set - 1;
}

enum class Take { lowest, highest };

/// Prioritised by decreasing score.  Of equal scores the one with the highest entry number is taken first.
CodeBook create_code_book(std::vector<MergedVec> prioritised, Take take) {
  CodeBook cb;
  while (!cb.full() && !prioritised.empty()) {
    const std::uint32_t score = take == Take::lowest ? prioritised.back().score : prioritised.front().score;
    auto at = prioritised.begin();
    for (auto i = prioritised.begin(); i != prioritised.end(); ++i)
      if (i->score == score) at = i;
    const MergedVec v = *at;
    prioritised.erase(at);

    enum { unassigned, add_to_quadrant, add_to_global, add_to_quads } dest = unassigned;
    if (std::ranges::count(v.quadrants, true) == 1) {
      const auto q = static_cast<std::size_t>(std::ranges::find(v.quadrants, true) - v.quadrants.begin());
      if (!cb.quadrant_full(q))
        dest = add_to_quadrant;
      else if (!cb.globals_full())
        dest = add_to_global;
    } else {
      dest = cb.globals_full() ? add_to_quads : add_to_global;
    }

    // The print assigns AddToQuadrant and then forgets it; with one quadrant it is the same as AddToQuads.
    if (dest == add_to_global) cb.globals.push_back(v.states);
    if (dest == add_to_quadrant || dest == add_to_quads)
      for (std::size_t q = 0; q < 4; ++q)
        if (v.quadrants[q] && !cb.quadrant_full(q)) cb.quadrants[q].push_back(v.states);
  }
  return cb;
}

std::uint32_t evaluate_code_book(const Vecs<2>& vecs, const CodeBook& cb) {
  std::uint32_t score = 0;
  for (const Vec<2>& v : vecs)
    score += std::min(least_substitutions<2>(v.states, cb.globals),
                      least_substitutions<2>(v.states, cb.quadrants[v.quadrant]));
  return score;
}

std::uint32_t algorithm_1(const vq::Map2& map, Take take = Take::lowest) {
  std::uint32_t best_score = none;
  const Vecs<2> vecs = without_uniform_vectors<2>(map);
  for (std::uint32_t combination = 0; combination < 512 && best_score != 0; ++combination) {
    const Vecs<2> local_vecs = transformed<2>(vecs, combination);
    std::map<std::uint32_t, MergedVec> merged_vecs;  // by entry number: sorted, as OrderedVecs
    for (const Vec<2>& v : local_vecs) {
      MergedVec& merged = merged_vecs[entry_number(v.codable)];
      merged.states = v.codable;
      merged.score += static_cast<std::uint32_t>(std::count(v.codable.begin(), v.codable.end(), State::C));
      merged.quadrants[v.quadrant] = true;
    }
    std::vector<MergedVec> prioritised;
    for (const auto& [number, v] : merged_vecs) prioritised.push_back(v);
    std::stable_sort(prioritised.begin(), prioritised.end(),
                     [](const MergedVec& a, const MergedVec& b) { return a.score > b.score; });
    best_score = std::min(best_score, evaluate_code_book(local_vecs, create_code_book(prioritised, take)));
  }
  return best_score;
}

// ---- Algorithm 2

struct Member {
  Vector<4> states;
  std::uint32_t count;
};
using Members = std::vector<Member>;

struct Partition {
  Members members;
  Vector<4> rep;
  std::uint32_t score;
};

const Vector<4> all_c = uniform<4>(State::C);

/// Figure 8: C wherever the members differ.
Vector<4> compatible(const Members& members) {
  Vector<4> rep = members[0].states;
  State* of_rep = rep.data();
  for (const Member& m : members) {
    const State* of_member = m.states.data();
    for (std::size_t d = 0; d < 16; ++d)
      if (of_member[d] != of_rep[d]) of_rep[d] = State::C;
  }
  return rep;
}

/// ComputeNumSubstitutions, "if all vectors used the representative".
std::uint32_t score_of(const Members& members, const Vector<4>& rep) {
  std::uint32_t score = 0;
  for (const Member& m : members) score += m.count * substitutions(m.states, rep);
  return score;
}

/// Whether table 2 has codes for all: three that are simple, one vertical, one horizontal, eight of any kind.
bool fits_table_2(const std::vector<Vector<4>>& entries) {
  std::uint32_t vertical = 0, horizontal = 0, generic = 0;
  for (const auto& entry : entries) {
    if (encode_vector(Code4::simple, entry)) continue;
    if (encode_vector(Code4::vertical, entry))
      ++vertical;
    else if (encode_vector(Code4::horizontal, entry))
      ++horizontal;
    else
      ++generic;
  }
  return generic + (vertical > 1 ? vertical - 1 : 0) + (horizontal > 1 ? horizontal - 1 : 0) <= 8;
}

/// Whether the partition that is all C takes one of the 13 entries, as printed, or none.  Uncounted: no partition takes
/// one while the loop runs, since the print fills CB after it.
enum class AllC { takes_an_entry, is_free, uncounted };

std::vector<Vector<4>> create_code_book(const Members& merged_vecs, AllC costs) {
  std::vector<Partition> partitions{{merged_vecs, all_c, score_of(merged_vecs, all_c)}};
  const auto full = [&] {
    std::size_t entries = 0;
    for (const Partition& p : partitions) entries += costs == AllC::takes_an_entry || p.rep != all_c ? 1 : 0;
    return costs != AllC::uncounted && entries == 13;
  };
  while (!full()) {
    const auto highest = std::ranges::max_element(partitions, {}, &Partition::score);  // the first such
    const Partition p = *highest;
    if (p.score == 0) break;
    partitions.erase(highest);

    std::uint32_t best_score = none;
    Partition best_a, best_b;
    for (std::size_t d = 0; d < 16; ++d)
      for (const State apart : {State::T, State::C, State::O}) {
        Members a, b;
        for (const Member& m : p.members) (m.states[d] == apart ? a : b).push_back(m);
        if (a.empty() || b.empty()) continue;
        for (const bool a_keeps : {false, true}) {
          if (a_keeps && p.rep != all_c) continue;
          const bool b_keeps = p.rep == all_c && !a_keeps;
          const Vector<4> rep_a = a_keeps ? all_c : compatible(a), rep_b = b_keeps ? all_c : compatible(b);
          const std::uint32_t score_a = score_of(a, rep_a), score_b = score_of(b, rep_b);
          if (score_a + score_b >= best_score) continue;
          best_score = score_a + score_b;
          best_a = {a, rep_a, score_a};
          best_b = {b, rep_b, score_b};
        }
      }
    if (best_score == none) {  // one vector: nothing to split, and nothing to lose
      partitions.push_back({p.members, compatible(p.members), 0});
      continue;
    }
    partitions.push_back(best_a);
    partitions.push_back(best_b);
  }
  std::vector<Vector<4>> cb;
  for (const Partition& p : partitions) cb.push_back(p.rep);
  return cb;
}

/// The loss of one combination; none where its codebook does not fit table 2, since the paper does not say what to do
/// then.
std::uint32_t loss_of(const Vecs<4>& local_vecs, AllC costs) {
  Members merged_vecs;
  for (const auto& v : local_vecs) {
    const auto same = std::ranges::find(merged_vecs, v.codable, &Member::states);
    if (same == merged_vecs.end())
      merged_vecs.push_back({v.codable, 1});
    else
      ++same->count;
  }
  const std::vector<Vector<4>> cb = create_code_book(merged_vecs, costs);
  if (!fits_table_2(cb)) return none;
  std::uint32_t score = 0;
  for (const auto& v : local_vecs) score += least_substitutions<4>(v.states, cb);
  return score;
}

/// None where some combination's codebook does not fit.
std::uint32_t algorithm_2(const vq::Map4& map, AllC costs = AllC::takes_an_entry) {
  std::uint32_t best_score = none;
  const Vecs<4> vecs = without_uniform_vectors<4>(map);
  for (std::uint32_t combination = 0; combination < 512 && best_score != 0; ++combination) {
    const std::uint32_t score = loss_of(transformed<4>(vecs, combination), costs);
    if (score == none) return none;
    best_score = std::min(best_score, score);
  }
  return best_score;
}

// ---- Maps

template <std::size_t side, class Map>
void put(Map& map, std::uint32_t x, std::uint32_t y, const Vector<side>& v) {
  for (std::uint32_t k = 0; k < side * side; ++k)
    map[x * side + k % side + 8 * side * (y * side + k / side)] = static_cast<vq::State>(v[k]);
}

/// Some vectors of T and C, or of O and C, in many places: TL is full of them, the others have more, turned.
template <std::size_t side, class Map>
Map of_few_vectors(std::mt19937& random, std::uint32_t different, std::uint32_t more) {
  std::vector<Vector<side>> few(different, uniform<side>(State::C));
  for (std::uint32_t n = 0; n < different; ++n)
    for (State& s : few[n])
      if (random() % 3 == 0) s = n % 2 != 0 ? State::O : State::T;
  Map map;
  map.fill(vq::State::C);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  for (std::uint32_t n = 0; n < 16; ++n) put<side>(map, n % 4, 4 + n / 4, few[below(different)]);
  for (std::uint32_t n = 0; n < more; ++n) {
    const std::uint32_t at = below(48);  // below TL, or beside it
    const std::uint32_t x = at < 32 ? at % 8 : 4 + at % 4, y = at < 32 ? at / 8 : at / 4 - 4;
    const Transform turn = Transform::of(below(8));
    put<side>(map, x, y, applied<side>(turn, few[below(different)]));
  }
  return map;
}

TEST(ImplVqPaper, AlgorithmOneAgain) {
  std::mt19937 random(11);
  for (int round = 0; round < (sanitized ? 6 : 24); ++round) {
    SCOPED_TRACE(round);
    const vq::Map2 map = round % 3 == 0   ? noise<vq::Map2>(random)
                         : round % 3 == 1 ? of_few_vectors<2, vq::Map2>(random, 10, 60)
                                          : blob<vq::Map2>(random, round % 2 == 0 ? 0.1 : 1);
    ASSERT_EQ(vq::encode_paper(map).substitutions, algorithm_1(map));
    ASSERT_EQ(vq::encode_paper_highest_first(map).substitutions, algorithm_1(map, Take::highest));
  }
}

TEST(ImplVqPaper, AlgorithmTwoAgain) {
  std::mt19937 random(6);
  std::uint32_t lossy = 0, readings_differ = 0;
  for (int round = 0; round < (sanitized ? 1 : 5); ++round) {
    SCOPED_TRACE(round);
    const vq::Map4 map = round % 3 == 0 ? of_few_vectors<4, vq::Map4>(random, 24, 3)
                                        : blob<vq::Map4>(random, round % 3 == 1 ? 1 : 0.3);
    const std::uint32_t printed = algorithm_2(map), free_c = algorithm_2(map, AllC::is_free);
    ASSERT_TRUE(printed != none && free_c != none) << "the print does not say what to do; take other maps";
    ASSERT_EQ(vq::encode_paper(map).substitutions, printed);
    ASSERT_EQ(vq::encode_paper_free_c(map).substitutions, free_c);
    lossy += printed != 0 ? 1 : 0;
    readings_differ += printed != free_c ? 1 : 0;
  }
  if (sanitized) return;
  EXPECT_GE(lossy, 4u);
  EXPECT_GE(readings_differ, 2u);
}

/// All C, but TL (X < 4, Y >= 4) has these, row by row.  TL has no transform, so all combinations are alike.
vq::Map4 with_top_left(const std::vector<Vector<4>>& vectors) {
  vq::Map4 map;
  map.fill(vq::State::C);
  for (std::uint32_t n = 0; n < vectors.size(); ++n) put<4>(map, n % 4, 4 + n / 4, vectors[n]);
  return map;
}

// Worked by hand: 14 vectors of C but for a T at region k = 0..13, that of 13 three times; all C loses 16. Two of them
// have only C in common, so a split by dimension k sets vector k apart, as its own representative, and the rest stays
// all C: the split saves three for 13, else one. 13 goes first, then 0, 1, ... As printed, there are 12 partitions
// beside that of all C: 13 and 0..10. Vectors 11 and 12 are lost; where all C is free, 12 alone.
TEST(ImplVqPaper, AlgorithmTwoByHand) {
  std::vector<Vector<4>> vectors(16, uniform<4>(State::C));
  for (std::size_t n = 0; n < 16; ++n) vectors[n][std::min<std::size_t>(n, 13)] = State::T;
  const vq::Map4 map = with_top_left(vectors);
  const Vecs<4> vecs = without_uniform_vectors<4>(map);
  EXPECT_EQ(loss_of(vecs, AllC::takes_an_entry), 2u);
  EXPECT_EQ(loss_of(vecs, AllC::is_free), 1u);
  EXPECT_EQ(vq::encode_paper(map).substitutions, 2u);
  EXPECT_EQ(vq::encode_paper_free_c(map).substitutions, 1u);
}

// Read to the letter, the loop ends only where nothing is lost: 14 different vectors get 14 entries of 13.
TEST(ImplVqPaper, AlgorithmTwosLoopToTheLetterEndsWithoutLoss) {
  for (std::size_t different = 1; different <= 16; ++different) {
    Members merged(different, Member{uniform<4>(State::C), 1});
    for (std::size_t k = 0; k < different; ++k) merged[k].states[k] = State::T;
    EXPECT_EQ(create_code_book(merged, AllC::uncounted).size(), different);
  }
}

// Worked by hand: 14 vectors of T but for a C at region k = 0..13. A group of n of them keeps T in the regions where
// none has C, and loses n (n-1). The first split sets 0 apart, which stays all C and loses 15: less than 13 times 15.
// Then 1, 2, ... leave the rest, down to the four 10..13. They lose 12, fewer than 15, so it is 0's turn: it has
// nothing to split and is its own representative. 10 and 11 are the last to be set apart; 12 and 13 share the
// thirteenth entry and lose a T each. No partition is all C then, so the cost of an all-C entry does not matter.
TEST(ImplVqPaper, AlgorithmTwoByHandWithoutAllC) {
  std::vector<Vector<4>> vectors(14, uniform<4>(State::T));
  for (std::size_t k = 0; k < 14; ++k) vectors[k][k] = State::C;
  const vq::Map4 map = with_top_left(vectors);
  EXPECT_EQ(loss_of(without_uniform_vectors<4>(map), AllC::takes_an_entry), 2u);
  EXPECT_EQ(vq::encode_paper(map).substitutions, 2u);
  EXPECT_EQ(vq::encode_paper_free_c(map).substitutions, 2u);
}

}  // namespace impl_vq_paper_test
