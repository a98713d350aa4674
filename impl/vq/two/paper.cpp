#include <algorithm>
#include <map>
#include <vector>

#include "impl/vq/two/search.hpp"
#include "impl/vq/two/sets.hpp"
#include "impl/vq/vq.hpp"

// Algorithm 1, in its order and with its names.  Where the print is open: vectors are sorted by their entry's number;
// among equal scores the last one in that order is taken first, as from the end of a stably sorted list.
namespace mmverify::impl::vq {
namespace {

using namespace detail;

/// One of MergedVecs.
struct Candidate {
  Entry entry;
  std::uint32_t score = 0;
  std::array<bool, 4> quadrants{};

  bool in_one() const { return std::count(quadrants.begin(), quadrants.end(), true) == 1; }
};

/// The entry of a vector; for O beside T the entry of the greater part, T if they are equal.
Entry nearest_entry(const Sets& v) {
  return entry_of(size(v.o) > size(v.t) ? v.o : v.t, size(v.o) > size(v.t));
}

struct Codebook {
  std::vector<Entry> globals;
  std::array<std::vector<Entry>, 4> quadrants;

  bool has_room(std::uint32_t q) const { return quadrants[q].size() < 2; }
  bool full() const {
    return globals.size() == 3 && !has_room(0) && !has_room(1) && !has_room(2) && !has_room(3);
  }
};

/// Takes the last candidate first.
Codebook create_codebook(std::vector<Candidate> prioritised) {
  Codebook cb;
  while (!cb.full() && !prioritised.empty()) {
    const Candidate v = prioritised.back();
    prioritised.pop_back();
    const bool room = cb.globals.size() < 3;
    if (v.in_one()) {
      const auto q = static_cast<std::uint32_t>(std::find(v.quadrants.begin(), v.quadrants.end(), true) -
                                                v.quadrants.begin());
      if (cb.has_room(q))
        cb.quadrants[q].push_back(v.entry);
      else if (room)
        cb.globals.push_back(v.entry);
    } else if (room) {
      cb.globals.push_back(v.entry);
    } else {
      for (std::uint32_t q = 0; q < 4; ++q)
        if (v.quadrants[q] && cb.has_room(q)) cb.quadrants[q].push_back(v.entry);
    }
  }
  return cb;
}

/// The choice of a codebook; entries left free repeat one of the others.
Choice choice_of(const Codebook& cb, const std::array<std::uint8_t, 4>& transforms) {
  Choice choice;
  Entry some = 0;
  for (const auto& entries : cb.quadrants)
    if (!entries.empty()) some = entries[0];
  if (!cb.globals.empty()) some = cb.globals[0];
  choice.shared.fill(some);
  for (auto& own : choice.own) own.fill(some);
  choice.transform = transforms;
  for (std::size_t k = 0; k < cb.globals.size(); ++k) choice.shared[k] = cb.globals[k];
  for (std::size_t q = 0; q < 4; ++q)
    for (std::size_t k = 0; k < cb.quadrants[q].size(); ++k) choice.own[q][k] = cb.quadrants[q][k];
  return choice;
}

Encoded2 encoded(const Map2& map, bool highest_first) {
  const Vectors2 vectors = vectors_of(map);
  Encoded2 best{};
  bool first = true;
  for (std::uint32_t combination = 0; combination < 512; ++combination) {
    const std::array<std::uint8_t, 4> transforms{0, static_cast<std::uint8_t>(combination & 7),
                                                 static_cast<std::uint8_t>(combination >> 3 & 7),
                                                 static_cast<std::uint8_t>(combination >> 6)};
    std::map<Entry, Candidate> merged;
    for (std::uint32_t k = 0; k < 64; ++k) {
      if (vectors[k].uniform()) continue;
      const std::uint32_t q = quadrant_of_vector(k);
      const Sets v = stored(transforms[q], vectors[k]);
      const Entry e = nearest_entry(v);
      Candidate& candidate = merged[e];
      candidate.entry = e;
      candidate.score += 4 - size(set_of(e));
      candidate.quadrants[q] = true;
    }
    std::vector<Candidate> prioritised;
    for (const auto& [entry, candidate] : merged) prioritised.push_back(candidate);
    std::stable_sort(prioritised.begin(), prioritised.end(), [=](const Candidate& a, const Candidate& b) {
      return highest_first ? a.score < b.score : a.score > b.score;
    });
    const Encoded2 local = written(vectors, choice_of(create_codebook(std::move(prioritised)), transforms));
    if (first || local.substitutions < best.substitutions) best = local;
    first = false;
    if (best.substitutions == 0) break;
  }
  return best;
}

}  // namespace

Encoded2 encode_paper(const Map2& map) { return encoded(map, false); }
Encoded2 encode_paper_highest_first(const Map2& map) { return encoded(map, true); }

}  // namespace mmverify::impl::vq
