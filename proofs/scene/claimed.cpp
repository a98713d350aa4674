#include "proofs/scene/claimed.hpp"

#include <algorithm>

namespace mmverify::proofs::scene {

Claimed::Claimed(const Claim& claim, const mmverify::scene::Baked& baked, Level n)
    : claim_(claim), baked_(baked) {
  for (std::size_t k = 0; k < baked.triangles.size(); ++k) {
    const std::uint64_t count = baked.triangles[k].level == n ? claim.count(baked.triangles[k]) : 0;
    if (count == 0) continue;
    triangles_.push_back(k);
    before_.push_back(before_.back() + count);
  }
  blocks_ = std::make_unique<Blocks[]>(triangles_.size());
}

const std::vector<std::uint32_t>& Claimed::blocks_of(std::size_t position) const {
  Blocks& blocks = blocks_[position];
  std::call_once(blocks.counted, [&] {
    const auto& t = baked_.triangles[triangles_[position]];
    const auto count = static_cast<std::uint32_t>(impl::micromap::micro_triangles(t.level));
    std::uint32_t sum = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (k % block == 0) blocks.before.push_back(sum);
      sum += claim_.about(state_code(t, k)) ? 1 : 0;
    }
    blocks.before.push_back(sum);
  });
  return blocks.before;
}

MicroTriangle Claimed::at(std::uint64_t k) const {
  const auto position =
      static_cast<std::size_t>(std::upper_bound(before_.begin(), before_.end(), k) - before_.begin() - 1);
  const auto& t = baked_.triangles[triangles_[position]];
  auto left = static_cast<std::uint32_t>(k - before_[position]);
  if (claim_.count(t) == impl::micromap::micro_triangles(t.level)) return {triangles_[position], left};
  const std::vector<std::uint32_t>& blocks = blocks_of(position);
  const auto at = std::upper_bound(blocks.begin(), blocks.end(), left) - blocks.begin() - 1;
  left -= blocks[static_cast<std::size_t>(at)];
  for (auto index = static_cast<std::uint32_t>(at) * block;; ++index)
    if (claim_.about(state_code(t, index)) && left-- == 0) return {triangles_[position], index};
}

}  // namespace mmverify::proofs::scene
