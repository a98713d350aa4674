#include <algorithm>
#include <bitset>
#include <vector>

#include "impl/vq/four/bound.hpp"
#include "impl/vq/four/search.hpp"
#include "impl/vq/four/sets.hpp"
#include "impl/vq/vq.hpp"

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

  /// Each effort begins with all steps of the lower one, and so is never worse.
  Encoded4 run(Effort effort) {
    order_ = by_distinct_vectors();
    merge(fast_merges);
    exchange_best(fast_exchanges);
    if (effort == Effort::fast) return best_;
    merge(order_.size());
    exchange_best(balanced_exchanges);
    if (effort == Effort::thorough) exchange_best(found_.size());
    return best_;
  }

  /// Computes also a bound for every choice of transforms; the bound's prices name entries for one more exchange.
  Proved4 prove() {
    run(Effort::thorough);
    // The best choices come first: their results make the bounds of the others easier.
    std::stable_sort(found_.begin(), found_.end(), [](const CodebookChoice& a, const CodebookChoice& b) {
      return a.codebook.kept > b.codebook.kept;
    });
    std::uint32_t most = 0;
    Bounded4 bounded;
    for (std::size_t k = 0; k < found_.size() && best_.substitutions != 0; ++k) {
      const Transforms transforms = combination(found_[k].number);
      for (std::size_t s = 0; s < sources_.size(); ++s) {
        bounded.v[s] = sources_[s].stored[transforms[sources_[s].quadrant]];
        bounded.most[s] = static_cast<std::int32_t>(size(sources_[s].codable[0]));
      }
      Codebook4& codebook = found_[k].codebook;
      const std::uint32_t bound =
          most_kept(bounded, codebook.entries, {.enough = all_ - best_.substitutions});
      if (bound > all_ - best_.substitutions) {
        exchange(sources(found_[k].number), codebook);
        take(found_[k]);
      }
      most = std::max(most, bound);
    }
    return {best_, best_.substitutions == 0 || most >= all_ ? 0 : all_ - most};
  }

 private:
  // Limits chosen by hand, on 36 alpha textures (docs/VQ.md): `fast` loses 1.4 % more regions than `balanced`, in a
  // seventh of the time; beyond 64 exchanges `thorough` gains nothing there, for three times the time.
  static constexpr std::size_t fast_merges = 96, fast_exchanges = 2, balanced_exchanges = 64;

  struct Source {
    std::uint32_t quadrant;
    std::array<Set4, 8> stored, codable;  ///< by transform
  };
  struct CodebookChoice {
    Codebook4 codebook;
    std::uint32_t number;  ///< number of the choice of transforms
  };

  Sources4 sources(std::uint32_t number) const {
    const Transforms transforms = combination(number);
    Sources4 of;
    for (const Source& source : sources_) of.v[of.count++] = source.codable[transforms[source.quadrant]];
    return of;
  }

  /// Merges entries under the choices of transforms with the fewest distinct vectors, until `most` choices are done.
  void merge(std::size_t most) {
    while (found_.size() < order_.size() && best_.substitutions != 0) {
      const auto& [distinct, number] = order_[found_.size()];
      // A map that fits has few distinct vectors under some choice, and every effort takes that.
      if (found_.size() >= most && distinct > stored_entries) break;
      found_.push_back({merged(sources(number)), number});
      take(found_.back());
    }
  }

  /// Exchanges entries under the choices of transforms that keep most so far.
  void exchange_best(std::size_t most) {
    std::vector<CodebookChoice*> best;
    for (CodebookChoice& found : found_) best.push_back(&found);
    std::stable_sort(best.begin(), best.end(), [](const CodebookChoice* a, const CodebookChoice* b) {
      return a->codebook.kept > b->codebook.kept;
    });
    for (std::size_t k = 0; k < std::min(most, best.size()) && best_.substitutions != 0; ++k) {
      exchange(sources(best[k]->number), best[k]->codebook);
      take(*best[k]);
    }
  }

  /// All choices of transforms, each with its number of distinct vectors, in ascending order of that.
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

  void take(const CodebookChoice& found) {
    if (found.codebook.kept <= all_ - best_.substitutions) return;
    std::vector<Set4> entries = found.codebook.entries;
    const Sources4 from = sources(found.number);
    fit_places(entries, std::span(from.v).first(from.count));
    const Encoded4 now = written(vectors_, combination(found.number), entries);
    if (now.substitutions < best_.substitutions) best_ = now;
  }

  Vectors4 vectors_;
  std::vector<Source> sources_;  ///< vectors that are not uniform
  std::vector<std::pair<std::size_t, std::uint32_t>> order_;
  std::vector<CodebookChoice> found_;  ///< results for the first choices in that order
  Encoded4 best_;
  std::uint32_t all_ = 0;  ///< regions O and T of the sources
};

}  // namespace

Encoded4 encode(const Map4& map, Effort effort) { return Search(map).run(effort); }

Proved4 encode_proved(const Map4& map) { return Search(map).prove(); }

}  // namespace mmverify::impl::vq
