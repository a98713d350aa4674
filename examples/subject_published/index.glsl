// GLSL: the index of the micro-triangle at barycentrics (u, v) of the second and third vertex.  `precise`: no
// contraction, so that each operation rounds by itself.
uint apart(uint x) {
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

uint micromapIndex(uint level, vec2 uv) {
  uint side = 1u << level, mask = side - 1u;
  precise vec2 p = clamp(uv, 0.0, 1.0) * float(side);
  uint iu = uint(p.x), iv = uint(p.y);
  precise float fraction = (p.x - float(iu)) + (p.y - float(iv));
  iu = min(iu, mask);
  iv = min(iv, mask);
  uint sum = iu + iv;
  if (sum >= side) iu -= sum - mask;
  uint iw = ~(iu + iv);
  if (fraction >= 1.0 && sum < mask) iw -= 1u;
  uint b0 = ~(iu ^ iw) & mask, t = (iu ^ iv) & b0;
  uint f = t ^ t >> 1;
  f ^= f >> 2;
  f ^= f >> 4;
  f ^= f >> 8;
  uint b1 = ((f ^ iu) & ~b0 & mask) | t;
  return apart(b0) | apart(b1) << 1;
}
