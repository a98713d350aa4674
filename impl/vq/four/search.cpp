#include "impl/vq/four/search.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/vq/four/search.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Compiled once for each target, for its population count and vectors.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::vq::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::uint32_t lanes = 64;  ///< vectors of a map

// ---- Merging

/// The entries so far, one a lane; merging with an empty lane costs more than anything else.
class Merge {
 public:
  HWY_INLINE explicit Merge(const Sources4& sources) {
    Vectors4 sorted = sources.v;
    std::sort(sorted.begin(), sorted.begin() + sources.count);
    for (std::uint32_t k = 0; k < sources.count; ++k) {
      if (k == 0 || sorted[k] != sorted[k - 1]) rep_[used_++] = sorted[k];
      ++users_[used_ - 1];
    }
    left_ = used_;
    for (std::uint32_t k = 0; k < lanes; ++k) {
      kept_[k] = k < used_ ? users_[k] * ones(rep_[k]) : none;
      lane_[k] = k;
    }
  }

  HWY_INLINE std::vector<Set4> down_to(std::uint32_t most) {
    if (left_ > most)
      for (std::uint32_t k = 0; k < used_; ++k) find_partner(k);
    while (left_ > most) {
      std::uint32_t at = 0, least = ~0u;
      bool drop = false;
      for (std::uint32_t k = 0; k < used_; ++k) {
        if (users_[k] == 0) continue;
        if (kept_[k] < least) least = kept_[k], at = k, drop = true;
        if (partner_[k] >> 6 < least) least = partner_[k] >> 6, at = k, drop = false;
      }
      const std::uint32_t other = drop ? at : partner_[at] & 63;
      if (!drop) {
        rep_[at] &= rep_[other];
        users_[at] += users_[other];
        kept_[at] = users_[at] * ones(rep_[at]);
      }
      users_[other] = 0;
      kept_[other] = none;
      rep_[other] = 0;
      --left_;
      // Entries whose partner changed search again; the others may find the merged entry nearer.
      for (std::uint32_t k = 0; k < used_; ++k) {
        if (users_[k] == 0) continue;
        const std::uint32_t partner = partner_[k] & 63;
        if (k == at || partner == at || partner == other)
          find_partner(k);
        else if (!drop)
          partner_[k] = std::min(partner_[k], cost(k, at) << 6 | at);
      }
    }
    std::vector<Set4> entries;
    for (std::uint32_t k = 0; k < used_; ++k)
      if (users_[k] != 0) entries.push_back(rep_[k]);
    return entries;
  }

 private:
  /// A cost above all that is kept, 64 vectors of 16 regions; shifted by 6 bits, above a lane, it still fits a word.
  static constexpr std::uint32_t none = 1u << 20;

  static HWY_INLINE std::uint32_t ones(Set4 v) { return static_cast<std::uint32_t>(__builtin_popcount(v)); }

  HWY_INLINE std::uint32_t cost(std::uint32_t a, std::uint32_t b) const {
    return kept_[a] + kept_[b] - (users_[a] + users_[b]) * ones(rep_[a] & rep_[b]);
  }

  /// Finds the other entry that `a` merges with at the least cost; partner_ has the cost above the lane.
  HWY_INLINE void find_partner(std::uint32_t a) {
    const hn::ScalableTag<std::uint32_t> u32;
    const auto rep = hn::Set(u32, rep_[a]), users = hn::Set(u32, users_[a]), kept = hn::Set(u32, kept_[a]),
               self = hn::Set(u32, a), far = hn::Set(u32, ~0u);
    auto least = far;
    for (std::uint32_t k = 0; k < used_; k += static_cast<std::uint32_t>(hn::Lanes(u32))) {
      const auto common = hn::PopulationCount(hn::And(rep, hn::Load(u32, &rep_[k])));
      const auto lost = hn::Mul(hn::Add(users, hn::Load(u32, &users_[k])), common);
      const auto lane = hn::Load(u32, &lane_[k]);
      const auto costs = hn::Sub(hn::Add(kept, hn::Load(u32, &kept_[k])), lost);
      const auto packed = hn::Or(hn::ShiftLeft<6>(costs), lane);
      least = hn::Min(least, hn::IfThenElse(hn::Eq(lane, self), far, packed));
    }
    partner_[a] = hn::GetLane(hn::MinOfLanes(u32, least));
  }

