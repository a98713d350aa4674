// Whole numbers that several lookups need.
#ifndef MMVERIFY_SHADERS_NUMBERS
#define MMVERIFY_SHADERS_NUMBERS

// `precise` forbids a driver to rearrange floating-point expressions as if they were real numbers (SPIR-V NoContraction).
// Who wants to see what happens without it defines this as nothing before the first include.
#ifndef MM_PRECISE
#define MM_PRECISE precise
#endif

// The includes are read by C++, too (display/render/attribute/): hence the f of 1.0f, and parameters that a function writes.
#ifndef MM_OUT
#define MM_OUT(TYPE) out TYPE
#endif

/// Micro-triangles along an edge of the base triangle: N = 2^level.  Domain: level <= 16.
uint mm_side(uint level) { return 1u << level; }

/// r (r + 1) / 2.  Domain: r <= 65,537, so that the result fits; r (r + 1) alone does not from 65,536 on.
uint mm_triangular(uint r) { return (r & 1u) == 0u ? (r >> 1) * (r + 1u) : r * ((r + 1u) >> 1); }

/// Micro-vertices of a level: (N + 1)(N + 2) / 2.  Domain: level <= 16.
uint mm_vertex_count(uint level) { return mm_triangular(mm_side(level) + 1u); }

/// The greatest r with r (r + 1) / 2 <= x: no square root, whose error Vulkan leaves open.  Domain: r <= 65,537.
uint mm_triangular_root(uint x) {
  uint r = 0u;
  for (uint bit = 1u << 16; bit != 0u; bit >>= 1)
    if (r + bit <= 65537u && mm_triangular(r + bit) <= x) r += bit;
  return r;
}

/// The greatest r with r^2 <= x.  Domain: every x.
uint mm_square_root(uint x) {
  uint r = 0u;
  for (uint bit = 1u << 15; bit != 0u; bit >>= 1)
    if ((r + bit) * (r + bit) <= x) r += bit;
  return r;
}

/// Bit k of the result is the exclusive or of the bits of x from k on.  Domain: x < 2^16.
uint mm_xor_from_above(uint x) {
  x ^= x >> 1;
  x ^= x >> 2;
  x ^= x >> 4;
  return x ^ x >> 8;
}

/// Bit k goes to bit 2k.  Domain: x < 2^16.
uint mm_apart(uint x) {
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

/// Bit 2k goes to bit k; the odd bits do not count.
uint mm_together(uint x) {
  x &= 0x55555555u;
  x = (x | x >> 1) & 0x33333333u;
  x = (x | x >> 2) & 0x0f0f0f0fu;
  x = (x | x >> 4) & 0x00ff00ffu;
  return (x | x >> 8) & 0x0000ffffu;
}

#endif
