// Figure 4 of Color and Attribute Micromaps as printed, in binary32: the micro-triangle in row order.
#ifndef MM_PRECISE
#define MM_PRECISE precise
#endif
uint figure_4(uint level, float u, float v) {
  uint last = (1u << level) - 1u;
  float N = float(1u << level);
  MM_PRECISE float w = 1.0 - (u + v);
  MM_PRECISE float r = (1.0 - w) * N, c = v * N, d = (1.0 - u) * N;
  uint row = min(last, uint(r)), column = min(row, uint(c)), diagonal = min(last, uint(d));
  return row * row + column + (diagonal - (last - row));
}