  HWY_ALIGN std::array<std::uint32_t, lanes> rep_{}, users_{}, kept_{}, lane_{};
  std::array<std::uint32_t, lanes> partner_{};
  std::uint32_t used_ = 0, left_ = 0;
};

// ---- The regions that a codebook keeps

/// The number of regions kept of each source.
struct HWY_ALIGN Kept {
  std::array<std::uint8_t, lanes> of{};
};

HWY_INLINE void keep(const Sources4& sources, Set4 entry, std::uint8_t* HWY_RESTRICT of) {
  const auto regions = static_cast<std::uint8_t>(__builtin_popcount(entry));
  for (std::uint32_t k = 0; k < lanes; ++k) of[k] = (entry & ~sources.v[k]) == 0 ? regions : std::uint8_t{0};
}

HWY_INLINE std::uint32_t sum(const Kept& kept) {
  std::uint32_t total = 0;
  for (const std::uint8_t of : kept.of) total += of;
  return total;
}

/// The number of regions that `more` keeps beyond `now`.
HWY_INLINE std::uint32_t gain(const std::uint8_t* HWY_RESTRICT more, const Kept& now) {
  const hn::CappedTag<std::uint8_t, lanes> bytes;
  const hn::Repartition<std::uint64_t, decltype(bytes)> words;
  auto total = hn::Zero(words);
  for (std::uint32_t k = 0; k < lanes; k += static_cast<std::uint32_t>(hn::Lanes(bytes)))
    total =
        hn::Add(total, hn::SumsOf8(hn::SaturatedSub(hn::Load(bytes, more + k), hn::Load(bytes, &now.of[k]))));
  return static_cast<std::uint32_t>(hn::GetLane(hn::SumOfLanes(words, total)));
}

/// Grows every entry to the intersection of its users, as long as that changes anything; entries without a user go.
HWY_INLINE void grow(const Sources4& sources, Codebook4& codebook) {
  for (bool changed = true; changed;) {
    changed = false;
    std::array<std::uint8_t, lanes> user_of{};
    Kept best;
    for (std::size_t e = 0; e < codebook.entries.size(); ++e) {
      Kept now;
      keep(sources, codebook.entries[e], now.of.data());
      for (std::uint32_t k = 0; k < lanes; ++k) {
        const bool better = now.of[k] > best.of[k];
        user_of[k] = better ? static_cast<std::uint8_t>(e) : user_of[k];
        best.of[k] = better ? now.of[k] : best.of[k];
      }
    }
    std::array<Set4, stored_entries> common;
    common.fill(~Set4{0});
    for (std::uint32_t k = 0; k < sources.count; ++k)
      if (best.of[k] != 0) common[user_of[k]] &= sources.v[k];
    std::vector<Set4> grown;
    for (std::size_t e = 0; e < codebook.entries.size(); ++e) {
      if (common[e] == ~Set4{0}) continue;
      changed = changed || common[e] != codebook.entries[e];
      grown.push_back(common[e]);
    }
    codebook.entries = std::move(grown);
    codebook.kept = sum(best);
  }
}

// ---- Exchanging

/// The candidates for an entry, each once, with the regions that it keeps of each source.
class Pool {
 public:
  explicit Pool(const Sources4& sources) : sources_(sources), seen_(slots) {
    for (std::uint32_t a = 0; a < sources.count; ++a)
      for (std::uint32_t b = a; b < sources.count; ++b) add(sources.v[a] & sources.v[b]);
    kept_.reserve(sets_.size() + 1024);  // 13 entries with 64 sources each, at most
    for (const Set4 set : sets_) keep(sources_, set, kept_.emplace_back().of.data());
    fixed_ = sets_.size();
  }

