// The places of attribute values in a map, their interpolation at a point, and the level of detail of a ray.
#ifndef MMVERIFY_SHADERS_ATTRIBUTE
#define MMVERIFY_SHADERS_ATTRIBUTE

#include "shaders/index.glsl"

// Orders, numbered as mmverify_subject.h does.
const uint MM_VERTICES_W_MINOR = 0u, MM_VERTICES_U_MAJOR = 1u, MM_VERTICES_BIRD = 2u;
const uint MM_FACES_CURVE = 0u, MM_FACES_ROWS = 1u, MM_FACES_U_MAJOR = 2u;

// ---- the Bird order: each level's new vertices, three for each upright micro-triangle of the level below ----

/// Micro-triangles before number x of the curve that stand upright.  Under each digit 1, the middle child, up and down
/// change places.  Domain: x < 4^level, level <= 15.
uint mm_upright_before(uint x, uint level) {
  int excess = 0, sign_ = 1;
  for (uint l = level; l-- > 0u;) {
    uint digit = x >> 2u * l & 3u;
    if ((digit & 1u) != 0u) excess += sign_ * int(mm_side(l));
    if (digit == 1u) sign_ = -sign_;
  }
  return uint(int(x) + excess) / 2u;
}

/// The number on the curve of upright micro-triangle k.  Domain: k < N (N + 1) / 2, level <= 15.
uint mm_upright_number(uint k, uint level) {
  uint x = 0u;
  bool upright = true;
  for (uint l = level; l-- > 0u;) {
    uint S = mm_side(l), digit = 0u;
    for (; digit < 3u; ++digit) {
      bool same = digit != 1u ? upright : !upright;
      uint held = same ? mm_triangular(S) : mm_triangular(S - 1u);
      if (k < held) break;
      k -= held;
    }
    if (digit == 1u) upright = !upright;
    x = 4u * x + digit;
  }
  return x;
}

uint mm_bird_index(uint i, uint j, uint level) {
  uint N = mm_side(level);
  if ((i == 0u || i == N) && (j == 0u || j == N)) return i != 0u ? 1u : j != 0u ? 2u : 0u;
  uint shift = uint(findLSB(i | j)), m = level - shift;
  i >>= shift;
  j >>= shift;
  uint edge = (i & 1u) == 0u ? 0u : (j & 1u) != 0u ? 1u : 2u;
  uint parent = mm_curve_index(MmFace(i >> 1, j >> 1, 0u));
  return mm_vertex_count(m - 1u) + 3u * mm_upright_before(parent, m - 1u) + edge;
}

uvec2 mm_bird_place(uint index, uint level) {
  uint N = mm_side(level);
  if (index < 3u) return uvec2(index == 1u ? N : 0u, index == 2u ? N : 0u);
  uint m = level;
  while (mm_vertex_count(m - 1u) > index) --m;
  uint from = index - mm_vertex_count(m - 1u), edge = from % 3u;
  MmFace parent = mm_curve_face(mm_upright_number(from / 3u, m - 1u));
  return uvec2(2u * parent.iu + (edge != 0u ? 1u : 0u), 2u * parent.iv + (edge != 2u ? 1u : 0u)) << (level - m);
}

// ---- vertices ----

/// Index of vertex (i, j), i steps along u and j along v.  Results are modulo 2^32, and fit at every level.
///   W-minor r(r+1)/2 + j, r = i+j;  U-major i(N+2) - i(i+1)/2 + j;  Bird above
/// Domain: i + j <= N, level <= 16.  Source: Color and Attribute Micromaps, 3.1; docs/ATTRIBUTE.md.
uint mm_vertex_index(uint level, uint order, uint i, uint j) {
  if (order == MM_VERTICES_W_MINOR) return mm_triangular(i + j) + j;
  if (order == MM_VERTICES_BIRD) return mm_bird_index(i, j, level);
  return i * (mm_side(level) + 2u) - mm_triangular(i) + j;
}

/// The vertex of an index. Domain: index < (N+1)(N+2)/2.
uvec2 mm_vertex_place(uint level, uint order, uint index) {
  if (order == MM_VERTICES_BIRD) return mm_bird_place(index, level);
  // U-major order is rows counted backwards from the u-corner.
  bool back = order == MM_VERTICES_U_MAJOR;
  uint x = back ? mm_vertex_count(level) - 1u - index : index;
  uint r = mm_triangular_root(x), c = x - mm_triangular(r);
  return back ? uvec2(mm_side(level) - r, r - c) : uvec2(r - c, c);
}

