#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq {
namespace {

/// The region along an axis.  1 - u is exact in double for u >= 2^-29, as u ends 52 places below 1 or sooner; a smaller
/// u is in the last region, however it rounds.
std::uint32_t along(Half half, float u, std::uint32_t side) noexcept {
  const double at = (half == Half::lower ? double{u} : 1.0 - double{u}) * side;
  // NaN takes neither branch: no conversion is out of range.
  return at >= side ? side - 1 : at > 0 ? static_cast<std::uint32_t>(at) : 0;
}

}  // namespace

State state_at(const Block2& block, Half half, float u, float v) noexcept {
  return region(block, along(half, u, 16), along(half, v, 16));
}
State state_at(const Block4& block, Half half, float u, float v) noexcept {
  return region(block, along(half, u, 32), along(half, v, 32));
}

}  // namespace mmverify::impl::vq
