// Topic vq: an encoder of 16x16 maps that needs the fewest substitutions, and what it is with one thing left out.
//
// Given the three shared entries, each quadrant is best by itself: over its transforms, the pair of own
// entries that keeps the most O and T.  So all triples are tried, and of each the best pair under each
// transform.
// Source: Compressed Opacity Maps, 4 and 4.2.
#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "tests/foreign/inside/encode.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::vq;

/// O and T kept of each of a quadrant's 16 vectors.
using Kept = std::array<std::uint8_t, 16>;

unsigned total(const Kept& kept) {
  unsigned sum = 0;
  for (const std::uint8_t k : kept) sum += k;
  return sum;
}
Kept better(Kept a, const Kept& b) {
  for (std::size_t v = 0; v < 16; ++v) a[v] = std::max(a[v], b[v]);
  return a;
}

struct Choice {
  unsigned kept = 0;
  std::uint32_t transform = 0;
  std::array<std::size_t, 2> own{};
};

class Solver {
 public:
  Solver(const Map<Vq2>& map, const Search2& search) : search_(search) {
    read(map);
    list();
  }

  Solved2 best() {
    std::array<Choice, 4> at_best{};
    std::array<std::size_t, 3> shared{};
    unsigned most = 0;
    bool any = false;
    const auto attempt = [&](std::array<std::size_t, 3> s) {
      const auto found = with(s, any ? most : 0, any);
      if (!found) return;
      unsigned kept = 0;
      for (const Choice& c : *found) kept += c.kept;
      at_best = *found;
      shared = s;
      most = kept;
      any = true;
    };
    if (search_.shared_in_turn) {
      attempt(in_turn());
    } else {
      const unsigned all = reach_[0] + reach_[1] + reach_[2] + reach_[3];
      for (std::size_t c = 2; c < entries_.size(); ++c)
        for (std::size_t b = 1; b < c; ++b)
          for (std::size_t a = 0; a < b && !(any && most == all); ++a) attempt({a, b, c});
    }
    return block(shared, at_best);
  }

