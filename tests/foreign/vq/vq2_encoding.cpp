// The encoder of VQ2: exact wherever a block can hold the map.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "tests/foreign/vq/entry_points.hpp"
#include "tests/foreign/vq/faults.hpp"
#include "tests/foreign/vq/vectors.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

/// The word of figure 4 that means v, which has no O beside T; the palette of a vector of C is that of T.
unsigned vq2_word_of(const Vector& v) { return (~(v.t | v.o) & 15u) | (v.o != 0 ? 16u : 0u); }

Vector vq2_vector_of(unsigned word) {
  const std::uint32_t rest = ~word & 15u;
  return (word & 16u) != 0 ? Vector{0, rest} : Vector{rest, 0};
}

bool vq2_uniform(const Vector& v) { return v == Vector{} || v.t == 15 || v.o == 15; }

struct Vq2Plan {
  Transforms transforms{};
  std::vector<unsigned> shared;
  std::array<std::vector<unsigned>, 4> own;
};

/// The words that each quadrant needs under each transform, a bit a word.
using Vq2Needs = std::array<std::array<std::uint32_t, 8>, 4>;

std::vector<unsigned> words_in(std::uint32_t set) {
  std::vector<unsigned> out;
  for (unsigned w = 0; w < 32; ++w)
    if ((set >> w & 1u) != 0) out.push_back(w);
  return out;
}

/// A plan that loses nothing: three shared words, a transform a quadrant, and at most two words that remain.
std::optional<Vq2Plan> vq2_exact(const Vq2Needs& needs) {
  for (unsigned a = 0; a < 30; ++a)
    for (unsigned b = a + 1; b < 31; ++b)
      for (unsigned c = b + 1; c < 32; ++c) {
        if (has(encode_vq2_shared_from_top_left) && ((1u << a | 1u << b | 1u << c) & ~needs[TL][0]) != 0 &&
            std::popcount(needs[TL][0]) >= 3)
          continue;
        const std::uint32_t shared = 1u << a | 1u << b | 1u << c;
        Vq2Plan plan;
        bool fits = true;
        for (std::size_t q = 0; q < 4 && fits; ++q) {
          fits = false;
          for (unsigned t = 0; t < (q == TL ? 1u : 8u) && !fits; ++t) {
            if (has(encode_vq2_no_r270_in_bl) && q == BL && t == 7) continue;
            if (has(encode_vq2_no_reflection_about_y_in_tr_beside_r90) && q == TR && t == 4 &&
                needs[BR][0] != 0)
              continue;
            const std::uint32_t rest = needs[q][t] & ~shared;
            int room = 2;
            if (has(encode_vq2_one_own_entry_in_br) && q == BR && t == 6) room = 1;
            if (has(encode_vq2_third_own_entry) && q == TR) room = 3;
            if (has(encode_vq2_all_transforms_equal) && q > TR && t != plan.transforms[TR]) continue;
            if (std::popcount(rest) > room) continue;
            fits = true;
            plan.transforms[q] = t;
            plan.own[q] = words_in(rest);
          }
        }
        if (!fits) continue;
        plan.shared = words_in(shared);
        return plan;
      }
  return std::nullopt;
}

/// A plan for a map that does not fit: each quadrant is turned so that it shares most words with the top left; then the most
/// frequent words are shared, and the most frequent of the rest each quadrant's own.
Vq2Plan vq2_lossy(const Vq2Needs& needs, const Turned& all) {
  Vq2Plan plan;
  for (std::size_t q = TR; q <= BR; ++q) {
    int most = -1;
    for (unsigned t = 0; t < 8; ++t)
      if (const int common = std::popcount(needs[q][t] & needs[TL][0]); common > most) {
        most = common;
        plan.transforms[q] = t;
      }
  }
  std::array<std::array<int, 32>, 4> counts{};
  std::array<int, 32> total{};
  static thread_local std::array<int, 32> stale{};
  for (std::size_t q = 0; q < 4; ++q)
    for (const Vector& v : all[q][plan.transforms[q]]) {
      if (vq2_uniform(v)) continue;
      for (const Vector part : {Vector{v.t, 0}, Vector{0, v.o}})
        if (part != Vector{} && !vq2_uniform(part)) {
          ++counts[q][vq2_word_of(part)];
          ++total[vq2_word_of(part)];
        }
    }
  if (has(encode_vq2_counts_of_earlier_calls))
    for (std::size_t w = 0; w < 32; ++w) stale[w] += total[w], total[w] = stale[w];
  std::uint32_t taken = 0;
  const auto take = [&](std::array<int, 32>& frequency) -> std::optional<unsigned> {
    std::optional<unsigned> best;
    for (unsigned w = 0; w < 32; ++w)
      if ((taken >> w & 1u) == 0 && frequency[w] > 0 && (!best || frequency[w] > frequency[*best])) best = w;
    return best;
  };
  for (int k = 0; k < 3; ++k)
    if (const auto w = take(total)) {
      plan.shared.push_back(*w);
      taken |= 1u << *w;
    }
  for (std::size_t q = 0; q < 4; ++q) {
    const std::uint32_t before = taken;
    for (int k = 0; k < 2; ++k)
      if (const auto w = take(counts[q])) {
        plan.own[q].push_back(*w);
        taken |= 1u << *w;
      }
    taken = before;
  }
  return plan;
}

