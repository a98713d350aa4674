// A region of a square map out of its block.  docs/VQ.md has the order of a block's bits.
//
// Before the include MM_VQ_WORD(k) has to be defined: word k of the block, four bytes, the first the lowest.
#ifndef MMVERIFY_SHADERS_VQ
#define MMVERIFY_SHADERS_VQ

/// States of regions: transparent, look at the texture, opaque.
const uint MM_T = 0u, MM_C = 1u, MM_O = 2u;

/// `count` bits of the block from bit `at` on.  Domain: count in 1..20, within the block.
uint mm_vq_bits(uint at, uint count) {
  uint word = at >> 5, shift = at & 31u;
  uint bits = MM_VQ_WORD(word) >> shift;
  if (shift + count > 32u) bits |= MM_VQ_WORD(word + 1u) << (32u - shift);
  return bits & ((1u << count) - 1u);
}

/// 0 TL, 1 TR, 2 BL, 3 BR of the vector (X, Y): L has X < 4, B has Y < 4.
uint mm_vq_quadrant(uint X, uint Y) { return (X < 4u ? 0u : 1u) + (Y < 4u ? 2u : 0u); }

/// The region of a vector that a transform fills this one from.  Transforms are 4 LR + 2 TB + R90, undone in the order LR, TB,
/// R90.  Source: Compressed Opacity Maps, 4.1, table 1.
uvec2 mm_vq_filled_from(uint transform, uint x, uint y, uint last) {
  if ((transform & 4u) != 0u) x = last - x;
  if ((transform & 2u) != 0u) y = last - y;
  return (transform & 1u) != 0u ? uvec2(y, last - x) : uvec2(x, y);
}

/// The quadrant's transform: three bits each of TR, BL, BR from `first` on; TL has none.
uint mm_vq_transform(uint quadrant, uint first) {
  return quadrant == 0u ? 0u : mm_vq_bits(first + 3u * (quadrant - 1u), 3u);
}

/// C where the region's bit is set, else the palette's state, T or O.
uint mm_vq_picked(uint palette, uint checked) { return checked != 0u ? MM_C : palette != 0u ? MM_O : MM_T; }

/// The state of region (x, y), y upwards.  Domain: x, y < 16; a block of 256 bits.
/// Source: Compressed Opacity Maps, 4, figures 4 and 11.
uint mm_vq2_region(uint x, uint y) {
  uint X = x >> 1, Y = y >> 1, quadrant = mm_vq_quadrant(X, Y);
  uint index = mm_vq_bits(3u * (X + 8u * Y), 3u);
  if (index < 3u) return index;  // the uniform vector of T, C, O
  uint entry = index < 6u ? index - 3u : 3u + 2u * quadrant + index - 6u;
  uint code = mm_vq_bits(201u + 5u * entry, 5u);
  uvec2 from = mm_vq_filled_from(mm_vq_transform(quadrant, 192u), x & 1u, y & 1u, 1u);
  return mm_vq_picked(code >> 4, code >> (from.x + 2u * from.y) & 1u);
}

/// The same.  Domain: x, y < 32; a block of 512 bits.
/// Source: Compressed Opacity Maps, 5, table 2, figure 11.
uint mm_vq4_region(uint x, uint y) {
  uint X = x >> 2, Y = y >> 2, quadrant = mm_vq_quadrant(X, Y);
  uint index = mm_vq_bits(4u * (X + 8u * Y), 4u);
  if (index < 3u) return index;
  uvec2 from = mm_vq_filled_from(mm_vq_transform(quadrant, 256u), x & 3u, y & 3u, 3u);
  uint bit = from.x + 4u * from.y;
  if (index < 6u) {  // one palette
    uint code = mm_vq_bits(265u + 17u * (index - 3u), 17u);
    return mm_vq_picked(code >> 16, code >> bit & 1u);
  }
  if (index < 8u) {  // one a half: the columns of entry 6, the rows of entry 7
    uint code = mm_vq_bits(316u + 18u * (index - 6u), 18u), half_ = (index == 6u ? from.x : from.y) >> 1;
    return mm_vq_picked(code >> (16u + half_) & 1u, code >> bit & 1u);
  }
  uint code = mm_vq_bits(352u + 20u * (index - 8u), 20u) >> 5u * ((from.x >> 1) + 2u * (from.y >> 1));
  return mm_vq_picked(code >> 4 & 1u, code >> ((from.x & 1u) + 2u * (from.y & 1u)) & 1u);
}

#endif