 private:
  void read(const Map<Vq2>& map) {
    for (std::uint32_t q = 0; q < 4; ++q)
      for (std::uint32_t v = 0; v < 16; ++v) {
        const std::uint32_t x = v % 4 + (q % 2) * 4, y = v / 4 + (q < 2 ? 4 : 0);
        Masks m;
        for (std::uint32_t k = 0; k < 4; ++k) {
          const State s = map[2 * x + k % 2 + 16 * (2 * y + k / 2)];
          m.o |= static_cast<std::uint32_t>(s == State::O) << k;
          m.t |= static_cast<std::uint32_t>(s == State::T) << k;
        }
        known_ += static_cast<unsigned>(std::popcount(m.o | m.t));
        uniform_[q][v] = m.o == 15 || m.t == 15 ? 4 : 0;
        for (std::uint32_t t = 0; t < 8; ++t)
          source_[q][t][v] = undone(m, search_.mirrored ? t ^ (t == 3 || t == 5 ? 6 : 0) : t);
        for (std::uint32_t t = 0; t < 8; ++t) true_source_[q][t][v] = undone(m, t);
      }
  }
  /// The vector that a transform makes this one of.
  static Masks undone(const Masks& m, std::uint32_t t) {
    Masks out;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t to = taken(results[t], 2, k);
      out.o |= (m.o >> to & 1) << k;
      out.t |= (m.t >> to & 1) << k;
    }
    return out;
  }
  static unsigned keeps(const Masks& entry, const Masks& source) {
    if ((entry.o & ~source.o) != 0 || (entry.t & ~source.t) != 0) return 0;
    return static_cast<unsigned>(std::popcount(entry.o | entry.t));
  }
  bool tried(std::uint32_t q, std::uint32_t t) const {
    return q == 0 ? t == 0
                  : t == 0 || (!search_.identity_alone && !(q == search_.quadrant && t == search_.untried));
  }

  /// The entries that are of use: none that a larger one replaces wherever it fits.
  void list() {
    std::vector<Masks> every;
    for (std::uint32_t m = 1; m < 15; ++m) {
      every.push_back({m, 0});
      every.push_back({0, m});
    }
    const auto each_place = [&](const auto& holds) {
      for (std::uint32_t q = 0; q < 4; ++q)
        for (std::uint32_t t = 0; t < 8; ++t)
          for (std::uint32_t v = 0; v < 16; ++v)
            if (tried(q, t) && uniform_[q][v] == 0 && !holds(source_[q][t][v])) return false;
      return true;
    };
    for (const Masks& e : every) {
      const bool fits = !each_place([&](const Masks& s) { return keeps(e, s) == 0; });
      bool replaced = false;
      for (const Masks& f : every) {
        const bool around = (e.o & ~f.o) == 0 && (e.t & ~f.t) == 0 && (e.o != f.o || e.t != f.t);
        replaced =
            replaced ||
            (around && each_place([&](const Masks& s) { return keeps(e, s) == 0 || keeps(f, s) != 0; }));
      }
      const bool is_source = !each_place([&](const Masks& s) { return s.o != e.o || s.t != e.t; });
      if (fits && !replaced && (is_source || !search_.whole_vectors)) entries_.push_back(e);
    }
    while (entries_.size() < 5) entries_.push_back({0, 0});
    for (std::uint32_t q = 0; q < 4; ++q)
      for (std::uint32_t t = 0; t < 8; ++t) {
        if (!tried(q, t)) continue;
        auto& table = table_[q][t];
        Kept most = uniform_[q];
        for (const Masks& e : entries_) {
          Kept kept{};
          for (std::size_t v = 0; v < 16; ++v)
            kept[v] = static_cast<std::uint8_t>(keeps(e, source_[q][t][v]));
          table.push_back(kept);
          most = better(most, kept);
        }
        reach_[q] = std::max(reach_[q], total(most));
      }
  }

  /// The best of each quadrant beside three shared entries; nothing where that cannot be more than `most`.
  std::optional<std::array<Choice, 4>> with(const std::array<std::size_t, 3>& shared, unsigned most,
                                            bool any) const {
    std::array<Choice, 4> best{};
    unsigned open = reach_[0] + reach_[1] + reach_[2] + reach_[3];
    for (std::uint32_t q = 0; q < 4; ++q) {
      for (std::uint32_t t = 0; t < 8; ++t) {
        if (!tried(q, t)) continue;
        const auto& table = table_[q][t];
        const Kept kept =
            better(better(better(uniform_[q], table[shared[0]]), table[shared[1]]), table[shared[2]]);
        pair(table, kept, t, best[q]);
        if (best[q].kept == reach_[q]) break;
      }
      open -= reach_[q] - best[q].kept;
      if (any && open <= most) return std::nullopt;
    }
    return best;
  }
  void pair(const std::vector<Kept>& table, const Kept& kept, std::uint32_t t, Choice& best) const {
    const unsigned before = total(kept);
    std::array<std::pair<unsigned, std::size_t>, 28> gain;
    for (std::size_t e = 0; e < table.size(); ++e) gain[e] = {total(better(kept, table[e])) - before, e};
    const auto end = gain.begin() + static_cast<std::ptrdiff_t>(table.size());
    std::sort(gain.begin(), end, [](const auto& a, const auto& b) { return a.first > b.first; });
    if (best.kept == 0) best = {before, t, {0, 0}};
    for (auto a = gain.begin(); a != end; ++a) {
      if (search_.own_in_turn && a != gain.begin()) break;
      for (auto b = a + 1; b != end; ++b) {
        if (before + a->first + b->first <= best.kept) break;
        const unsigned sum = total(better(better(kept, table[a->second]), table[b->second]));
        if (sum > best.kept) best = {sum, t, {a->second, b->second}};
      }
    }
  }

  /// Three entries, each the best beside those before it, under identities.
  std::array<std::size_t, 3> in_turn() const {
    std::array<std::size_t, 3> chosen{};
    std::array<Kept, 4> kept = uniform_;
    for (std::size_t k = 0; k < 3; ++k) {
      unsigned most = 0;
      for (std::size_t e = 0; e < entries_.size(); ++e) {
        unsigned sum = 0;
        for (std::uint32_t q = 0; q < 4; ++q) sum += total(better(kept[q], table_[q][0][e]));
        if (sum > most) {
          most = sum;
          chosen[k] = e;
        }
      }
      for (std::uint32_t q = 0; q < 4; ++q) kept[q] = better(kept[q], table_[q][0][chosen[k]]);
    }
    return chosen;
  }

  static std::uint8_t code(const Masks& e) {
    return static_cast<std::uint8_t>((~(e.o | e.t) & 15) | (e.o != 0 ? 16u : 0u));
  }
  Solved2 block(const std::array<std::size_t, 3>& shared, const std::array<Choice, 4>& choice) const {
    Solved2 out;
    unsigned kept = 0;
    for (std::size_t k = 0; k < 3; ++k) out.block.shared[k] = code(entries_[shared[k]]);
    for (std::uint32_t q = 0; q < 4; ++q) {
      const Choice& c = choice[q];
      out.block.transforms[q] = Transform::of(c.transform);
      const std::size_t named[] = {shared[0], shared[1], shared[2], c.own[0], c.own[1]};
      for (std::size_t k = 0; k < 2; ++k) out.block.own[q][k] = code(entries_[c.own[k]]);
      for (std::uint32_t v = 0; v < 16; ++v) {
        const Masks& source = true_source_[q][c.transform][v];
        std::uint8_t index = source.o == 15 ? 2 : source.t == 15 ? 0 : 1;
        unsigned most = uniform_[q][v];
        for (std::uint8_t k = 0; k < 5; ++k)
          if (keeps(entries_[named[k]], source) > most) {
            most = keeps(entries_[named[k]], source);
            index = static_cast<std::uint8_t>(3 + k);
          }
        kept += most;
        out.block.indices[v % 4 + (q % 2) * 4 + 8 * (v / 4 + (q < 2 ? 4 : 0))] = index;
      }
    }
    out.lost = known_ - kept;
    return out;
  }

  Search2 search_;
  unsigned known_ = 0;
  std::array<Kept, 4> uniform_{};
  std::array<std::array<std::array<Masks, 16>, 8>, 4> source_{}, true_source_{};
  std::vector<Masks> entries_;
  std::array<std::array<std::vector<Kept>, 8>, 4> table_;
  std::array<unsigned, 4> reach_{};
};

}  // namespace

Solved2 solved(const Map<Vq2>& map, const Search2& search) {
  // The laws ask of the same maps again and again.
  static std::map<std::pair<Search2, Map<Vq2>>, Solved2> known;
  static std::mutex guard;
  const std::pair key(search, map);
  {
    const std::lock_guard lock(guard);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  const Solved2 answer = Solver(map, search).best();
  const std::lock_guard lock(guard);
  return known[key] = answer;
}

}  // namespace mmverify::tests::foreign
