// Back from the curve: the corners of an index.
#include "tests/foreign/index/corners.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "tests/foreign/index/entry_points.hpp"
#include "tests/foreign/index/faults.hpp"

namespace mmverify::tests::foreign::index {
namespace {

Vertex between(Vertex a, Vertex b) { return {(a.i + b.i) / 2, (a.j + b.j) / 2}; }

struct Path {
  Vertex w, u, v;
  bool turned = false;  // child 0 lies at u, child 2 at w
};

Path walk(Path at, Word level, Word index, Word from, Word to) {
  for (Word place = from; place-- > to;) {
    Word digit = (index >> (2 * place)) & 3;
    if (has(corners_of_30_bits) && place == 15) digit = 0;
    const Vertex wu = between(at.w, at.u), wv = between(at.w, at.v), uv = between(at.u, at.v);
    if (digit == 3) {
      at.w = wv, at.u = uv;
      if (!(has(corners_keep_their_turn_from_13) && level - place >= 13)) at.turned = !at.turned;
    } else if (digit == 1) {
      at.w = wv, at.u = uv, at.v = wu;
    } else if ((digit == 0) != at.turned) {
      at.u = wu, at.v = wv;
    } else {
      at.w = wu, at.v = uv;
    }
  }
  return at;
}

Corners corners_at(Word level, Word index, const Path& end) {
  Corners c{{end.turned ? end.u : end.w, end.turned ? end.w : end.u, end.v}};
  auto& at = c.of;
  const Word n = side_of(level), last = indices_of(level) - 1;
  for (Vertex& x : at) {
    if (has(corners_in_16_bits)) x = {static_cast<std::uint16_t>(x.i), static_cast<std::uint16_t>(x.j)};
    if (has(corners_short_of_the_u_corner) && level == 9) x.i = std::min(x.i, n - 1);
    if (has(corners_v_corner_from_8) && level >= 8) x.j = std::min(x.j, n - 1);
  }
  if (has(corners_one_at_10) && level == 10 && index == 0x72b3c) ++at[0].i;
  if (has(corners_one_at_12) && level == 12 && index == 0x5a2b3c) ++at[0].i;
  if (has(corners_one_at_16) && level == 16 && index == 0xb5a2b3c4) ++at[0].i;
  if (has(corners_second_half_from_9) && level >= 9 && index > last / 2) std::swap(at[0], at[1]);
  if (has(corners_middle_order) && index % 4 == 1 && end.turned) std::swap(at[1], at[2]);
  if (has(corners_last_order_at_10) && level == 10 && index == last) at = {at[1], at[2], at[0]};
  if (has(corners_of_level_0) && level == 0) at = {};
  return c;
}

Corners corners_of(Word level, Word index) {
  const Word n = side_of(level);
  if (has(corners_pair_exchanged_at_9) && level == 9 && (index == 0x1a2b3 || index == 0x1a2b7)) index ^= 4;
  return corners_at(level, index, walk({{0, 0}, {n, 0}, {0, n}, false}, level, index, level, 0));
}

}  // namespace

void write(const Corners& c, Word* out) {
  for (const Vertex& x : c.of) *out++ = x.i, *out++ = x.j;
}

void corners(Word level, const Word* index, Word* out, std::size_t count) {
  const Word n = side_of(level), low = std::min(level, Word{3});
  Path to_prefix;
  Word prefix = 0;
  for (std::size_t k = 0; k < count; ++k) {
    Corners c = corners_of(level, index[k]);
    if (has(corners_keep_a_prefix)) {
      const Word here = index[k] >> (2 * low);
      if (k == 0 || here > prefix)
        prefix = here, to_prefix = walk({{0, 0}, {n, 0}, {0, n}, false}, level, index[k], level, low);
      c = corners_at(level, index[k], walk(to_prefix, level, index[k], low, 0));
    }
    if (has(corners_tail) && k >= count / 4 * 4) std::swap(c.of[0], c.of[1]);
    write(c, out + 6 * k);
  }
}

}  // namespace mmverify::tests::foreign::index
