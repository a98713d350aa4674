#include <algorithm>
#include <bitset>
#include <vector>

#include "impl/vq.hpp"
#include "impl/vq4_bound.hpp"
#include "impl/vq4_search.hpp"
#include "impl/vq4_sets.hpp"

namespace mmverify::impl::vq {
namespace {

using namespace detail;

class Search {
 public:
  explicit Search(const Map4& map) : vectors_(vectors_of(map)) {
    for (std::uint32_t k = 0; k < 64; ++k) {
      if (uniform(vectors_[k])) continue;
      sources_.push_back({quadrant_of_vector4(k), stored(vectors_[k]), stored(codable(vectors_[k]))});
    }
    best_ = written(vectors_, {}, {});
    all_ = best_.substitutions;
  }

  /// Choices of transforms by merging, those with the fewest distinct vectors first; the best by exchanging.
  Encoded4 run(Effort effort) {
    const std::size_t merges = effort == Effort::fast ? 96 : 512;
    const std::size_t exchanges = effort == Effort::fast ? 2 : effort == Effort::balanced ? 64 : 512;
    for (const auto& [distinct, number] : by_distinct_vectors()) {
      // A map that fits has few under some choice, and is found whatever the effort.
      if (found_.size() >= merges && distinct > stored_entries) break;
      found_.push_back({merged(sources(number)), number});
      take(found_.back());
      if (best_.substitutions == 0) return best_;
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Found& a, const Found& b) { return a.codebook.kept > b.codebook.kept; });
    for (std::size_t k = 0; k < std::min(exchanges, found_.size()) && best_.substitutions != 0; ++k) {
      exchange(sources(found_[k].number), found_[k].codebook);
      take(found_[k]);
    }
    return best_;
  }

  /// And a bound for every choice, whose prices name entries to begin with once more.
  Proved4 prove() {
    run(Effort::thorough);
    std::uint32_t most = 0;
    Bounded4 bounded;
    for (std::size_t k = 0; k < found_.size() && best_.substitutions != 0; ++k) {
      const Transforms transforms = combination(found_[k].number);
      for (std::size_t s = 0; s < sources_.size(); ++s) {
        bounded.v[s] = sources_[s].stored[transforms[sources_[s].quadrant]];
        bounded.most[s] = static_cast<std::int32_t>(size(sources_[s].codable[0]));
      }
      Codebook4& codebook = found_[k].codebook;
      const std::uint32_t bound = most_kept(bounded, codebook.entries, all_ - best_.substitutions);
      if (bound > all_ - best_.substitutions) {
        exchange(sources(found_[k].number), codebook);
        take(found_[k]);
      }
      most = std::max(most, bound);
    }
    return {best_, std::min(best_.substitutions, all_ - std::min(most, all_))};
  }

 private:
  struct Source {
    std::uint32_t quadrant;
    std::array<Set4, 8> stored, codable;  ///< by transform
  };
  struct Found {
    Codebook4 codebook;
    std::uint32_t number;  ///< of the transforms
  };

  Sources4 sources(std::uint32_t number) const {
    const Transforms transforms = combination(number);
    Sources4 of;
    for (const Source& source : sources_) of.v[of.count++] = source.codable[transforms[source.quadrant]];
    return of;
  }

  /// Each choice of transforms with how many distinct vectors it leaves, in that order.
  std::vector<std::pair<std::size_t, std::uint32_t>> by_distinct_vectors() const {
    std::vector<Set4> all;
    for (const Source& source : sources_) all.insert(all.end(), source.codable.begin(), source.codable.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::array<std::array<std::bitset<512>, 8>, 4> of;  // 64 vectors under 8 transforms at most
    for (const Source& source : sources_)
      for (std::size_t t = 0; t < 8; ++t)
        of[source.quadrant][t].set(static_cast<std::size_t>(
            std::lower_bound(all.begin(), all.end(), source.codable[t]) - all.begin()));
    std::vector<std::pair<std::size_t, std::uint32_t>> order;
    for (std::uint32_t number = 0; number < 512; ++number) {
      const Transforms t = combination(number);
      order.emplace_back((of[0][0] | of[1][t[1]] | of[2][t[2]] | of[3][t[3]]).count(), number);
    }
    std::sort(order.begin(), order.end());
    return order;
  }

  void take(const Found& found) {
    if (found.codebook.kept <= all_ - best_.substitutions) return;
    std::vector<Set4> entries = found.codebook.entries;
    const Sources4 from = sources(found.number);
    fit_places(entries, std::span(from.v).first(from.count));
    const Encoded4 now = written(vectors_, combination(found.number), entries);
    if (now.substitutions < best_.substitutions) best_ = now;
  }

  Vectors4 vectors_;
  std::vector<Source> sources_;  ///< of the vectors that are not uniform
  std::vector<Found> found_;
  Encoded4 best_;
  std::uint32_t all_ = 0;  ///< O and T of the sources
};

}  // namespace

Encoded4 encode(const Map4& map, Effort effort) { return Search(map).run(effort); }

Proved4 encode_proved(const Map4& map) { return Search(map).prove(); }

}  // namespace mmverify::impl::vq
