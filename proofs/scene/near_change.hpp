// A search for micro-triangles next to texels of both sides of the cutoff: a choice for samples, no proof.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/plan/plan.hpp"
#include "spec/bake/whole/texture.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::scene {

inline double stored_number(spec::bake::Binary32 texel) { return std::bit_cast<float>(texel.bits); }
inline double stored_number(std::uint32_t texel) { return texel; }

/// The stored number of alpha 1.
template <class Texel>
constexpr double stored_one = std::is_same_v<Texel, spec::bake::Binary32> ? 1
                              : std::is_same_v<Texel, std::uint8_t>       ? 255
                                                                          : 65535;

/// A bit for each texel and each property that tells a change of state, by binary64.
class NearChange {
 public:
  template <class Texel>
  NearChange(const spec::bake::TextureOf<Texel>& t, const mmverify::scene::Surface& surface)
      : width_(t.width), height_(t.height), wrap_x_(t.wrap_x), wrap_y_(t.wrap_y), travel_(surface.travel) {
    constexpr double most = stored_one<Texel>;
    const bool blend = surface.mode == mmverify::scene::AlphaMode::blend;
    const double limit =
        surface.mode == mmverify::scene::AlphaMode::mask
            ? surface.cutoff * most / (double{surface.base_color_alpha} * surface.vertex_alpha)
            : most / 2;
    for (spec::bake::whole::BitRows& rows : sets_) rows = {width_, height_};
    for (std::uint32_t j = 0; j < height_; ++j)
      for (std::uint32_t i = 0; i < width_; ++i) {
        const double alpha = stored_number(t.alpha[i + std::size_t{j} * width_]);
        sets_[alpha >= limit ? at_least : below].set(i, j);
        if (blend && alpha > 0 && alpha < most) sets_[partial].set(i, j);
      }
  }

  /// Whether texels less than one texel from a micro-triangle have both sides of the limit, or a partial alpha.
  bool at(const mmverify::scene::UvTriangle& uv, spec::Level n, std::uint32_t index) const {
    const auto [left, right] = extent(uv, n, index, 0, width_);
    const auto [top, bottom] = extent(uv, n, index, 1, height_);
    if (right - left > 64 || bottom - top > 64) return true;  // of so many texels hardly one side alone
    const auto whole = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
    const spec::bake::Interval columns{whole(left - 1), whole(right + 1)};
    std::array<bool, 3> found{};
    for (std::int64_t j = whole(top - 1); j <= whole(bottom + 1); ++j) {
      const auto row = spec::bake::whole::texel_index(wrap_y_, j, height_);
      spec::bake::whole::for_each_run(wrap_x_, columns, width_, [&](const spec::bake::whole::Run& run) {
        for (std::size_t k = 0; k < 3; ++k) found[k] = found[k] || sets_[k].any(*row, *run.first, *run.last);
      });
      if (found[partial] || (found[below] && found[at_least])) return true;
    }
    return false;
  }

 private:
  enum Property : std::uint8_t { below, at_least, partial };

  /// The least and greatest coordinate along an axis, in texels, with the surface's travel.
  std::pair<double, double> extent(const mmverify::scene::UvTriangle& uv, spec::Level n, std::uint32_t index,
                                   std::size_t axis, std::uint32_t size) const {
    const double step = 1.0 / spec::side(n);
    double low = 1e300, high = -1e300;
    for (const spec::index::Vertex& v : spec::index::corners(index, n)) {
      const double i = v.i * step, j = v.j * step;
      const double x =
          (uv[0][axis] + i * (double{uv[1][axis]} - uv[0][axis]) + j * (double{uv[2][axis]} - uv[0][axis])) *
          size;
      low = std::min(low, x), high = std::max(high, x);
    }
    const double travel = double{travel_[axis]} * size;
    return {low - travel, high + travel};
  }

  std::uint32_t width_, height_;
  spec::bake::Wrap wrap_x_, wrap_y_;
  std::array<float, 2> travel_;
  std::array<spec::bake::whole::BitRows, 3> sets_;
};

}  // namespace mmverify::proofs::scene
