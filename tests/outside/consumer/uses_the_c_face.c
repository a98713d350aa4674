/* The library from C: an index, and what a wrong argument gets. */
#include <mmverify/mmverify.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  const float u = 0.25f, v = 0.5f;
  uint32_t index = 0, corners[6];
  if (!mmverify_index(3, &u, &v, &index, 1) || !mmverify_corners(3, &index, corners, 1)) return 1;
  printf("micro-triangle %u has a corner at (%u, %u)/8\n", index, corners[0], corners[1]);
  if (mmverify_index(17, &u, &v, &index, 1)) return 1;
  printf("level 17: %s\n", mmverify_error());
  if (mmverify_error()[0] == 0) return 1;
  /* Factors that nobody sets would make every texture transparent. */
  const unsigned char texel = 255;
  const mmverify_texture mip = {&texel, 1, 1};
  const mmverify_sampling zeroed = {.texel = MMVERIFY_TEXEL_UNORM8};
  if (mmverify_baker_new(&mip, 1, &zeroed) != NULL || strstr(mmverify_error(), "factor") == NULL) return 1;
  printf("factors of 0: %s\n", mmverify_error());
  return 0;
}
