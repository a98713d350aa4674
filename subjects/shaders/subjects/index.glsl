// The exact index and what goes with it, as a snippet:
//   mmverify prove index --subject subjects/shaders/subjects/index.glsl
#include "shaders/index.glsl"

uint index(uint level, float u, float v) { return mm_index_exact(level, u, v); }

void corners(uint level, uint index, out uvec2 a, out uvec2 b, out uvec2 c) { mm_corners(mm_curve_face(index), a, b, c); }

uint row_index(uint level, float u, float v) { return mm_row_index(level, u, v); }

void row_corners(uint level, uint index, out uvec2 a, out uvec2 b, out uvec2 c) { mm_corners(mm_row_face(index), a, b, c); }
