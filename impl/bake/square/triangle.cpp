#include "impl/bake/square/map.hpp"
#include "impl/bake/square/sampler.hpp"

namespace mmverify::impl::bake {
namespace {

using namespace detail;

// __int128 is not ISO C++, but both compilers of this project have it.
__extension__ typedef __int128 Wide;

/// The marks of the halves of region (i, j), j from the top.  As in a square map, but a piece may have a slanted edge,
/// on the diagonal.  Along that, alpha is a quadratic, so its turning point counts beside the corners of the pieces.
/// points count.
class Halves {
 public:
  Halves(const Sampler& sampler, std::int64_t i, std::int64_t j)
      : s_(sampler), i_(i), j_(j), width_(s_.across.step / 2), height_(s_.down.step / 2) {
    centres_and_rows();
    columns();
    on_diagonal(s_.corner(i, j));
    on_diagonal(s_.corner(i + 1, j + 1));
    lower = static_cast<Marks>(lower | s_.corner(i, j + 1));
    upper = static_cast<Marks>(upper | s_.corner(i + 1, j));
    turning_points();
  }

  Marks lower = 0, upper = 0;

 private:
  void on_diagonal(Marks m) noexcept {
    lower = static_cast<Marks>(lower | m);
    upper = static_cast<Marks>(upper | m);
  }

  /// The diagonal's x at a position down the texture, in units of 1/(D height) texel; and its y at a position across.
  Between across_at(std::int64_t y) const noexcept {
    return between(s_.across.edge(i_) * height_ + (y - s_.down.edge(j_)) * width_, s_.across.d * height_);
  }
  Between down_at(std::int64_t x) const noexcept {
    return between(s_.down.edge(j_) * width_ + (x - s_.across.edge(i_)) * height_, s_.down.d * width_);
  }

  /// Takes the rows of centres: the edges and the diagonal where they cross, and the centres on either side of it.
  void centres_and_rows() noexcept {
    const std::int64_t d = s_.across.d, begin = s_.across.centres(i_), end = s_.across.centres(i_ + 1);
    for (std::int64_t y = s_.down.centres(j_); y < s_.down.centres(j_ + 1); ++y) {
      const std::uint8_t* const row = s_.row(y);
      const Between split = across_at(d * y);
      on_diagonal(s_.on_row(split, d * height_, y));
      if (lower != both)
        lower = static_cast<Marks>(lower | s_.on_row(s_.across.at_edge(i_), d, y) |
                                   s_.span(row, begin, std::min(end, split.k + 1)));
      if (upper != both)
        upper = static_cast<Marks>(upper | s_.on_row(s_.across.at_edge(i_ + 1), d, y) |
                                   s_.span(row, std::max(begin, split.k + 1), end));
    }
  }

  /// Takes the columns of centres: the edges and the diagonal where they cross.
  void columns() noexcept {
    const std::int64_t d = s_.down.d;
    const Between top = s_.down.at_edge(j_), bottom = s_.down.at_edge(j_ + 1);
    for (std::int64_t x = s_.across.centres(i_); x < s_.across.centres(i_ + 1); ++x) {
      on_diagonal(s_.on_column(x, down_at(d * x), d * width_));
      lower = static_cast<Marks>(lower | s_.on_column(x, bottom, d));
      upper = static_cast<Marks>(upper | s_.on_column(x, top, d));
    }
  }

  /// Takes the turning point in every cell that the diagonal visits.
  void turning_points() noexcept {
    const std::int64_t d = s_.down.d, begin = s_.down.edge(j_), end = s_.down.edge(j_ + 1);
    for (std::int64_t y = s_.down.at_edge(j_).k; y <= s_.down.at_edge(j_ + 1).k; ++y) {
      const std::int64_t last = across_at(std::min(end, d * (y + 1))).k;
      for (std::int64_t x = across_at(std::max(begin, d * y)).k; x <= last; ++x) turning_point(x, y);
    }
  }

  /// Takes the turning point in the cell between the centres (x, y) and (x+1, y+1), X, Y from its least corner in 1/D:
  ///   255 D^2 alpha = a D^2 + b D X + c D Y + e X Y,   (X, Y) = (X0, Y0) + t (2 width, 2 height)
  ///                 = m + l t + k t^2,   whose turning point is at t = -l/2k and has the value m - l^2/4k.
  /// |X0|, |Y0| < 2^16, as the cell meets the region, so k < 2^39, l < 2^42, m < 2^42: 4km, l^2 < 2^84, times a
  /// denominator < 2^116.
  void turning_point(std::int64_t x, std::int64_t y) noexcept {
    const std::int64_t a = s_.byte(x, y), right = s_.byte(x + 1, y), down = s_.byte(x, y + 1),
                       far = s_.byte(x + 1, y + 1);
    // Bilinear alpha is a mean of the four: if they agree, so does it, and the corners have marked it.
    const int opaque_ones = (a >= s_.least_opaque) + (right >= s_.least_opaque) + (down >= s_.least_opaque) +
                            (far >= s_.least_opaque);
    if (opaque_ones == 0 || opaque_ones == 4) return;
    const std::int64_t b = right - a, c = down - a, e = a - right - down + far;
    const std::int64_t d = s_.across.d, x0 = s_.across.edge(i_) - d * x, y0 = s_.down.edge(j_) - d * y,
                       dx = s_.across.step, dy = s_.down.step;
    std::int64_t k = e * dx * dy;
    if (k == 0) return;  // affine: its ends are corners of the piece
    std::int64_t l = d * (b * dx + c * dy) + e * (x0 * dy + y0 * dx),
                 m = d * (a * d + b * x0 + c * y0) + e * x0 * y0;
    const bool least = k > 0;
    if (!least) k = -k, l = -l, m = -m;
    // The turning point must lie in the closed cell and on the diagonal; all is times 2k.
    const Wide two_k = Wide(2) * k, at_x = two_k * x0 - Wide(l) * dx, at_y = two_k * y0 - Wide(l) * dy;
    if (l > 0 || -l > two_k || at_x < 0 || at_x > two_k * d || at_y < 0 || at_y > two_k * d) return;
    Wide value = 2 * two_k * m - Wide(l) * l;
    if (!least) value = -value;
    const Wide limit = 2 * two_k * (255 * d * d) * s_.cutoff.numerator;
    on_diagonal(value * s_.cutoff.denominator >= limit ? opaque : below);
  }

  const Sampler& s_;
  std::int64_t i_, j_, width_, height_;
};

}  // namespace

void triangle_map(const AlphaView& texture, const Box& box, Cutoff cutoff, std::uint32_t side,
                  std::span<vq::State> states) {
  check(texture, box, cutoff, side, states.size(), 2 * std::size_t{side} * side);
  const Sampler sampler(texture, box, cutoff, side);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const Halves halves(sampler, x, side - 1 - y);  // rows from the bottom here
      const std::size_t at = 2 * (x + std::size_t{side} * y);
      states[at] = state_of(halves.lower);
      states[at + 1] = state_of(halves.upper);
    }
}

}  // namespace mmverify::impl::bake
