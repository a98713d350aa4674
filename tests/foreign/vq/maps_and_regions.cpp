// Decoding, whole maps and batches of regions.
#include <cstddef>
#include <cstring>

#include "tests/foreign/vq/decoding.hpp"
#include "tests/foreign/vq/entry_points.hpp"
#include "tests/foreign/vq/faults.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

using StateAt = std::uint8_t (*)(const std::uint8_t*, int, int, Way);

void decode(const Format& f, StateAt state_at, const std::uint8_t* block, std::uint8_t* map) {
  for (int y = 0; y < f.side; ++y)
    for (int x = 0; x < f.side; ++x) {
      std::uint8_t state = state_at(block, x, y, Way::whole);
      if (has(decode_row_copied_if_indices_repeat) && y % f.vector == 0 && y >= f.vector && x >= f.vector) {
        // A vector whose index is that of the vector below is copied from there, other quadrant or not.
        const int X = x / f.vector, Y = y / f.vector;
        if (Y == 4 && index_at(f, block, X, Y) == index_at(f, block, X, Y - 1))
          state = map[x + f.side * (y - f.vector)];
      }
      if (has(decode_last_region_of_earlier_map) && x == f.side - 1 && y == f.side - 1 &&
          index_at(f, block, 7, 7) == 6 && index_at(f, block, 0, 0) == 6)
        state = map[0];
      map[x + f.side * y] = state;
    }
}

struct Place {
  int x, y;
};

/// Caches of the vector that was asked last: where a state is read in place of `at`, by what `last` was.
Place by_cached_vector(const Format& f, Place at, Place& last, bool is_first) {
  const int X = at.x / f.vector, Y = at.y / f.vector;
  const auto in_last = [&] {
    return Place{last.x * f.vector + at.x % f.vector, last.y * f.vector + at.y % f.vector};
  };
  if (has(region_cache_by_x)) {
    if (X != last.x) last = {X, Y};
    at.y = in_last().y;
  }
  if (has(region_cache_by_sum)) {
    if (X + 8 * Y != last.x + 8 * last.y && X + Y != last.x + last.y) last = {X, Y};
    if (X + Y == last.x + last.y) at = in_last();
  }
  if (has(region_cache_across_seam) && !is_first) {  // keyed by the place within a quadrant
    if (X % 4 == last.x % 4 && Y % 4 == last.y % 4 && X != last.x && Y != last.y) at = in_last();
  }
  if (!has(region_cache_by_x) && !has(region_cache_by_sum)) last = {X, Y};
  return at;
}

/// A block that is kept until one of another side or key is asked.
struct HeldBlock {
  std::uint8_t bytes[64] = {};
  int side = 0;
  void keep(const Format& f, const std::uint8_t* block, bool same_key) {
    if (side == f.side && same_key) return;
    std::memcpy(bytes, block, size(f));
    side = f.side;
  }
  static std::size_t size(const Format& f) { return f.side == 16 ? 32 : 64; }
};

std::uint64_t xor_of_words(const std::uint8_t* bytes, std::size_t size) {
  std::uint64_t all = 0;
  for (std::size_t at = 0; at < size; at += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes + at, 8);
    all ^= word;
  }
  return all;
}

/// Caches of blocks: the block that is read in place of `block`.
const std::uint8_t* by_cached_block(const Format& f, const std::uint8_t* block) {
  const std::size_t size = HeldBlock::size(f);
  if (has(region_block_by_its_first_bytes) || has(region_block_by_its_last_bytes)) {
    static thread_local HeldBlock held;
    const std::size_t key = has(region_block_by_its_first_bytes) ? 0 : size - 8;
    held.keep(f, block, std::memcmp(held.bytes + key, block + key, 8) == 0);
    return held.bytes;
  }
  if (has(region_block_by_xor)) {
    static thread_local HeldBlock held;
    held.keep(f, block, xor_of_words(held.bytes, size) == xor_of_words(block, size));
    return held.bytes;
  }
  return block;
}

void regions(const Format& f, StateAt state_at, const std::uint8_t* block, const std::uint32_t* x,
             const std::uint32_t* y, std::uint8_t* state, std::size_t count) {
  Place last{-1, -1};
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t from = k;
    if (has(region_batch_over_1024)) from = k & 1023u;
    auto [i, j] = by_cached_vector(f, {static_cast<int>(x[from]), static_cast<int>(y[from])}, last, k == 0);
    // Rows are expected in order.
    if (has(region_rows_in_order) && k > 0 && y[k] < y[k - 1]) j = static_cast<int>(y[k - 1]);
    if (has(region_tail_of_three) && count % 4 == 3 && count > 4 && k == count - 1)
      i = static_cast<int>(x[k - 1]);
    if (has(region_twice_in_a_row) && k > 0 && x[k] == x[k - 1] && y[k] == y[k - 1]) {
      state[k] = C;
      continue;
    }
    if (has(region_alone) && count == 1 && i % f.vector == 1 && j % f.vector == 1) i -= 1;
    if (has(region_x_of_four_bits) && f.side == 32) i = (i & 15) | (j >= 16 ? i & 16 : 0);
    if (has(region_at_15_is_14) && f.side == 16 && i == 15 && j == 8) i = 14;
    state[k] = state_at(by_cached_block(f, block), i, j, Way::region);
  }
}

}  // namespace

void vq2_decode(const std::uint8_t* block, std::uint8_t* map) { decode(vq2, vq2_state, block, map); }
void vq4_decode(const std::uint8_t* block, std::uint8_t* map) { decode(vq4, vq4_state, block, map); }

void vq2_region(const std::uint8_t* block, const std::uint32_t* x, const std::uint32_t* y,
                std::uint8_t* state, std::size_t count) {
  regions(vq2, vq2_state, block, x, y, state, count);
}

void vq4_region(const std::uint8_t* block, const std::uint32_t* x, const std::uint32_t* y,
                std::uint8_t* state, std::size_t count) {
  regions(vq4, vq4_state, block, x, y, state, count);
}

}  // namespace mmverify::tests::foreign::vq
