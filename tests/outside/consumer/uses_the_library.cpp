// The library from outside: an index and its way back.
#include <cstdio>
#include <mmverify/mmverify.hpp>

int main() {
  const std::uint32_t k = mmverify::impl::index::from_barycentrics(0.25f, 0.5f, 3);
  const auto corners = mmverify::impl::index::corners(k, 3);
  std::printf("micro-triangle %u has a corner at (%u, %u)/8\n", k, corners[0].i, corners[0].j);
  // The point is a micro-vertex of level 3, of that micro-triangle.
  for (const auto& c : corners)
    if (c.i == 2 && c.j == 4) return 0;
  return 1;
}