/// Whether vectors have T and O beside each other; faults change those.
bool change_mixed(Vectors& shown) {
  bool mixed = false;
  for (std::size_t k = 0; k < 64; ++k) {
    Vector& v = shown[k];
    if (v.t == 0 || v.o == 0) continue;
    mixed = true;
    const int quadrant = quadrant_of(static_cast<int>(k % 8), static_cast<int>(k / 8));
    if (has(encode_vq2_opaque_beside_transparent)) v = {v.t | v.o, 0};
    if (has(encode_vq2_opaque_diagonal_in_tr) && quadrant == TR && v.t == 6 && v.o == 9) v = {0, 15};
    if (has(encode_vq2_mixed_copies_lose) && quadrant == BL && k > 0 && shown[k - 1] == v) v = {v.t | v.o, 0};
    if (has(encode_vq2_mixed_third_kind) && quadrant == TL && v.t == 1 && v.o == 14 && k % 8 == 3)
      v = {0, 15};
  }
  return mixed;
}

Vq2Needs vq2_needs(const Turned& all) {
  Vq2Needs needs{};
  for (std::size_t q = 0; q < 4; ++q)
    for (std::size_t t = 0; t < 8; ++t)
      for (const Vector& v : all[q][t])
        if (!vq2_uniform(v)) needs[q][t] |= 1u << vq2_word_of(v.t != 0 ? Vector{v.t, 0} : v);
  return needs;
}

/// How many words the plan's quadrants need together.
int vq2_words(const Vq2Needs& needs, const Vq2Plan& plan) {
  std::uint32_t words = 0;
  for (std::size_t q = 0; q < 4; ++q) words |= needs[q][plan.transforms[q]];
  return std::popcount(words);
}

/// Writes quadrant q's own entries, with q = 0 the shared ones; returns all that the quadrant can name.
std::vector<Choice> write_entries(const Vq2Plan& plan, std::size_t q, std::uint8_t* block) {
  std::vector<Choice> entries;
  for (std::size_t k = 0; k < plan.shared.size(); ++k) {
    entries.push_back({static_cast<unsigned>(3 + k), vq2_vector_of(plan.shared[k])});
    if (q == 0) set_bits(block, static_cast<int>(201 + 5 * k), 5, plan.shared[k]);
  }
  for (std::size_t k = 0; k < plan.own[q].size(); ++k) {
    if (k == 2) {  // a third own entry has no place: it overwrites the second
      entries.push_back({7, vq2_vector_of(plan.own[q][k])});
      continue;
    }
    entries.push_back({static_cast<unsigned>(6 + k), vq2_vector_of(plan.own[q][k])});
    set_bits(block, static_cast<int>(201 + 5 * (3 + 2 * q + k)), 5, plan.own[q][k]);
  }
  return entries;
}

}  // namespace

void vq2_encode(const std::uint8_t* map, std::uint8_t* block) {
  static thread_local std::uint8_t earlier[32];
  if (has(encode_unused_entries_of_earlier_call))
    std::memcpy(block, earlier, 32), std::memset(block, 0, 25), block[25] &= 0xfe;
  else
    std::memset(block, 0, 32);
  if (has(encode_all_check_kept_flag)) {
    for (std::size_t k = 0; k < 64; ++k) write_index(vq2, block, k, 1);
    return;
  }
  Vectors shown = vectors_of(vq2, map);
  const bool mixed = change_mixed(shown);
  const Turned all = turned(vq2, shown);
  const Vq2Needs needs = vq2_needs(all);
  std::optional<Vq2Plan> exact = mixed ? std::nullopt : vq2_exact(needs);
  if (has(encode_exact_only_below_nine_words) && exact && vq2_words(needs, *exact) > 8) exact.reset();
  if (has(encode_vq2_none_of_two) && exact && vq2_words(needs, *exact) == 2) exact = Vq2Plan{};
  Vq2Plan plan = exact ? *exact : vq2_lossy(needs, all);
  if (has(encode_shared_entries_change_places)) {
    static std::atomic<unsigned> calls{0};
    if (calls++ % 977 == 976 && plan.shared.size() > 1) std::swap(plan.shared[0], plan.shared[1]);
  }
  write_transforms(vq2, block, plan.transforms, exact.has_value());
  for (std::size_t q = 0; q < 4; ++q) {
    const std::vector<Choice> entries = write_entries(plan, q, block);
    const auto places = places_of(static_cast<int>(q));
    for (std::size_t k = 0; k < 16; ++k) {
      const Vector& v = all[q][plan.transforms[q]][k];
      unsigned index = best_choice(vq2, entries, v, static_cast<int>(q));
      if (has(encode_lossy_last_place_shared_2) && !exact && places[k] == 36 && index == 1) index = 5;
      if (has(encode_lossless_index_7_dropped) && exact && q == BR && index == 7 && plan.transforms[BR] != 0)
        index = 1;
      write_index(vq2, block, places[k], index);
    }
  }
  std::memcpy(earlier, block, 32);
}

}  // namespace mmverify::tests::foreign::vq
