#include "impl/vq.hpp"
#include "impl/vq2_layout.hpp"
#include "impl/vq2_search.hpp"

namespace mmverify::impl::vq {
namespace {

using namespace detail;

/// The regions of a vector that are T, and those that are O, a bit each.
struct Sets {
  std::uint32_t t = 0, o = 0;
  bool uniform() const { return t == 15 || o == 15 || (t | o) == 0; }
};

Sets sets_of(const Map2& map, std::uint32_t vector) {
  Sets sets;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const State s = map[2 * (vector % 8) + k % 2 + 16 * (2 * (vector / 8) + k / 2)];
    sets.t |= (s == State::T ? 1u : 0u) << k;
    sets.o |= (s == State::O ? 1u : 0u) << k;
  }
  return sets;
}

/// As they stand in the codebook, before the transform.
std::uint32_t before(std::uint32_t transform, std::uint32_t set) {
  std::uint32_t out = 0;
  for (std::uint32_t k = 0; k < 4; ++k) out |= (set >> moved<2>(transform, k) & 1) << k;
  return out;
}

constexpr std::uint32_t set_of(Entry e) { return e % 14 + 1; }
constexpr bool opaque(Entry e) { return e >= 14; }
constexpr std::uint64_t code_of(Entry e) { return (15 ^ set_of(e)) | (opaque(e) ? 16u : 0u); }
constexpr std::uint32_t size(std::uint32_t set) {
  return (set & 1) + (set >> 1 & 1) + (set >> 2 & 1) + (set >> 3 & 1);
}

/// How many regions an entry keeps of a vector as the codebook would have it; 0 where it is not usable.
std::uint32_t keeps(Entry e, const Sets& v) {
  return (set_of(e) & ~(opaque(e) ? v.o : v.t)) == 0 ? size(set_of(e)) : 0;
}

constexpr std::uint32_t quadrant_of_vector(std::uint32_t vector) {
  return quadrant(2 * (vector % 8), 2 * (vector / 8));
}

}  // namespace

Encoded2 encode_optimal(const Map2& map) {
  std::array<Sets, 64> vectors;
  Sources sources{};
  std::array<std::uint32_t, 4> found{};  // vectors that are not uniform
  std::array<bool, entries> useful{};
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const Sets& v = vectors[vector] = sets_of(map, vector);
    if (v.uniform()) continue;
    const std::uint32_t q = quadrant_of_vector(vector), place = found[q]++;
    sources.all += std::max(size(v.t), size(v.o));
    for (std::uint32_t t = 0; t < (q == 0 ? 1 : 8); ++t) {
      const Sets as_stored{before(t, v.t), before(t, v.o)};
      for (Entry e = 0; e < entries; ++e) {
        const std::uint32_t kept = keeps(e, as_stored);
        useful[e] = useful[e] || kept > 0;
        for (std::uint32_t j = 0; j < kept; ++j)
          sources.kept[q][t][e] |= std::uint64_t{1} << (16 * j + place);
      }
    }
  }
  for (Entry e = 0; e < entries; ++e)
    if (useful[e]) sources.useful.push_back(e);

  Choice choice;
  if (!sources.useful.empty()) choice = best_choice(sources);

  Encoded2 out{};
  std::uint64_t word = 0;
  for (std::uint32_t q = 1; q < 4; ++q) word |= std::uint64_t{choice.transform[q]} << (3 * (q - 1));
  for (std::uint32_t k = 0; k < 3; ++k) word |= code_of(choice.shared[k]) << code_at(0, 3 + k);
  for (std::uint32_t q = 0; q < 4; ++q)
    for (std::uint32_t k = 0; k < 2; ++k) word |= code_of(choice.own[q][k]) << code_at(q, 6 + k);
  std::memcpy(out.block.data() + indices_bits / 8, &word, sizeof word);

  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const Sets& v = vectors[vector];
    const std::uint32_t q = quadrant_of_vector(vector), t = choice.transform[q];
    std::uint32_t index = static_cast<std::uint32_t>(State::C), most = 0;
    if (v.uniform()) {
      index = static_cast<std::uint32_t>(v.t == 15 ? State::T : v.o == 15 ? State::O : State::C);
      most = size(v.t) + size(v.o);
    } else {
      const Sets as_stored{before(t, v.t), before(t, v.o)};
      for (std::uint32_t k = 3; k < 8; ++k) {
        const std::uint32_t kept = keeps(k < 6 ? choice.shared[k - 3] : choice.own[q][k - 6], as_stored);
        if (kept <= most) continue;
        most = kept;
        index = k;
      }
    }
    out.substitutions += size(v.t) + size(v.o) - most;
    std::uint16_t two;
    std::memcpy(&two, out.block.data() + 3 * vector / 8, sizeof two);
    two = static_cast<std::uint16_t>(two | index << (3 * vector % 8));
    std::memcpy(out.block.data() + 3 * vector / 8, &two, sizeof two);
  }
  return out;
}

}  // namespace mmverify::impl::vq
