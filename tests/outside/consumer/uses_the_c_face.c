/* The library from C: an index, and what a wrong argument gets. */
#include <mmverify/mmverify.h>
#include <stdio.h>

int main(void) {
  const float u = 0.25f, v = 0.5f;
  uint32_t index = 0, corners[6];
  if (!mmverify_index(3, &u, &v, &index, 1) || !mmverify_corners(3, &index, corners, 1)) return 1;
  printf("micro-triangle %u has a corner at (%u, %u)/8\n", index, corners[0], corners[1]);
  if (mmverify_index(17, &u, &v, &index, 1)) return 1;
  printf("level 17: %s\n", mmverify_error());
  return mmverify_error()[0] == 0;
}
