// From a hit's barycentrics to its micro-triangle, and from there to its corners.
#ifndef MMVERIFY_SHADERS_INDEX
#define MMVERIFY_SHADERS_INDEX

#include "shaders/numbers.glsl"

/// A micro-triangle: the grid square of corner (iu, iv), and which half of it, 0 the one at that corner, 1 the other.
struct MmFace {
  uint iu, iv, upper;
};

/// A point on the level's grid.
struct MmPoint {
  uint iu, iv;   ///< floor(u N), floor(v N)
  float fu, fv;  ///< what the floors leave
  uint beyond;   ///< 1 where fu + fv >= 1
};

/// The place of (u, v) on the grid. fu and fv are exact: so are a product with a power of two, and
/// subtracting the floor.
///   fu + fv >= 1  is asked as  min(fu, fv) >= 1 - max(fu, fv)
/// The sum may round up to 1; the difference is exact from max >= 1/2 on (Sterbenz), and below that no rounding brings it
/// down to 1/2 > min.  So the answer is exact on every device, whatever its rounding and even where denormals are flushed,
/// as long as the compiler does not rearrange it: docs/SHADERS.md.
/// Domain: u, v >= 0; level <= 16.  More than 1 counts as 1.
MmPoint mm_point(uint level, float u, float v) {
  float side = float(mm_side(level));
  MM_PRECISE float x = clamp(u, 0.0f, 1.0f) * side, y = clamp(v, 0.0f, 1.0f) * side;
  MmPoint p;
  p.iu = uint(x);
  p.iv = uint(y);
  MM_PRECISE float fu = x - float(p.iu), fv = y - float(p.iv);
  p.fu = fu;
  p.fv = fv;
  MM_PRECISE float rest = 1.0f - max(fu, fv);
  p.beyond = min(fu, fv) >= rest ? 1u : 0u;
  return p;
}

/// The micro-triangle that holds the point, ties as Vulkan has them: u = i/N and v = j/N to the greater side, u + v = k/N to
/// the lesser.  Domain: as mm_point.  Source: VK_EXT_opacity_micromap, appendix "Reference Code".
MmFace mm_face_of_point(uint level, MmPoint p) {
  uint last = mm_side(level) - 1u;
  uint iv = min(p.iv, last), iu = min(p.iu, last - iv);
  uint row = min(p.iu + p.iv + p.beyond, last);
  return MmFace(iu, iv, row - (iu + iv));
}

/// Number of a micro-triangle on the curve.
///   b0 = iu XOR row,  t = (iu XOR iv) AND b0,  b1 = ((prefix xor of t, from above) XOR iu) AND NOT b0, OR t;  row = iu + iv
///   + upper; b0 in the even bits, b1 in the odd
/// Domain: iu + iv + upper < N.
uint mm_curve_index(MmFace f) {
  uint row = f.iu + f.iv + f.upper;
  uint b0 = f.iu ^ row, t = (f.iu ^ f.iv) & b0;
  uint b1 = ((mm_xor_from_above(t) ^ f.iu) & ~b0) | t;
  return mm_apart(b0) | mm_apart(b1) << 1;
}

/// The micro-triangle of a number on the curve. Domain: index < 4^level, any level up to 16.
MmFace mm_curve_face(uint index) {
  uint b0 = mm_together(index), b1 = mm_together(index >> 1);
  uint t = b0 & b1, f = mm_xor_from_above(t), m = mm_xor_from_above(b0 & ~b1), inverted = m >> 1;
  return MmFace((b0 & inverted) | (~b0 & (b1 ^ f) & 0xffffu), inverted ^ t, m & 1u);
}

/// Index of the micro-triangle that holds (u, v), exactly for these very numbers.
/// Domain: u, v >= 0, level <= 16; always below 4^level.
uint mm_index_exact(uint level, float u, float v) {
  return mm_curve_index(mm_face_of_point(level, mm_point(level, u, v)));
}

/// The same as the specification's reference code has it in binary32: fu + fv, which may round up to 1.
/// Domain: as mm_index_exact.  Source: VK_EXT_opacity_micromap, appendix "Reference Code".
uint mm_index_published(uint level, float u, float v) {
  MmPoint p = mm_point(level, u, v);
  MM_PRECISE float sum = p.fu + p.fv;
  p.beyond = sum >= 1.0f ? 1u : 0u;
  return mm_curve_index(mm_face_of_point(level, p));
}

/// Number of a micro-triangle in row order: row^2 + 2 iv + upper, row = iu + iv + upper.
/// Source: Color and Attribute Micromaps, figure 4.
uint mm_row_index_of(MmFace f) {
  uint row = f.iu + f.iv + f.upper;
  return row * row + 2u * f.iv + f.upper;
}

/// The micro-triangle of a number in row order. Domain: index < 4^level, level <= 16.
MmFace mm_row_face(uint index) {
  uint row = mm_square_root(index), c = index - row * row;
  return MmFace(row - (c + 1u) / 2u, c / 2u, c & 1u);
}

/// Row order at a point, ties as figure 4 has them: row floor((u+v) N), column floor(v N), diagonal floor((1-u) N).
/// Domain: as mm_point.
uint mm_row_index(uint level, float u, float v) {
  uint last = mm_side(level) - 1u;
  MmPoint p = mm_point(level, u, v);
  uint row = min(p.iu + p.iv + p.beyond, last), column = min(row, p.iv);
  // The test uses bits, as a device may take a denormal u for 0 in a comparison.
  bool behind = p.fu > 0.0f || (p.iu == 0u && (floatBitsToUint(u) & 0x7fffffffu) != 0u);
  uint diagonal = min(last, last + 1u - min(p.iu + (behind ? 1u : 0u), last + 1u));
  return row * row + column + diagonal - (last - row);
}

/// Corners of a micro-triangle in units of 1/N along u and v: the base, one step along u and one along v from there; the
/// base of an upper one is (iu + 1, iv + 1), and its steps are -1.
void mm_corners(MmFace f, MM_OUT(uvec2) base, MM_OUT(uvec2) along_u, MM_OUT(uvec2) along_v) {
  base = uvec2(f.iu + f.upper, f.iv + f.upper);
  uint other = 1u - f.upper;
  along_u = uvec2(f.iu + other, base.y);
  along_v = uvec2(base.x, f.iv + other);
}

#endif