// ---- faces ----

/// Index of a micro-triangle.  U-major: N^2 - (N-iu)^2 + 2 iv + upper.  Domain: iu + iv + upper < N, level <= 16.
uint mm_face_index(uint level, uint order, MmFace f) {
  if (order == MM_FACES_CURVE) return mm_curve_index(f);
  if (order == MM_FACES_ROWS) return mm_row_index_of(f);
  uint N = mm_side(level), left = N - f.iu;
  return N * N - left * left + 2u * f.iv + f.upper;
}

/// The micro-triangle of an index. Domain: index < 4^level.
MmFace mm_face_at(uint level, uint order, uint index) {
  if (order == MM_FACES_CURVE) return mm_curve_face(index);
  if (order == MM_FACES_ROWS) return mm_row_face(index);
  uint N = mm_side(level), all = N * N;
  uint left = mm_square_root(all - 1u - index) + 1u, c = index - (all - left * left);
  return MmFace(N - left, c >> 1, c & 1u);
}

/// Indices of a micro-triangle's vertices, in the order of mm_corners.
uvec3 mm_triplet(uint level, uint order, MmFace f) {
  uvec2 base, along_u, along_v;
  mm_corners(f, base, along_u, along_v);
  return uvec3(mm_vertex_index(level, order, base.x, base.y), mm_vertex_index(level, order, along_u.x, along_u.y),
               mm_vertex_index(level, order, along_v.x, along_v.y));
}

/// The face with these vertices, in that order; the first two determine it.
MmFace mm_face_of(uint level, uint order, uvec3 vertices) {
  uvec2 a = mm_vertex_place(level, order, vertices.x), b = mm_vertex_place(level, order, vertices.y);
  uint upper = b.x < a.x ? 1u : 0u;
  return MmFace(upper != 0u ? b.x : a.x, a.y - upper, upper);
}

// ---- points ----

/// A point's micro-triangle, and its barycentrics there in the order of mm_corners.
struct MmHit {
  MmFace face;
  vec3 weights;
};

/// The remap of a hit to its micro-triangle, by the uniform pattern: with a = 1 - fv,
///   lower (a - fu, fu, fv);  upper (fu - a, 1 - fu, a)
/// fu and fv are exact, each weight is within 2^-24 and none is below 0, at every level; Cramer's rule on the corners loses
/// two bits a level and divides by 0 at level 14 (docs/ERRATA.md).
/// Domain: u, v >= 0, u + v <= 1; level <= 16.  Source: Color and Attribute Micromaps, 4.1, by another way.
MmHit mm_hit(uint level, float u, float v) {
  MmPoint p = mm_point(level, u, v);
  MmFace f = mm_face_of_point(level, p);
  float side = float(mm_side(level));
  MM_PRECISE float fu = clamp(u, 0.0f, 1.0f) * side - float(f.iu), fv = clamp(v, 0.0f, 1.0f) * side - float(f.iv);
  MM_PRECISE float a = 1.0f - fv, rest = 1.0f - fu;
  MM_PRECISE vec3 w;
  if (f.upper != 0u) {
    w = vec3(fu - a, rest, a);
  } else {
    float kept = min(fu, a);
    w = vec3(a - kept, kept, fv);
  }
  return MmHit(f, w);
}

/// The value interpolated between three.
vec4 mm_interpolate(vec3 weights, vec4 a, vec4 b, vec4 c) {
  MM_PRECISE vec4 mixed = weights.x * a + weights.y * b + weights.z * c;
  return mixed;
}

/// The same for bytes r | g << 8 | b << 16 | a << 24, rounded half up.
uint mm_interpolate_rgba8(vec3 weights, uint a, uint b, uint c) {
  uint mixed = 0u;
  for (uint shift = 0u; shift < 32u; shift += 8u) {
    MM_PRECISE float sum = weights.x * float(a >> shift & 0xffu) + weights.y * float(b >> shift & 0xffu) +
                           (weights.z * float(c >> shift & 0xffu) + 0.5f);
    mixed |= uint(sum) << shift;
  }
  return mixed;
}

// ---- decimated edges, mips, level of detail ----

