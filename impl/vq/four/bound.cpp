#include "impl/vq/four/bound.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/vq/four/bound.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::vq::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::int32_t unit =
    64;  ///< prices are whole parts of a region; a power of 2, to multiply by shifts
constexpr std::uint32_t lanes = 64;  ///< vectors of a map
// Limits chosen by hand: any values give a true bound, these decide when to stop.  With these, noise takes ten seconds
// to a minute, and continuous maps some 0.1 s (docs/VQ.md).
constexpr int rounds = 10;
constexpr std::size_t most_found = 400;  ///< new entries of a round

HWY_INLINE std::int32_t ones(Set4 v) { return static_cast<std::int32_t>(__builtin_popcount(v)); }

class Bound {
 public:
  Bound(Bounded4& sources, const BoundLimits& limits)
      : enough_(unit * (std::int64_t{limits.enough} + 1)), nodes_(limits.nodes), result_(sources) {
    for (std::uint32_t k = 0; k < lanes; ++k) {
      v_[k] = sources.v[k];
      most_[k] = unit * sources.most[k];
      price_[k] = std::min(sources.price[k], most_[k]);
    }
  }

  std::uint32_t run(std::vector<Set4>& entries) {
    for (const Set4 e : entries) add(e);
    std::int64_t proved = std::numeric_limits<std::int64_t>::max();
    for (int round = 0; round < rounds && proved >= enough_; ++round) {
      descend(round == 0 ? 200 : 100);  // chosen by hand; later rounds begin with good prices
      const Shown shown = show();
      proved = std::min(proved, shown.bound);
      if (shown.found.empty()) break;
      for (const Set4 e : shown.found) add(e);
    }
    value();
    entries.clear();
    for (std::size_t k = 0; k < std::min(pool_.size(), stored_entries); ++k) entries.push_back(pool_[k].set);
    for (std::uint32_t k = 0; k < lanes; ++k) result_.price[k] = price_[k];
    return static_cast<std::uint32_t>(proved / unit);
  }

 private:
  using Prices = std::array<std::int32_t, lanes>;

  struct Candidate {
    Set4 set;
    std::int32_t worth;
  };

  void add(Set4 set) {
    if (set != 0 &&
        std::none_of(pool_.begin(), pool_.end(), [=](const Candidate& c) { return c.set == set; }))
      pool_.push_back({set, 0});
  }

  HWY_INLINE std::int32_t worth(Set4 set) const {
    const hn::ScalableTag<std::int32_t> i32;
    const hn::RebindToUnsigned<decltype(i32)> u32;
    const auto e = hn::Set(u32, set);
    const auto regions = hn::Set(i32, unit * ones(set)), zero = hn::Zero(i32);
    auto sum = zero;
    for (std::uint32_t k = 0; k < lanes; k += static_cast<std::uint32_t>(hn::Lanes(i32))) {
      const auto outside = hn::AndNot(hn::Load(u32, &v_[k]), e);
      const auto gain = hn::Sub(hn::Min(regions, hn::Load(i32, &most_[k])), hn::Load(i32, &price_[k]));
      const auto around = hn::Eq(hn::BitCast(i32, outside), zero);
      sum = hn::Add(sum, hn::IfThenElseZero(around, hn::Max(gain, zero)));
    }
    return hn::GetLane(hn::SumOfLanes(i32, sum));
  }

  /// A bound of worth() for all subsets of a set; a source in left_out does not count.
  HWY_INLINE std::int32_t at_most(Set4 set, const Prices& left_out) const {
    const hn::ScalableTag<std::int32_t> i32;
    const hn::RebindToUnsigned<decltype(i32)> u32;
    const auto e = hn::Set(u32, set);
    const auto zero = hn::Zero(i32);
    auto sum = zero;
    for (std::uint32_t k = 0; k < lanes; k += static_cast<std::uint32_t>(hn::Lanes(i32))) {
      const auto common = hn::PopulationCount(hn::And(e, hn::Load(u32, &v_[k])));
      const auto regions = hn::ShiftLeft<6>(hn::BitCast(i32, common));
      const auto gain = hn::Sub(hn::Min(regions, hn::Load(i32, &most_[k])), hn::Load(i32, &price_[k]));
      sum = hn::Add(sum, hn::Max(hn::Sub(gain, hn::Load(i32, &left_out[k])), zero));
    }
    return hn::GetLane(hn::SumOfLanes(i32, sum));
  }
  static_assert(unit == 1 << 6);

  std::int64_t price_sum() const {
    std::int64_t sum = 0;
    for (const std::int32_t p : price_) sum += p;
    return sum;
  }

