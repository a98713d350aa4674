#include "impl/bake/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "impl/bake/mip.hpp"

namespace mmverify::impl::bake {
namespace {

constexpr std::uint32_t most_channels = 16, most_texels = 16384;

/// Merges another mip level's states into `first`: O if both are O, T if both are T; else unknown, leaning as the
/// first.  The low bit of the first's code tells its lean, for known states too: a closed micro-triangle that is O, or
/// T, is so at its centroid.
void merge(std::span<std::uint8_t> first, std::span<const std::uint8_t> other) noexcept {
  for (std::size_t k = 0; k < first.size(); ++k) {
    const unsigned a = first[k], b = other[k], differ = (a ^ b) << 1;
    first[k] = static_cast<std::uint8_t>((a & 0x55) | ((a | b | differ) & 0xaa));
  }
}

/// The channel of interleaved pixels, tightly packed.  Sizes that a baker refuses give no texels.
std::vector<std::uint8_t> channel_of(const PixelView& p) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument("bake: " + what); };
  if (p.channels == 0 || p.channels > most_channels)
    refuse("pixels of " + std::to_string(p.channels) + " channels, not 1 to " +
           std::to_string(most_channels));
  if (p.channel >= p.channels)
    refuse("channel " + std::to_string(p.channel) + " of pixels with " + std::to_string(p.channels));
  if (p.bytes == nullptr || p.width > most_texels || p.height > most_texels) return {};
  if (p.pitch < std::size_t{p.channels} * p.width)
    refuse("a pitch of " + std::to_string(p.pitch) + " bytes for rows of " +
           std::to_string(std::size_t{p.channels} * p.width));
  std::vector<std::uint8_t> texels(std::size_t{p.width} * p.height);
  for (std::uint32_t y = 0; y < p.height; ++y) {
    const std::uint8_t* from = p.bytes + p.pitch * y + p.channel;
    std::uint8_t* const row = texels.data() + std::size_t{p.width} * y;
    for (std::uint32_t x = 0; x < p.width; ++x) row[x] = from[std::size_t{p.channels} * x];
  }
  return texels;
}

}  // namespace

TriangleBaker::TriangleBaker(std::span<const Texels> mips, const AlphaMode& mode, const Sampling& sampling) {
  prepare(mips, mode, sampling);
}
TriangleBaker::TriangleBaker(std::span<const PixelView> mips, const AlphaMode& mode,
                             const Sampling& sampling) {
  std::vector<Texels> texels;
  for (const PixelView& p : mips) {
    channels_.push_back(channel_of(p));
    const std::uint8_t* const first = p.bytes == nullptr ? nullptr : channels_.back().data();
    texels.push_back(AlphaView{first, p.width, p.height, p.width});
  }
  prepare(texels, mode, sampling);
}

void TriangleBaker::prepare(std::span<const Texels> mips, const AlphaMode& mode, const Sampling& sampling) {
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

BakeCounts TriangleBaker::bake(const BaseTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map,
                               std::span<std::uint8_t> room) const {
  if (level > max_bake_level) throw std::invalid_argument("bake: a level above 12");
  const std::uint64_t count = std::uint64_t{1} << (2 * level);
  if (map.size() != (count + 3) / 4) throw std::invalid_argument("bake: room for another number of states");
  for (const TexturePoint& p : uv) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v))
      throw std::invalid_argument("bake: a texture coordinate that is not finite");
    if (std::fabs(p.u) >= 0x1p20f || std::fabs(p.v) >= 0x1p20f)
      throw std::invalid_argument("bake: a texture coordinate of 2^20 or more");
  }
  if (!room.empty() && room.size() != map.size())
    throw std::invalid_argument("bake: room for another map's size");
  BakeCounts counts = mips_.front()->bake(uv, level, map.data());
  std::vector<std::uint8_t> own(mips_.size() > 1 && room.empty() ? map.size() : 0);
  const std::span<std::uint8_t> other = room.empty() ? own : room;
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
