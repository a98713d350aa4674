#define MM_PRECISE
#include "shaders/figures/figure_4.glsl"
uint index(uint level, float u, float v) { return figure_4(level, u, v); }