  /// Computes all candidates' worth, moves the greatest 13 to the front, and returns their sum.
  HWY_INLINE std::int64_t value() {
    for (Candidate& c : pool_) c.worth = worth(c.set);
    const auto first = std::min(pool_.size(), stored_entries);
    std::partial_sort(pool_.begin(), pool_.begin() + static_cast<std::ptrdiff_t>(first), pool_.end(),
                      [](const Candidate& a, const Candidate& b) { return a.worth > b.worth; });
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < first; ++k) sum += pool_[k].worth;
    return sum;
  }

  /// The slope of a price: 1 - n if n of the 13 pay for the source.  The price should rise if n > 1, fall if n = 0.
  Prices slope() const {
    Prices slope;
    slope.fill(1);
    for (std::size_t c = 0; c < std::min(pool_.size(), stored_entries); ++c) {
      const Set4 set = pool_[c].set;
      for (std::uint32_t k = 0; k < lanes; ++k)
        slope[k] -= (set & ~v_[k]) == 0 && std::min(unit * ones(set), most_[k]) > price_[k] ? 1 : 0;
    }
    for (std::uint32_t k = 0; k < lanes; ++k)
      if (most_[k] == 0 || (slope[k] > 0 && price_[k] == 0)) slope[k] = 0;
    return slope;
  }

  /// Lowers the bound by better prices for the pool, until it is low enough.
  void descend(int steps) {
    Prices best_price = price_;
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    // Polyak's step times a number in (0, 2): 1.5, halved after ten steps in vain, both chosen by hand.
    double eager = 1.5;
    int stale = 0;
    for (int step = 0; step < steps; ++step) {
      const std::int64_t now = price_sum() + value();
      if (now < best) {
        best = now;
        best_price = price_;
        stale = 0;
        if (best < enough_) break;
      } else if (++stale == 10) {
        eager /= 2;
        stale = 0;
        price_ = best_price;
        value();
      }
      const Prices along = slope();
      std::int32_t length = 0;
      for (const std::int32_t s : along) length += s * s;
      if (length == 0) break;
      const double far = eager * std::max(static_cast<double>(now - enough_ + unit), 1.0) / length;
      for (std::uint32_t k = 0; k < lanes; ++k)
        price_[k] = std::clamp(price_[k] - static_cast<std::int32_t>(far * along[k]), 0, most_[k]);
    }
    price_ = best_price;
  }

  struct Shown {
    std::int64_t bound;
    std::vector<Set4> found;  ///< entries outside the pool, worth more than its 13th
  };

  Shown show() {
    Shown shown{price_sum(), {}};
    value();
    std::vector<std::int32_t> worths(stored_entries, 0);
    for (std::size_t k = 0; k < std::min(pool_.size(), stored_entries); ++k) worths[k] = pool_[k].worth;
    const auto bound_if = [&](std::int32_t others) {
      std::int64_t bound = shown.bound;
      for (std::size_t k = 0; k < stored_entries; ++k) bound += std::max(worths[k], others);
      return bound;
    };
    // Sets outside the pool may be worth more than the 13th, as long as the bound stays below enough_ with that worth.
    threshold_ = worths.back();
    // The threshold rises by halving steps that begin at all regions of a vector.
    for (std::int32_t more = 16 * unit; more > 0; more /= 2)
      if (bound_if(threshold_ + more) < enough_) threshold_ += more;
    open_ = threshold_;
    left_ = nodes_;
    found_.clear();
    visit(~Set4{0}, Prices{});
    std::sort(found_.begin(), found_.end(), std::greater<>());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    if (found_.size() > most_found) found_.resize(most_found);
    // The 13 greatest are taken from the pool, the found sets, and any number of sets of the worth left open.
    for (const auto& [worth, set] : found_) {
      worths.push_back(worth);
      shown.found.push_back(set);
    }
    std::partial_sort(worths.begin(), worths.begin() + stored_entries, worths.end(), std::greater<>());
    shown.bound = bound_if(open_);
    return shown;
  }

  /// Visits all subsets of a set; sources left out count as if they had nothing in common with it.
  HWY_INLINE void look(Set4 set, const Prices& left_out, std::int32_t bound) {
    // Splits by the source with the greatest gain that is not wholly around the set.
    std::int32_t most = 0;
    std::uint32_t at = lanes;
    for (std::uint32_t k = 0; k < lanes; ++k) {
      if (left_out[k] != 0 || (set & ~v_[k]) == 0) continue;
      const std::int32_t gain = std::min(unit * ones(set & v_[k]), most_[k]) - price_[k];
      if (gain > most) {
        most = gain;
        at = k;
      }
    }
    if (at == lanes) {
      // Every source that counts is around the set, so the bound is its worth.
      if (std::none_of(pool_.begin(), pool_.end(), [=](const Candidate& c) { return c.set == set; }))
        found_.push_back({bound, set});
      return;
    }
    visit(set & v_[at], left_out);
    HWY_ALIGN Prices without = left_out;
    without[at] = far_away;
    visit(set, without);
  }

  void visit(Set4 set, const Prices& left_out) {
    const std::int32_t bound = at_most(set, left_out);
    if (bound <= threshold_) return;
    if (left_ == 0) {
      open_ = std::max(open_, bound);
      return;
    }
    --left_;
    look(set, left_out, bound);
  }

  static constexpr std::int32_t far_away = 1 << 16;  ///< more than any gain: 16 regions are 2^10

  HWY_ALIGN std::array<Set4, lanes> v_;
  HWY_ALIGN Prices most_, price_;
  std::int64_t enough_;  ///< the bound is low enough below this
  std::uint32_t nodes_;
  Bounded4& result_;
  std::vector<Candidate> pool_;
  std::int32_t threshold_ = 0, open_ = 0;
  std::uint32_t left_ = 0;
  std::vector<std::pair<std::int32_t, Set4>> found_;
};

std::uint32_t bound_of(Bounded4& sources, std::vector<Set4>& entries, const BoundLimits& limits) {
  return Bound(sources, limits).run(entries);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::vq::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::vq::detail {

HWY_EXPORT(bound_of);

std::uint32_t most_kept(Bounded4& sources, std::vector<Set4>& entries, const BoundLimits& limits) {
  return HWY_DYNAMIC_DISPATCH(bound_of)(sources, entries, limits);
}

}  // namespace mmverify::impl::vq::detail
#endif  // HWY_ONCE
