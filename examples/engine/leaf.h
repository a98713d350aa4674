/* A picture and a mesh for the examples: a disc of alpha in RGBA8, six triangles on it. */
#ifndef LEAF_H
#define LEAF_H

#include <stdint.h>

enum { LEAF_WIDTH = 64, LEAF_HEIGHT = 32, LEAF_PITCH = 4 * LEAF_WIDTH + 64, LEAF_TRIANGLES = 6 };

/* Alpha is 255 within half a height of the centre (32, 16), else 0; rows are padded, as in a staging buffer. */
static inline void leaf_draw(uint8_t* rgba) {
  for (int y = 0; y < LEAF_HEIGHT; ++y)
    for (int x = 0; x < LEAF_PITCH / 4; ++x) {
      const int dx = 2 * x + 1 - 64, dy = 2 * y + 1 - 32;
      uint8_t* const pixel = rgba + LEAF_PITCH * y + 4 * x;
      pixel[0] = 40, pixel[1] = 160, pixel[2] = 30;
      pixel[3] = x < LEAF_WIDTH && dx * dx + dy * dy < 32 * 32 ? 255 : 0;
    }
}

/* u and v of three vertices: a quad over the whole picture, its first half again, one triangle within the disc, one
 * outside it, and a small one on its edge. */
static const float leaf_uvs[LEAF_TRIANGLES][6] = {
    {0, 0, 1, 0, 0, 1},          {1, 0, 1, 1, 0, 1},
    {0, 0, 1, 0, 0, 1},          {0.46875f, 0.4375f, 0.53125f, 0.4375f, 0.46875f, 0.5625f},
    {0, 0, 0.125f, 0, 0, 0.25f}, {0.71875f, 0.4375f, 0.78125f, 0.4375f, 0.71875f, 0.5625f},
};

#endif
