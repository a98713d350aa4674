// Along the curve: indices from words and by steps.
#include "tests/foreign/index/curve.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "tests/foreign/index/faults.hpp"

namespace mmverify::tests::foreign::index {

template <typename Real>
Word step(Word level, Real u, Real v) {
  Real w = 1 - u - v;
  Word index = 0;
  bool mid = false, top = false;
  const bool exceptions = !has(step_without_exceptions);
  const Real half = Real(0.5);
  for (Word depth = 0; depth < level; ++depth) {
    const bool except = exceptions && mid && v == half;
    const Real un = u, vn = v, wn = w;
    if (w > half) {
      index = 4 * index + (top ? 2 : 0);
      u = 2 * un, v = 2 * vn, w = wn - un - vn;
    } else if (v >= half && !except) {
      index = 4 * index + 3;
      u = 2 * un, v = vn - un - wn, w = 2 * wn;
      top = !top;
    } else if (u >= half && !except) {
      index = 4 * index + (top ? 0 : 2);
      u = un - vn - wn, v = 2 * vn, w = 2 * wn;
    } else {
      index = 4 * index + 1;
      u = un + vn - wn, v = wn + un - vn, w = vn + wn - un;
      if (has(step_appendix_middle)) std::swap(v, w);
      mid = !mid;
    }
  }
  return index;
}

template Word step(Word, float, float);
template Word step(Word, double, double);

namespace {

/// 0 a 0 b 0 c ... of the low 16 bits.
Word spread(Word x) {
  x = (x | (x << 8)) & 0x00ff00ff;
  x = (x | (x << 4)) & 0x0f0f0f0f;
  x = (x | (x << 2)) & 0x33333333;
  return (x | (x << 1)) & 0x55555555;
}

std::atomic<Word> first_level{~Word{0}};

}  // namespace

Word curve(Word level, Word iu, Word iv, Word iw, bool cold) {
  Word mask = side_of(level) - 1;
  if (has(mask_short_from_10) && level >= 10) mask >>= 1;
  if (has(first_level_sticks)) {
    Word none = ~Word{0};
    first_level.compare_exchange_strong(none, level);
    mask = side_of(first_level) - 1;
  }
  Word b0 = ~(iu ^ iw) & mask;
  const Word t = (iu ^ iv) & b0;
  Word f = t;
  if (!cold) {
    f ^= f >> 1;
    f ^= f >> 2;
    f ^= f >> 4;
    if (!has(prefix_over_8) && !(has(prefix_over_8_from_13) && level >= 13)) f ^= f >> 8;
  }
  if (has(prefix_over_15)) f ^= t >> 15;
  Word b1 = ((f ^ iu) & ~b0) | t;
  if (has(spread_15)) b1 &= 0x7fff;
  if (has(spread_b0_9)) b0 &= ~(Word{1} << 9);
  Word index = spread(b0) | (spread(b1) << 1);

  if (has(index_in_float)) index = static_cast<Word>(std::min(static_cast<float>(index), 0x1.fffffep31f));
  if (has(index_saturates)) index = std::min(index, Word{0x7fffffff});
  if (has(one_index_at_9) && level == 9 && index == 0x1a2b3) index ^= 1;
  if (has(one_index_at_12) && level == 12 && index == 0x5a2b3c) index ^= 1;
  if (has(one_index_at_16) && level == 16 && index == 0xb5a2b3c4) index ^= 1;
  if (has(pair_exchanged_at_9) && level == 9) {
    if (index == 0x1a2b3 || index == 0x1a2b7) index ^= 4;
  }
  if (has(last_digit_at_odd_levels) && level >= 9 && level % 2 == 1 && index % 2 == 0) index ^= 2;
  if (has(first_digit_at_9) && level == 9 && (index >> 16) % 2 == 0) index ^= 2u << 16;
  if (has(turned_round_at_7) && level == 7) index = indices_of(level) - 1 - index;
  return index;
}

}  // namespace mmverify::tests::foreign::index
