#include "impl/bake/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "impl/bake/mip.hpp"
#include "impl/bake/touched.hpp"

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

/// Errors: std::invalid_argument outside the domain of TriangleBaker::bake_moving().
void check(const MovingTriangle& uv, std::uint32_t level, std::span<const std::uint8_t> map,
           std::span<const std::uint8_t> room) {
  if (level > max_bake_level) throw std::invalid_argument("bake: a level above 12");
  if (map.size() != ((std::size_t{1} << (2 * level)) + 3) / 4)
    throw std::invalid_argument("bake: room for another number of states");
  for (const TexturePoint& p : uv.middle) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v))
      throw std::invalid_argument("bake: a texture coordinate that is not finite");
    if (std::fabs(p.u) >= 0x1p20f || std::fabs(p.v) >= 0x1p20f)
      throw std::invalid_argument("bake: a texture coordinate of 2^20 or more");
  }
  for (const float range : {uv.across, uv.down})
    if (!(range >= 0 && range < 0x1p20f))
      throw std::invalid_argument("bake: a range of coordinates that is not from 0 and below 2^20");
  if (!room.empty() && room.size() != map.size())
    throw std::invalid_argument("bake: room for another map's size");
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
TriangleBaker::TriangleBaker(std::span<const BlockView> mips, const AlphaMode& mode,
                             const Sampling& sampling) {
  std::vector<Texels> texels;
  for (const BlockView& blocks : mips) {
    decoded_.push_back(alpha_of(blocks));
    texels.push_back(
        TexelView<std::uint16_t>{decoded_.back().data(), blocks.width, blocks.height, blocks.width});
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
  return bake_moving({uv}, level, map, room);
}

BakeCounts TriangleBaker::bake_moving(const MovingTriangle& uv, std::uint32_t level,
                                      std::span<std::uint8_t> map, std::span<std::uint8_t> room) const {
  check(uv, level, map, room);
  return bake_all(uv, level, map, room, nullptr);
}

BakeCounts TriangleBaker::rebake(const MovingTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map,
                                 std::span<const Box> changed, std::span<std::uint8_t> room) const {
  check(uv, level, map, room);
  if (changed.size() != mips_.size())
    throw std::invalid_argument("bake: changed boxes for another number of mip levels");
  for (std::size_t k = 0; k < mips_.size(); ++k)
    if (!mips_[k]->holds(changed[k]))
      throw std::invalid_argument("bake: changed texels beyond mip level " + std::to_string(k));
  const auto touched = [&](detail::UvBox places) {
    places.left -= uv.across, places.right += uv.across;
    places.top -= uv.down, places.bottom += uv.down;
    for (std::size_t k = 0; k < mips_.size(); ++k)
      if (mips_[k]->may_read(places, changed[k])) return true;
    return false;
  };
  const std::vector<detail::Node> nodes = detail::touched_nodes(uv.middle, level, touched);
  return bake_all(uv, level, map, room, &nodes);
}

BakeCounts TriangleBaker::bake_all(const MovingTriangle& uv, std::uint32_t level, std::span<std::uint8_t> map,
                                   std::span<std::uint8_t> room,
                                   const std::vector<detail::Node>* only) const {
  BakeCounts counts;
  std::vector<std::uint8_t> own(mips_.size() > 1 && room.empty() ? map.size() : 0);
  const std::span<std::uint8_t> other = room.empty() ? own : room;
  // merge() leaves equal states as they are: nodes that are not baked again.
  if (only != nullptr && mips_.size() > 1) std::copy(map.begin(), map.end(), other.begin());
  for (std::size_t k = 0; k < mips_.size(); ++k) {
    const std::span<std::uint8_t> baked = k == 0 ? map : other;
    const BakeCounts more = mips_[k]->bake(uv, level, baked.data(), only);
    counts.leaves += more.leaves;
    counts.exact += more.exact;
    if (k != 0) merge(map, other);
  }
  if (only == nullptr)
    counts.micro_triangles = std::uint64_t{1} << (2 * level);
  else
    for (const detail::Node& one : *only) counts.micro_triangles += std::uint64_t{1} << (2 * one.height);
  return counts;
}

}  // namespace mmverify::impl::bake
