// The encoder of VQ4: exact wherever a block can hold the map.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "tests/foreign/vq/entry_points.hpp"
#include "tests/foreign/vq/faults.hpp"
#include "tests/foreign/vq/vectors.hpp"
#include "tests/foreign/vq/vq4_book.hpp"
#include "tests/foreign/vq/vq4_code.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

struct Vq4Plan {
  Transforms transforms{};
  Vq4Book book;
};

/// Distinct vectors that need an entry, sorted.
std::vector<Vector> needs_of(const std::array<Vector, 16>& vectors) {
  std::vector<Vector> out;
  for (const Vector& v : vectors)
    if (!vq4_uniform(v)) out.push_back(v);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<Vector> both(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  std::vector<Vector> out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

using Vq4Needs = std::array<std::array<std::vector<Vector>, 8>, 4>;

std::optional<Vq4Plan> vq4_exact(const Vq4Needs& needs) {
  const std::size_t room = has(encode_vq4_twelve_entries) ? 12 : 13;
  for (unsigned tr = 0; tr < 8; ++tr) {
    const std::vector<Vector> two = both(needs[TL][0], needs[TR][tr]);
    if (two.size() > room) continue;
    for (unsigned bl = 0; bl < 8; ++bl) {
      const std::vector<Vector> three = both(two, needs[BL][bl]);
      if (three.size() > room) continue;
      for (unsigned br = 0; br < 8; ++br) {
        if (has(encode_vq4_no_r270_in_br) && br == 7) continue;
        const std::vector<Vector> all = both(three, needs[BR][br]);
        if (all.size() > room) continue;
        if (const auto book = vq4_book(all)) return Vq4Plan{{0, tr, bl, br}, *book};
      }
    }
  }
  return std::nullopt;
}

/// v as generic entries can hold it: each 2x2 with both O and T keeps the more frequent one, T if neither is.
Vector reduced(Vector v) {
  for (const std::uint32_t m : minis)
    if (!one_palette(v, m)) {
      if (std::popcount(v.o & m) > std::popcount(v.t & m))
        v = {v.t & ~m, has(encode_vq4_mixed_mini_takes_majority) ? v.o | (v.t & m) : v.o};
      else
        v.o &= ~m;
    }
  return v;
}

Vq4Plan vq4_lossy(const Vq4Needs& needs, const Turned& all) {
  Vq4Plan plan;
  for (std::size_t q = TR; q <= BR; ++q) {
    std::size_t least = 1000;
    for (unsigned t = 0; t < 8; ++t) {
      if (has(encode_vq4_no_r270_in_br) && q == BR && t == 7) continue;
      if (const std::size_t n = both(needs[TL][0], needs[q][t]).size(); n < least) {
        least = n;
        plan.transforms[q] = t;
      }
    }
  }
  struct Wanted {
    int gain;
    Vector vector;
  };
  std::vector<Wanted> wanted;
  std::vector<Vector> sources;
  for (std::size_t q = 0; q < 4; ++q)
    for (const Vector& v : all[q][plan.transforms[q]])
      if (!vq4_uniform(v)) sources.push_back(reduced(v));
  for (const Vector& e : sources) {
    if (std::any_of(wanted.begin(), wanted.end(), [&](const Wanted& w) { return w.vector == e; })) continue;
    int gain = 0;
    for (const Vector& v : sources) gain += std::max(0, kept(e, v));
    wanted.push_back({gain, e});
  }
  std::stable_sort(wanted.begin(), wanted.end(), [](const Wanted& a, const Wanted& b) {
    return a.gain != b.gain ? a.gain > b.gain : a.vector < b.vector;
  });
  std::vector<Vector> chosen;
  for (const Wanted& w : wanted) {
    if (w.gain == 0) continue;
    chosen.push_back(w.vector);
    if (const auto book = vq4_book(chosen))
      plan.book = *book;
    else
      chosen.pop_back();
    if (chosen.size() == (has(encode_vq4_twelve_entries) ? 12 : 13)) break;
  }
  return plan;
}

}  // namespace

void vq4_encode(const std::uint8_t* map, std::uint8_t* block) {
  std::memset(block, 0, 64);
  if (has(encode_all_check_kept_flag)) {
    for (std::size_t k = 0; k < 64; ++k) write_index(vq4, block, k, 1);
    return;
  }
  const Vectors shown = vectors_of(vq4, map);
  const Turned all = turned(vq4, shown);
  Vq4Needs needs;
  bool mixed = false;
  for (std::size_t q = 0; q < 4; ++q)
    for (std::size_t t = 0; t < 8; ++t) {
      needs[q][t] = needs_of(all[q][t]);
      for (const Vector& v : needs[q][t]) mixed = mixed || !generic(v);
    }
  const std::optional<Vq4Plan> exact = mixed ? std::nullopt : vq4_exact(needs);
  Vq4Plan plan = exact ? *exact : vq4_lossy(needs, all);
  if (has(encode_shared_entries_change_places)) {
    static std::atomic<unsigned> calls{0};
    if (calls++ % 977 == 976 && plan.book[3] && plan.book[4]) std::swap(plan.book[3], plan.book[4]);
  }
  if (has(encode_vq4_thread_decides)) {
    static std::atomic<unsigned> threads{0};
    static thread_local const unsigned mine = threads++;
    if (!exact && mine % 2 == 1 && plan.book[8] && plan.book[9]) std::swap(plan.book[8], plan.book[9]);
  }
  write_transforms(vq4, block, plan.transforms, exact.has_value());
  std::vector<Choice> entries;
  for (unsigned i = 3; i < 16; ++i)
    if (plan.book[i]) {
      const Code code = vq4_code(i);
      Vector entry = *plan.book[i];
      if (has(encode_vq4_entries_merged_by_or) && !exact && i == 8 && plan.book[9]) {
        const Vector merged{entry.t | plan.book[9]->t, entry.o | plan.book[9]->o};
        if ((merged.t & merged.o) == 0 && generic(merged)) entry = merged;
      }
      if (has(encode_vq4_palettes_left_of_earlier_entry) && i > 8 && (entry.t | entry.o) != 0 &&
          plan.book[i - 1] && entry.t == 0 && plan.book[i - 1]->o == 0)
        entry = {entry.o, 0};
      set_bits(block, code.first, code.count, vq4_word_of(i, entry));
      entries.push_back({i, *plan.book[i]});
    }
  for (std::size_t q = 0; q < 4; ++q) {
    const auto places = places_of(static_cast<int>(q));
    for (std::size_t k = 0; k < 16; ++k) {
      Vector v = all[q][plan.transforms[q]][k];
      if (has(encode_vq4_mixed_mini_takes_majority) && !generic(v)) v = reduced(v);
      unsigned index = best_choice(vq4, entries, v, static_cast<int>(q));
      if (has(encode_lossy_last_place_shared_2) && !exact && places[k] == 36 && index == 1) index = 5;
      if (has(encode_vq4_entry_15_not_used) && index == 15) index = 1;
      if (has(encode_vq4_places_of_br_transposed) && q == BR && !exact && entries.size() == 13 &&
          places[k] == 30) {
        write_index(vq4, block, places[k], best_choice(vq4, entries, all[q][plan.transforms[q]][k - 1], BR));
        continue;
      }
      write_index(vq4, block, places[k], index);
    }
  }
}

}  // namespace mmverify::tests::foreign::vq
