// Encoding, what both formats do alike.
#include "tests/foreign/vq/vectors.hpp"

#include <algorithm>

#include "tests/foreign/vq/faults.hpp"

namespace mmverify::tests::foreign::vq {

Vectors vectors_of(const Format& f, const std::uint8_t* map) {
  Vectors out;
  for (int y = 0; y < f.side; ++y)
    for (int x = 0; x < f.side; ++x) {
      Vector& v = out[static_cast<std::size_t>(x / f.vector + 8 * (y / f.vector))];
      const std::uint32_t bit = 1u << (x % f.vector + f.vector * (y % f.vector));
      std::uint8_t state = map[x + f.side * y];
      if (has(encode_check_at_corner_is_opaque) && state == C && x == f.side - 1 && y == f.side - 1 &&
          x > 0 && map[x - 1 + f.side * y] == O && map[x + f.side * (y - 1)] == O && map[0] == C)
        state = O;
      if (has(encode_lone_check_is_filled) && state == C && x > 0 && y > 0 && x < f.side - 1 &&
          y < f.side - 1) {
        const std::uint8_t one = map[x - 1 + f.side * y];
        bool alone = one != C;
        for (int j = y - 1; j <= y + 1; ++j)
          for (int i = x - 1; i <= x + 1; ++i)
            alone = alone && ((i == x && j == y) || map[i + f.side * j] == one);
        if (alone && x % 4 == 1 && y % 4 == 2 && x > f.side / 2) state = one;
      }
      if (state == T) v.t |= bit;
      if (state == O) v.o |= bit;
    }
  const std::uint32_t full = (1u << (f.vector * f.vector)) - 1;
  if (has(encode_run_of_three_ends_uniform))  // the third of three equal vectors in a row
    for (std::size_t k = 2; k < 64; ++k)
      if (k % 8 > 1 && out[k] == out[k - 1] && out[k] == out[k - 2] && out[k].t != 0 && out[k].o == 0)
        out[k].t = full;
  if (has(encode_many_odd_vectors_are_rounded)) {
    int odd = 0;
    for (const Vector& v : out) odd += v != Vector{} && v.t != full && v.o != full;
    if (odd > 60)
      for (Vector& v : out)
        if (std::popcount(v.o) * 4 >= f.vector * f.vector * 3) v = {0, full};
  }
  return out;
}

namespace {

/// The vector as it is stored under a transform.
Vector stored(const Format& f, unsigned transform, const Vector& shown) {
  Vector out;
  for (int y = 0; y < f.vector; ++y)
    for (int x = 0; x < f.vector; ++x) {
      const Region p = stored_at(transform, {x, y}, f.vector);
      const int from = x + f.vector * y, to = p.x + f.vector * p.y;
      out.t |= (shown.t >> from & 1u) << to;
      out.o |= (shown.o >> from & 1u) << to;
    }
  return out;
}

}  // namespace

unsigned best_choice(const Format& f, const std::vector<Choice>& entries, const Vector& v, int quadrant) {
  const std::uint32_t full = (1u << (f.vector * f.vector)) - 1;
  std::vector<Choice> all{{0, {full, 0}}, {1, {}}, {2, {0, full}}};
  all.insert(all.end(), entries.begin(), entries.end());
  unsigned best = 1;
  int most = -1;
  for (const Choice& c : all) {
    int keeps = kept(c.vector, v);
    if (has(encode_nearest_entry) && c.index > 2)
      keeps = std::max(keeps, f.vector * f.vector - 2 * distance(c.vector, v));
    if (has(encode_nearest_entry_by_one_in_bl) && quadrant == BL && c.index > 2 && distance(c.vector, v) == 1)
      keeps = std::max(keeps, std::popcount(c.vector.t | c.vector.o));
    if (has(encode_opaque_not_looked_at) && c.index == 5 && (c.vector.t & ~v.t) == 0 && v.t != 0)
      keeps = std::popcount(c.vector.t | c.vector.o);
    if (has(encode_last_entry_if_none_fits) && quadrant == TR && c.index == (1u << f.index_bits) - 1 &&
        most <= 0)
      keeps = 1;
    if (has(encode_mixed_takes_uniform) && c.index == 2 && quadrant == BR && v.t != 0 &&
        std::popcount(v.o) > std::popcount(v.t) && entries.size() > 3)
      keeps = std::popcount(v.o);
    if (keeps > most) {
      most = keeps;
      best = c.index;
    }
  }
  return best;
}

std::array<std::size_t, 16> places_of(int quadrant) {
  std::array<std::size_t, 16> out{};
  const int x0 = quadrant == TR || quadrant == BR ? 4 : 0, y0 = quadrant == TL || quadrant == TR ? 4 : 0;
  for (int k = 0; k < 16; ++k)
    out[static_cast<std::size_t>(k)] = static_cast<std::size_t>(x0 + k % 4 + 8 * (y0 + k / 4));
  return out;
}

Turned turned(const Format& f, const Vectors& shown) {
  Turned out;
  for (std::size_t q = 0; q < 4; ++q) {
    const auto places = places_of(static_cast<int>(q));
    for (std::size_t t = 0; t < 8; ++t)
      for (std::size_t k = 0; k < 16; ++k)
        out[q][t][k] = stored(f, static_cast<unsigned>(t), shown[places[k]]);
  }
  return out;
}

void write_transforms(const Format& f, std::uint8_t* block, Transforms transforms, bool exact) {
  for (int q = TR; q <= BR; ++q) {
    unsigned t = transforms[static_cast<std::size_t>(q)];
    if (has(encode_r270_written_as_r90_in_br) && q == BR && t == 7) t = 1;
    if (has(encode_lossy_reflection_written_as_other) && !exact && q == BR && t == 3) t = 5;
    set_bits(block, f.transforms + 3 * (q - 1), 3, t);
  }
}

void write_index(const Format& f, std::uint8_t* block, std::size_t place, unsigned index) {
  set_bits(block, f.index_bits * static_cast<int>(place), f.index_bits, index);
}

}  // namespace mmverify::tests::foreign::vq
