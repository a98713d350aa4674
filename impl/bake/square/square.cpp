#include <vector>

#include "impl/bake/square/map.hpp"
#include "impl/bake/square/sampler.hpp"

namespace mmverify::impl::bake {
namespace {

using namespace detail;

/// The marks of side x side regions, rows from the top.
///
/// Region and cell (the square between four centres) are both axis-parallel rectangles, so each piece of a
/// region is one as well.  Along an axis-parallel line bilinear alpha is affine, and a rectangle's inside has
/// no extreme (spec/bake/bake.hpp): the extremes of a region are at the corners of its pieces.  Those are the
/// centres within, the points where its edges cross rows and columns of centres, and its own four corners;
/// each is looked at once and marked in every region that it touches.
class Regions {
 public:
  Regions(const Sampler& sampler, std::uint32_t side)
      : s_(sampler), side_(side), marks_(static_cast<std::size_t>(side_ * side_)) {
    for (std::int64_t j = 0; j < side_; ++j)
      for (std::int64_t y = s_.down.centres(j); y < s_.down.centres(j + 1); ++y) texel_row(j, y);
    for (std::int64_t j = 0; j <= side_; ++j) edge_row(j);
  }

  Marks at(std::int64_t i, std::int64_t j) const noexcept {
    return marks_[static_cast<std::size_t>(i + side_ * j)];
  }

 private:
  bool outside(std::int64_t i, std::int64_t j) const noexcept {
    return i < 0 || i >= side_ || j < 0 || j >= side_;
  }
  /// Whether nothing more can change the region's state.
  bool known_code(std::int64_t i, std::int64_t j) const noexcept { return outside(i, j) || at(i, j) == both; }
  void take(std::int64_t i, std::int64_t j, Marks marks) noexcept {
    if (outside(i, j)) return;
    Marks& all = marks_[static_cast<std::size_t>(i + side_ * j)];
    all = static_cast<Marks>(all | marks);
  }

  /// Takes a row of centres within the regions of row j.
  void texel_row(std::int64_t j, std::int64_t y) noexcept {
    const std::uint8_t* const row = s_.row(y);
    for (std::int64_t i = 0; i < side_; ++i)
      if (!known_code(i, j)) take(i, j, s_.span(row, s_.across.centres(i), s_.across.centres(i + 1)));
    for (std::int64_t i = 0; i <= side_; ++i) {
      if (known_code(i - 1, j) && known_code(i, j)) continue;
      const Marks m = s_.on_row(s_.across.at_edge(i), s_.across.d, y);
      take(i - 1, j, m);
      take(i, j, m);
    }
  }

  /// Takes edge j, between the regions of rows j - 1 and j.
  void edge_row(std::int64_t j) noexcept {
    const Between y = s_.down.at_edge(j);
    for (std::int64_t i = 0; i < side_; ++i)
      for (std::int64_t x = s_.across.centres(i), end = s_.across.centres(i + 1); x < end; ++x) {
        if (known_code(i, j - 1) && known_code(i, j)) break;
        const Marks m = s_.on_column(x, y, s_.down.d);
        take(i, j - 1, m);
        take(i, j, m);
      }
    for (std::int64_t i = 0; i <= side_; ++i) {
      const Marks m = s_.corner(i, j);
      take(i - 1, j - 1, m);
      take(i, j - 1, m);
      take(i - 1, j, m);
      take(i, j, m);
    }
  }

  const Sampler& s_;
  std::int64_t side_;
  std::vector<Marks> marks_;
};

}  // namespace

void square_map(const AlphaView& texture, const Box& box, Cutoff cutoff, std::uint32_t side,
                std::span<vq::State> states) {
  check(texture, box, cutoff, side, states.size(), std::size_t{side} * side);
  const Sampler sampler(texture, box, cutoff, side);
  const Regions regions(sampler, side);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      states[x + std::size_t{side} * y] = state_of(regions.at(x, side - 1 - y));  // rows from the bottom now
}

}  // namespace mmverify::impl::bake
