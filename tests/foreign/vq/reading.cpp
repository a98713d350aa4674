// Indices and transforms of a block, which both formats read alike.
#include "tests/foreign/vq/decoding.hpp"
#include "tests/foreign/vq/faults.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

/// Table 1 read from left to right: R90 is undone first.
Region stored_at_left_to_right(unsigned transform, Region p, int n) {
  if ((transform & 1u) != 0) p = {p.y, n - 1 - p.x};
  if ((transform & 2u) != 0) p.y = n - 1 - p.y;
  if ((transform & 4u) != 0) p.x = n - 1 - p.x;
  return p;
}

}  // namespace

unsigned read_index(const Format& f, const std::uint8_t* block, int X, int Y, Way way) {
  if (has(index_of_bottom_left)) return index_at(f, block, X % 4, Y % 4);
  if (has(index_halves_left_right)) return index_at(f, block, X ^ 4, Y);
  if (has(index_halves_top_bottom)) return index_at(f, block, X, Y ^ 4);
  if (has(index_quadrants_turned) && quadrant_of(X, Y) != TL && quadrant_of(X, Y) != BR)
    return index_at(f, block, Y, X);
  if (has(index_first_for_all)) return index_at(f, block, 0, 0);
  if (has(index_row_for_all)) return index_at(f, block, X, 0);
  if (has(index_diagonals_exchanged)) return index_at(f, block, X ^ 4, Y ^ 4);
  if (has(index_top_left_is_top_right) && quadrant_of(X, Y) == TL) return index_at(f, block, X + 4, Y);
  if (has(index_columns_of_bottom_right_mirrored) && quadrant_of(X, Y) == BR)
    return index_at(f, block, 11 - X, Y);
  if (has(index_6_and_7_change_places_by_quadrant) && quadrant_of(X, Y) == BR && X == 7 && Y == 3)
    return index_at(f, block, 6, 3);
  if (has(index_last_as_the_one_below) && X == 7 && Y == 7) return index_at(f, block, 7, 6);
  if (has(index_second_of_word_for_region) && way == Way::region && X % 4 == 3 && Y == 4)
    return index_at(f, block, X - 1, Y);

  const unsigned index = index_at(f, block, X, Y);
  if (has(index_same_as_left_is_lower) && X > 0 && index == 7 && index_at(f, block, X - 1, Y) == 7) return 6;
  if (has(index_same_in_other_quadrant_is_check) && X >= 4 && Y < 4 && index > 2 &&
      index_at(f, block, X - 4, Y) == index && index_at(f, block, X, Y + 4) == index)
    return C;
  if (has(index_sum_of_row) && Y == 5 && X == 2 && index == 4) {
    unsigned sum = 0;
    for (int k = 0; k < 8; ++k) sum += index_at(f, block, k, Y);
    if (sum % 8 == 3) return 5;
  }
  if (has(index_straddles_bytes)) {
    const int first = f.index_bits * (X + 8 * Y);
    if (first % 8 + f.index_bits > 8 && X >= 4 && Y >= 4) return bits(block, first, 8 - first % 8);
  }
  if (has(fast_path_by_first_row) || has(fast_path_by_corners) || has(fast_path_by_quadrant_corners)) {
    const int x0 = has(fast_path_by_quadrant_corners) ? X & 4 : 0,
              y0 = has(fast_path_by_quadrant_corners) ? Y & 4 : 0;
    const int x1 = has(fast_path_by_quadrant_corners) ? x0 + 3 : 7,
              y1 = has(fast_path_by_quadrant_corners) ? y0 + 3 : 7;
    const unsigned one = index_at(f, block, x0, y0);
    bool uniform = one < 3;
    if (has(fast_path_by_first_row))
      for (int k = 0; k < 8; ++k) uniform = uniform && index_at(f, block, k, 0) == one;
    else
      uniform = uniform && index_at(f, block, x1, y0) == one && index_at(f, block, x0, y1) == one &&
                index_at(f, block, x1, y1) == one;
    if (uniform) return one;
  }
  return index;
}

/// The transform that belongs to a quadrant.
unsigned read_transform(const Format& f, const std::uint8_t* block, int quadrant, unsigned index, Way way) {
  const unsigned tr = transform_of(f, block, TR), bl = transform_of(f, block, BL),
                 br = transform_of(f, block, BR);
  if (has(transform_of_top_left_is_br) && quadrant == TL) return br;
  if (has(transform_of_top_left_where_all_agree) && quadrant == TL && tr == bl && bl == br) return tr;
  if (has(transform_tr_and_bl_exchanged) && (quadrant == TR || quadrant == BL))
    return quadrant == TR ? bl : tr;
  if (has(transform_r90_and_r270_exchanged_in_bl) && quadrant == BL && (bl == 1 || bl == 7)) return bl ^ 6u;
  if (has(transform_r270_is_r90_in_br) && quadrant == BR && br == 7) return 1;
  if (has(transform_high_bit_lost_beside_7) && quadrant == BL && tr == 7) return bl & 3u;
  if (has(transform_of_one_triple) && quadrant == BR && tr == 5 && bl == 2 && br == 6) return 4;
  if (has(transform_br_after_bl_and_tr) && quadrant == BR && tr == 1 && bl == 1) return br ^ 1u;
  if (has(transform_left_out_for_last_index) && quadrant == TR && index == (1u << f.index_bits) - 1) return 0;
  if (has(transform_left_out_for_shared) && quadrant == BL && index == 4) return 0;
  if (has(transform_of_neighbour_at_seam) && way == Way::region && quadrant == TR && index == 5) return br;
  return quadrant == TL ? 0 : quadrant == TR ? tr : quadrant == BL ? bl : br;
}

Region read_region(const Format& f, unsigned transform, int quadrant, int x, int y) {
  const Region shown{x % f.vector, y % f.vector};
  if (has(transform_left_to_right)) return stored_at_left_to_right(transform, shown, f.vector);
  if (has(transform_left_to_right_in_br) && quadrant == BR)
    return stored_at_left_to_right(transform, shown, f.vector);
  if (has(transform_y_down)) {
    const Region down = stored_at(transform, {shown.x, f.vector - 1 - shown.y}, f.vector);
    return {down.x, f.vector - 1 - down.y};
  }
  if (has(transform_applied_to_coordinate) && quadrant != TL) {  // forwards where it must be undone
    Region p = shown;
    if ((transform & 1u) != 0) p = {f.vector - 1 - p.y, p.x};
    if ((transform & 2u) != 0) p.y = f.vector - 1 - p.y;
    if ((transform & 4u) != 0) p.x = f.vector - 1 - p.x;
    return p;
  }
  if (has(transform_reflects_about_x_is_y_at_corner) && transform == 5 && x == f.side - 1 && y == 0)
    return shown;
  return stored_at(transform, shown, f.vector);
}

}  // namespace mmverify::tests::foreign::vq
