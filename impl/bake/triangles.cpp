#include "impl/bake/triangles.hpp"

#include <cmath>
#include <stdexcept>

#include "impl/bake/mip.hpp"

namespace mmverify::impl::bake {
namespace {

/// Merges another mip level's states into `first`: O if both are O, T if both are T; else unknown, leaning as the
/// first.  The low bit of the first's code tells its lean, for known states too: a closed micro-triangle that is O, or
/// T, is so at its centroid.
void merge(std::span<std::uint8_t> first, std::span<const std::uint8_t> other) noexcept {
  for (std::size_t k = 0; k < first.size(); ++k) {
    const unsigned a = first[k], b = other[k], differ = (a ^ b) << 1;
    first[k] = static_cast<std::uint8_t>((a & 0x55) | ((a | b | differ) & 0xaa));
  }
}

}  // namespace

TriangleBaker::TriangleBaker(std::span<const Texels> mips, const AlphaMode& mode, const Sampling& sampling) {
  if (mips.empty()) throw std::invalid_argument("bake: no mip level");
  if (!std::isfinite(sampling.margin)) throw std::invalid_argument("bake: a margin that is not finite");
  if (sampling.margin < 0) throw std::invalid_argument("bake: a margin below 0");
  if (sampling.margin >= 0x1p20f) throw std::invalid_argument("bake: a margin of 2^20 texels or more");
  for (const Texels& texels : mips) mips_.push_back(detail::mip_baker(texels, mode, sampling));
}
TriangleBaker::TriangleBaker(const AlphaView& texture, Cutoff cutoff, const Addressing& addressing)
    : TriangleBaker(
          std::array<Texels, 1>{texture}, cutoff,
          Sampling{addressing.u, addressing.v, Filter::bilinear, static_cast<float>(addressing.border)}) {}
TriangleBaker::~TriangleBaker() = default;
TriangleBaker::TriangleBaker(TriangleBaker&&) noexcept = default;
TriangleBaker& TriangleBaker::operator=(TriangleBaker&&) noexcept = default;

BakeCounts TriangleBaker::bake(const BaseTriangle& uv, std::uint32_t level,
                               std::span<std::uint8_t> map) const {
  if (level > max_bake_level) throw std::invalid_argument("bake: a level above 12");
  const std::uint64_t count = std::uint64_t{1} << (2 * level);
  if (map.size() != (count + 3) / 4) throw std::invalid_argument("bake: room for another number of states");
  for (const TexturePoint& p : uv) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v))
      throw std::invalid_argument("bake: a texture coordinate that is not finite");
    if (std::fabs(p.u) >= 0x1p20f || std::fabs(p.v) >= 0x1p20f)
      throw std::invalid_argument("bake: a texture coordinate of 2^20 or more");
  }
  BakeCounts counts = mips_.front()->bake(uv, level, map.data());
  std::vector<std::uint8_t> other(mips_.size() > 1 ? map.size() : 0);
  for (std::size_t k = 1; k < mips_.size(); ++k) {
    const BakeCounts more = mips_[k]->bake(uv, level, other.data());
    counts.leaves += more.leaves;
    counts.exact += more.exact;
    merge(map, other);
  }
  counts.micro_triangles = count;
  return counts;
}

}  // namespace mmverify::impl::bake
