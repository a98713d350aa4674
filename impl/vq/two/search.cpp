#include "impl/vq/two/search.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/vq/two/search.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Compiled once for each target, for its population count.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::vq::detail {
namespace HWY_NAMESPACE {

HWY_INLINE std::uint32_t ones(std::uint64_t x) { return static_cast<std::uint32_t>(__builtin_popcountll(x)); }

// A bound on the regions that a quadrant keeps with the shared entries and any two of its own.
HWY_INLINE std::uint32_t bound(const Sources& s, const Kept& kept, std::uint64_t have) {
  std::uint32_t first = 0, second = 0;
  for (const Entry e : s.useful) {
    const std::uint32_t gain = ones(kept[e] & ~have);
    second = std::max(second, std::min(gain, first));
    first = std::max(first, gain);
  }
  return ones(have) + first + second;
}

// The regions that a quadrant keeps with the best two entries of its own, which are written to `own`.
HWY_INLINE std::uint32_t best_pair(const Sources& s, const Kept& kept, std::uint64_t have,
                                   std::array<Entry, 2>& own) {
  std::uint32_t best = ones(have);
  own = {s.useful[0], s.useful[0]};
  for (std::size_t a = 0; a < s.useful.size(); ++a)
    for (std::size_t b = a; b < s.useful.size(); ++b) {
      const std::uint32_t now = ones(have | kept[s.useful[a]] | kept[s.useful[b]]);
      if (now <= best) continue;
      best = now;
      own = {s.useful[a], s.useful[b]};
    }
  return best;
}

// Takes these shared entries if they beat the best so far.
HWY_INLINE void try_shared(const Sources& s, const std::array<Entry, 3>& shared, Choice& best) {
  std::array<std::array<std::uint32_t, 8>, 4> limit{};
  std::array<std::uint32_t, 4> most{};
  std::uint32_t sum = 0;
  const auto have = [&](const Kept& kept) { return kept[shared[0]] | kept[shared[1]] | kept[shared[2]]; };
  std::uint32_t rest = s.all;  // no later quadrant keeps more than its regions
  for (std::size_t q = 0; q < 4; ++q) {
    for (std::size_t t = 0; t < (q == 0 ? 1 : 8); ++t) {
      limit[q][t] = bound(s, s.kept[q][t], have(s.kept[q][t]));
      most[q] = std::max(most[q], limit[q][t]);
    }
    sum += most[q];
    rest -= s.of_quadrant[q];
    if (sum + rest <= best.kept) return;
  }
  Choice now{.shared = shared, .own = {}, .transform = {}, .kept = 0};
  for (std::size_t q = 0; q < 4; ++q) {
    std::uint32_t kept = 0;
    for (std::size_t t = 0; t < (q == 0 ? 1 : 8); ++t) {
      if (t > 0 && limit[q][t] <= kept) continue;
      std::array<Entry, 2> own{};
      const std::uint32_t with = best_pair(s, s.kept[q][t], have(s.kept[q][t]), own);
      if (t > 0 && with <= kept) continue;
      kept = with;
      now.own[q] = own;
      now.transform[q] = static_cast<std::uint8_t>(t);
    }
    now.kept += kept;
    sum -= most[q] - kept;
    if (sum <= best.kept) return;
  }
  best = now;
}

Choice best_of_all(const Sources& s) {
  Choice best;
  best.shared.fill(s.useful[0]);
  for (auto& own : best.own) own.fill(s.useful[0]);
  const std::size_t n = s.useful.size(), apart = n < 3 ? 0 : 1;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + apart; b < n; ++b)
      for (std::size_t c = b + apart; c < n; ++c) {
        try_shared(s, {s.useful[a], s.useful[b], s.useful[c]}, best);
        if (best.kept == s.all) return best;
      }
  return best;
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::vq::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::vq::detail {

HWY_EXPORT(best_of_all);

Choice best_choice(const Sources& sources) { return HWY_DYNAMIC_DISPATCH(best_of_all)(sources); }

}  // namespace mmverify::impl::vq::detail
#endif  // HWY_ONCE
