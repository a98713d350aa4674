#include "proofs/index/floats/published.hpp"

#include <algorithm>

namespace mmverify::proofs::index {
namespace {

/// The lowest sixteen bits, each followed by a zero.
std::uint32_t with_gaps(std::uint32_t x) {
  std::uint32_t spread = 0;
  for (unsigned bit = 0; bit < 16; ++bit) spread |= (x >> bit & 1) << 2 * bit;
  return spread;
}

}  // namespace

std::uint32_t published(Level n, float u, float v) {
  const std::uint32_t side = std::uint32_t{1} << n;
  const float scaled_u = std::clamp(u, 0.0f, 1.0f) * static_cast<float>(side),
              scaled_v = std::clamp(v, 0.0f, 1.0f) * static_cast<float>(side);
  std::uint32_t iu = static_cast<std::uint32_t>(scaled_u), iv = static_cast<std::uint32_t>(scaled_v);
  const float uf = scaled_u - static_cast<float>(iu), vf = scaled_v - static_cast<float>(iv), sum = uf + vf;
  iu = std::min(iu, side - 1);
  iv = std::min(iv, side - 1);
  const std::uint32_t together = iu + iv;
  if (together >= side) iu -= together - side + 1;
  std::uint32_t iw = ~(iu + iv);
  if (sum >= 1.0f && together < side - 1) --iw;
  const std::uint32_t b0 = ~(iu ^ iw) & (side - 1), t = (iu ^ iv) & b0;
  std::uint32_t f = t;
  for (unsigned shift = 1; shift < 16; shift *= 2) f ^= f >> shift;
  const std::uint32_t b1 = ((f ^ iu) & ~b0 & (side - 1)) | t;
  return with_gaps(b0) | with_gaps(b1) << 1;
}

}  // namespace mmverify::proofs::index
