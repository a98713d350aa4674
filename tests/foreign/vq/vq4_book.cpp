// VQ4: which of table 2's kinds of entries can hold which vectors.
#include "tests/foreign/vq/vq4_book.hpp"

#include <algorithm>
#include <bit>

#include "tests/foreign/vq/faults.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

constexpr std::uint32_t left = 0x3333, right = 0xcccc, bottom = 0x00ff, top = 0xff00;

bool simple(const Vector& v) { return one_palette(v, 0xffff); }
bool vertical(const Vector& v) { return one_palette(v, left) && one_palette(v, right); }
bool horizontal(const Vector& v) { return one_palette(v, bottom) && one_palette(v, top); }

}  // namespace

bool generic(const Vector& v) {
  return std::all_of(minis.begin(), minis.end(), [&](std::uint32_t m) { return one_palette(v, m); });
}

std::optional<Vq4Book> vq4_book(const std::vector<Vector>& vectors) {
  const std::size_t n = vectors.size();
  if (n > 13) return std::nullopt;
  // v and h take entries 6 and 7, n stands for none of them; the others need a simple or a generic entry.
  for (std::size_t v = 0; v <= n; ++v)
    for (std::size_t h = 0; h <= n; ++h) {
      if (v < n && (v == h || !vertical(vectors[v]))) continue;
      if (h < n && !horizontal(vectors[h])) continue;
      if (has(encode_vq4_no_vertical_entry) && v < n) continue;
      if (has(encode_vq4_horizontal_only_if_simple) && h < n && !simple(vectors[h])) continue;
      Vq4Book book;
      if (v < n) book[6] = vectors[v];
      if (h < n) book[7] = vectors[h];
      std::size_t next_simple = 3, next_generic = 8;
      bool fits = true;
      for (const bool want_simple : {false, true})
        for (std::size_t k = 0; k < n; ++k) {
          if (k == v || k == h || simple(vectors[k]) != want_simple) continue;
          if (want_simple && next_simple < 6)
            book[next_simple++] = vectors[k];
          else if (next_generic < 16 &&
                   !(has(encode_vq4_no_simple_in_generic) && want_simple && next_generic > 10))
            book[next_generic++] = vectors[k];
          else
            fits = false;
        }
      if (fits) return book;
    }
  return std::nullopt;
}

unsigned vq4_word_of(unsigned index, const Vector& v) {
  const std::uint32_t check = ~(v.t | v.o) & 0xffffu;
  if (index < 6) return check | (v.o != 0 ? 0x10000u : 0u);
  if (index < 8) {
    std::uint32_t first = index == 6 ? left : bottom, second = index == 6 ? right : top;
    if (has(encode_vq4_second_palette_lost_if_simple) && simple(v)) second = 0;
    if (has(encode_vq4_palettes_of_7_by_columns) && index == 7) first = left, second = right;
    return check | ((v.o & first) != 0 ? 0x10000u : 0u) | ((v.o & second) != 0 ? 0x20000u : 0u);
  }
  unsigned word = 0;
  for (unsigned m = 0; m < 4; ++m) {
    const unsigned x0 = 2 * (m % 2), y0 = 2 * (m / 2);
    for (unsigned r = 0; r < 4; ++r) word |= (check >> (x0 + r % 2 + 4 * (y0 + r / 2)) & 1u) << (5 * m + r);
    bool opaque = (v.o & minis[m]) != 0;
    if (has(encode_vq4_mini_3_palette_of_2) && m == 3 && (v.t & minis[m]) == 0)
      opaque = (v.o & minis[2]) != 0;
    if (has(encode_vq4_palette_by_count_in_15) && index == 15 && m == 1)
      opaque = std::popcount(v.o & minis[m]) > 1;
    word |= (opaque ? 16u : 0u) << (5 * m);
  }
  return word;
}

}  // namespace mmverify::tests::foreign::vq
