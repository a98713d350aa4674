#include "display/render/bitmask.hpp"

#include <algorithm>
#include <vector>

namespace mmverify::render {
namespace {

using impl::micromap::State;

/// The least and the greatest sum of four codes, over the points of a texel's closed square.
struct SumRange {
  std::uint64_t least, most;
};
SumRange sums_over(const Surface& surface, std::int64_t x, std::int64_t y) {
  const std::uint64_t middle = surface.code(x, y);
  if (surface.fetches() == 1) return {4 * middle, 4 * middle};
  SumRange range{4 * middle, 4 * middle};
  const auto add = [&range](std::uint64_t sum) {
    range = {std::min(range.least, sum), std::max(range.most, sum)};
  };
  for (const int dx : {-1, 1})
    for (const int dy : {-1, 1}) {
      const std::uint64_t beside = surface.code(x + dx, y), above = surface.code(x, y + dy);
      add(2 * (middle + beside));
      add(2 * (middle + above));
      add(middle + beside + above + surface.code(x + dx, y + dy));
    }
  return range;
}

/// The mask of one surface.
class TexelMask {
 public:
  TexelMask(const Surface& surface, unsigned states)
      : surface_(&surface), bits_(states == 2 ? 1 : 2), bounds_(surface.bounds_of_sums(4)) {
    const std::uint64_t texels = std::uint64_t{surface.width()} * surface.height();
    packed_.resize(static_cast<std::size_t>((texels * bits_ + 7) / 8));
    std::uint64_t at = 0;
    for (std::uint32_t y = 0; y < surface.height(); ++y)
      for (std::uint32_t x = 0; x < surface.width(); ++x, at += bits_)
        packed_[static_cast<std::size_t>(at / 8)] |=
            static_cast<std::uint8_t>(static_cast<unsigned>(computed(x, y)) << at % 8);
  }

  State at(const impl::bake::BaseTriangle& uv, const Barycentrics& b) const {
    const auto [x, y] = surface_->texel(uv, b);
    const std::int64_t i = impl::bake::wrapped(surface_->sampling().u, x, surface_->width()),
                       j = impl::bake::wrapped(surface_->sampling().v, y, surface_->height());
    // A filter at the border mixes it with texels, so a square there has no bits.
    if (i < 0 || j < 0) return computed(x, y);
    const std::uint64_t bit = bits_ * (static_cast<std::uint64_t>(i) +
                                       std::uint64_t{surface_->width()} * static_cast<std::uint64_t>(j));
    return static_cast<State>(packed_[static_cast<std::size_t>(bit / 8)] >> bit % 8 & (bits_ == 1 ? 1 : 3));
  }
  std::uint64_t bytes() const { return packed_.size(); }

 private:
  State computed(std::int64_t x, std::int64_t y) const {
    if (bits_ == 1) return 4 * std::uint64_t{surface_->code(x, y)} >= bounds_.half ? State::O : State::T;
    const SumRange range = sums_over(*surface_, x, y);
    return range.least >= bounds_.opaque ? State::O : range.most < bounds_.transparent ? State::T : State::UT;
  }

  const Surface* surface_;
  std::uint64_t bits_;
  Surface::SumBounds bounds_;
  std::vector<std::uint8_t> packed_;
};

class Masks final : public Opacity {
 public:
  Masks(const World& world, unsigned states) : world_(world) {
    for (const Surface& surface : world.surfaces) masks_.emplace_back(surface, states);
  }
  std::optional<State> at(std::uint32_t geometry, std::uint32_t triangle,
                          const Barycentrics& b) const override {
    const Geometry& its = world_.geometries[geometry];
    if (!its.surface || !its.planned) return std::nullopt;
    return masks_[*its.surface].at(its.uv_of(triangle), b);
  }
  std::uint64_t bytes() const override {
    std::uint64_t sum = 0;
    for (const TexelMask& mask : masks_) sum += mask.bytes();
    return sum;
  }

 private:
  const World& world_;
  std::vector<TexelMask> masks_;
};

}  // namespace

std::unique_ptr<Opacity> bitmask_of(const World& world, unsigned states) {
  return std::make_unique<Masks>(world, states);
}

}  // namespace mmverify::render
