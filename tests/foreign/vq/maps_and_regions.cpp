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

void regions(const Format& f, StateAt state_at, const std::uint8_t* block, const std::uint32_t* x,
             const std::uint32_t* y, std::uint8_t* state, std::size_t count) {
  struct Last {
    int X = -1, Y = -1;
  } last;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t from = k;
    if (has(region_batch_over_256)) from = k & 255u;
    if (has(region_batch_over_1024)) from = k & 1023u;
    int i = static_cast<int>(x[from]), j = static_cast<int>(y[from]);
    const int X = i / f.vector, Y = j / f.vector;

    // Caches of the vector that was asked last.
    if (has(region_cache_by_x)) {
      if (X != last.X) last = {X, Y};
      j = last.Y * f.vector + j % f.vector;
    }
    if (has(region_cache_by_sum)) {
      if (X + 8 * Y != last.X + 8 * last.Y && X + Y != last.X + last.Y) last = {X, Y};
      if (X + Y == last.X + last.Y)
        i = last.X * f.vector + i % f.vector, j = last.Y * f.vector + j % f.vector;
    }
    if (has(region_cache_across_seam) && k > 0) {  // keyed by the place within a quadrant
      if (X % 4 == last.X % 4 && Y % 4 == last.Y % 4 && X != last.X && Y != last.Y)
        i = last.X * f.vector + i % f.vector, j = last.Y * f.vector + j % f.vector;
    }
    if (has(region_cache_by_x) || has(region_cache_by_sum)) {
    } else {
      last = {X, Y};
    }
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

    // Caches of blocks.
    if (has(region_block_by_its_first_bytes) || has(region_block_by_its_last_bytes)) {
      static thread_local std::uint8_t held[64];
      static thread_local int held_side = 0;
      const std::size_t size = f.side == 16 ? 32 : 64;
      const std::size_t key = has(region_block_by_its_first_bytes) ? 0 : size - 8;
      if (held_side != f.side || std::memcmp(held + key, block + key, 8) != 0) {
        std::memcpy(held, block, size);
        held_side = f.side;
      }
      state[k] = state_at(held, i, j, Way::region);
      continue;
    }
    if (has(region_block_by_xor)) {
      static thread_local std::uint8_t held[64];
      static thread_local int held_side = 0;
      const std::size_t size = f.side == 16 ? 32 : 64;
      const auto sum = [size](const std::uint8_t* of) {
        std::uint64_t all = 0;
        for (std::size_t at = 0; at < size; at += 8) {
          std::uint64_t word;
          std::memcpy(&word, of + at, 8);
          all ^= word;
        }
        return all;
      };
      if (held_side != f.side || sum(held) != sum(block)) {
        std::memcpy(held, block, size);
        held_side = f.side;
      }
      state[k] = state_at(held, i, j, Way::region);
      continue;
    }
    state[k] = state_at(block, i, j, Way::region);
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