/// The vertex that the value of (i, j) is read from where the edges of `flags` (1 w-u, 2 u-v, 4 v-w) have a neighbour of one
/// level less: away from the middle of the edge; the middle of level 1 to w, u, v.
/// Source: Color and Attribute Micromaps, figure 3; docs/ATTRIBUTE.md.
uvec2 mm_decimate(uint level, uint flags, uint i, uint j) {
  uint N = mm_side(level), middle = N >> 1, k = N - i - j;
  bool odd_i = N > 1u && (i & 1u) != 0u, odd_j = N > 1u && (j & 1u) != 0u;
  if ((flags & 1u) != 0u && j == 0u && odd_i) {
    i = k < middle ? i + 1u : i - 1u;
  } else if ((flags & 2u) != 0u && k == 0u && odd_j) {
    bool towards_v = i < middle;
    i = towards_v ? i - 1u : i + 1u;
    j = towards_v ? j + 1u : j - 1u;
  } else if ((flags & 4u) != 0u && i == 0u && odd_j) {
    j = j < middle ? j - 1u : j + 1u;
  }
  return uvec2(i, j);
}

/// The mean of four codes: 0 half up, 1 half to even, 2 truncate, 3 two halves, each up.
uint mm_mean(uint rounding, uint a, uint b, uint c, uint d) {
  uint sum = a + b + c + d;
  if (rounding == 0u) return (sum + 2u) / 4u;
  if (rounding == 1u) return (sum + 1u + (sum / 4u & 1u)) / 4u;
  if (rounding == 2u) return sum / 4u;
  return ((a + b + 1u) / 2u + (c + d + 1u) / 2u + 1u) / 2u;
}

/// The face above four, byte by byte.  Children of face k of the curve are 4k to 4k + 3.
uint mm_face_mip(uint rounding, uint a, uint b, uint c, uint d) {
  uint mixed = 0u;
  for (uint shift = 0u; shift < 32u; shift += 8u)
    mixed |= mm_mean(rounding, a >> shift & 0xffu, b >> shift & 0xffu, c >> shift & 0xffu, d >> shift & 0xffu) << shift;
  return mixed;
}

/// A positive float as exponent and fraction of 23 bits, from its bits: a device may take denormals for 0.
ivec2 mm_exponent_and_fraction(float x) {
  uint bits = floatBitsToUint(x), exponent = bits >> 23, fraction = bits & 0x7fffffu;
  if (exponent != 0u) return ivec2(exponent, fraction);
  int up = 23 - findMSB(fraction);
  return ivec2(1 - up, fraction << uint(up) & 0x7fffffu);
}

/// A level of a chain, and how much of the next one.
struct MmLod {
  uint level;
  float blend;
};

/// The greatest m in 0..level with 4^m cone <= triangle, both areas; blend = 1/2 log2(triangle / (4^m cone)), 0 at the ends.
/// m is exact for all finite areas: floor(0.5 log2(...)) is not, and is wrong next to 4^m (docs/ATTRIBUTE.md).  NaN and areas
/// below 0 count as 0; a cone of 0 asks for `level`.
/// Source: Color and Attribute Micromaps, 4.4.2; docs/ERRATA.md for its readings.
MmLod mm_lod(uint level, float cone, float triangle) {
  uint c = floatBitsToUint(cone), t = floatBitsToUint(triangle);
  bool no_cone = c == 0u || c >> 31 != 0u || c > 0x7f800000u, no_triangle = t == 0u || t >> 31 != 0u || t > 0x7f800000u;
  if (no_cone) return MmLod(level, 0.0f);
  if (no_triangle) return MmLod(0u, 0.0f);
  ivec2 ec = mm_exponent_and_fraction(cone), et = mm_exponent_and_fraction(triangle);
  int steps = et.x - ec.x - (et.y < ec.y ? 1 : 0);
  int m = steps >> 1;
  if (m < 0) return MmLod(0u, 0.0f);
  if (m >= int(level)) return MmLod(level, 0.0f);
  // The quotient of the areas over 4^m, in [1, 4).
  float quotient = uintBitsToFloat(0x3f800000u | uint(et.y)) / uintBitsToFloat(0x3f800000u | uint(ec.y));
  float blend = 0.5f * (log2(quotient) + float(et.x - ec.x - 2 * m));
  return MmLod(uint(m), clamp(blend, 0.0f, 0.99999994f));
}

/// Area of a ray cone's footprint where it has gone `distance`: a disc of radius `width` / 2 + distance tan(spread / 2), seen at
/// an angle of cosine `facing`.  Source: the paper names ray cones and gives no formula; this one is Akenine-Moeller et al.'s.
float mm_cone_area(float width, float spread, float distance_, float facing) {
  float radius = 0.5f * width + distance_ * tan(0.5f * spread);
  return 3.14159265f * radius * radius / max(abs(facing), 1.0e-6f);
}

#endif