  /// Replaces the candidates that depend on the entries.
  void add_of(const std::vector<Set4>& entries) {
    sets_.resize(fixed_);
    kept_.resize(fixed_);
    for (const Set4 entry : entries)
      for (std::uint32_t k = 0; k < sources_.count; ++k) {
        const Set4 set = entry & sources_.v[k];
        if (set == 0 || set == entry) continue;
        sets_.push_back(set);
        keep(sources_, set, kept_.emplace_back().of.data());
      }
  }

  /// The candidate that adds most, and its gain; {0, above} if none adds more than `above`.
  HWY_INLINE std::pair<Set4, std::uint32_t> best(const Kept& now, std::uint32_t above) const {
    std::pair<Set4, std::uint32_t> found{0, above};
    for (std::size_t c = 0; c < sets_.size(); ++c)
      if (const std::uint32_t more = gain(kept_[c].of.data(), now); more > found.second)
        found = {sets_[c], more};
    return found;
  }

 private:
  /// 2^13 slots: more than three for each pair of 64 sources, 2080 with pairs of one and the same, so that few collide.
  static constexpr std::size_t slots = 8192;

  void add(Set4 set) {
    if (set == 0) return;
    // The multiplier is 2^32 over the golden ratio, as in Knuth; the slot is the product's 13 highest bits.
    std::size_t slot = set * 0x9e3779b1u >> 19;
    while (seen_[slot] != 0 && seen_[slot] != set) slot = (slot + 1) % slots;
    if (seen_[slot] == set) return;
    seen_[slot] = set;
    sets_.push_back(set);
  }

  const Sources4& sources_;
  std::vector<Set4> seen_, sets_;
  std::vector<Kept> kept_;
  std::size_t fixed_ = 0;
};

HWY_INLINE Kept kept_without(const std::vector<Kept>& rows, std::size_t left_out) {
  Kept best;
  for (std::size_t e = 0; e < rows.size(); ++e)
    if (e != left_out)
      for (std::uint32_t k = 0; k < lanes; ++k) best.of[k] = std::max(best.of[k], rows[e].of[k]);
  return best;
}

void exchange_entries(const Sources4& sources, Codebook4& codebook) {
  grow(sources, codebook);
  Pool pool(sources);
  for (;;) {
    pool.add_of(codebook.entries);
    std::vector<Kept> rows(codebook.entries.size());
    for (std::size_t e = 0; e < rows.size(); ++e) keep(sources, codebook.entries[e], rows[e].of.data());
    std::uint32_t most = codebook.kept;
    std::size_t out = rows.size();
    Set4 in = 0;
    // If there is room, an entry can be added and none removed.
    for (std::size_t e = rows.size() < stored_entries ? rows.size() : 0; e <= rows.size(); ++e) {
      if (e == rows.size() && rows.size() == stored_entries) break;
      const Kept rest = kept_without(rows, e);
      const std::uint32_t base = sum(rest);
      const auto [set, more] = pool.best(rest, most - base);
      if (set == 0) continue;
      most = base + more;
      out = e;
      in = set;
    }
    if (in == 0) return;
    if (out == rows.size())
      codebook.entries.push_back(in);
    else
      codebook.entries[out] = in;
    grow(sources, codebook);
  }
}

Codebook4 merge_entries(const Sources4& sources) {
  Codebook4 codebook{Merge(sources).down_to(stored_entries), 0};
  grow(sources, codebook);
  return codebook;
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::vq::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::vq::detail {

HWY_EXPORT(merge_entries);
HWY_EXPORT(exchange_entries);

Codebook4 merged(const Sources4& sources) { return HWY_DYNAMIC_DISPATCH(merge_entries)(sources); }
void exchange(const Sources4& sources, Codebook4& codebook) {
  HWY_DYNAMIC_DISPATCH(exchange_entries)(sources, codebook);
}

}  // namespace mmverify::impl::vq::detail
#endif  // HWY_ONCE
