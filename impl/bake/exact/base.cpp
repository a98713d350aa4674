#include "impl/bake/exact/base.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "impl/bake/exact/seen.hpp"

namespace mmverify::impl::bake::detail {
namespace {

/// Moves x so that the cell of the least coordinate, `dilation` below it, becomes cell 0, and returns that cell's number.
/// Domain: coordinates below 2^36 texels in size.
template <class Int>
std::int64_t moved_to_origin(std::array<Int, 3>& x, const Int& dilation, int fraction_bits) {
  const Int least = std::min({x[0], x[1], x[2]}) - dilation, unit = Int(1) << fraction_bits;
  std::int64_t low = -(std::int64_t{1} << 36), high = -low;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (Int(middle) * unit <= least ? low : high) = middle;
  }
  for (Int& k : x) k = k - Int(low) * unit;
  return low;
}

}  // namespace

ExactBase::ExactBase(const TextureProperties& sides, const BaseTriangle& uv, std::uint32_t width,
                     std::uint32_t height, index::Level level, Filter filter, const Dilation& dilation)
    : sides_(sides),
      width_(width),
      height_(height),
      level_(static_cast<int>(level)),
      filter_(filter),
      dilate_x_(binary(dilation.x)),
      dilate_y_(binary(dilation.y)) {
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    u_[k] = binary(uv[k].u);
    v_[k] = binary(uv[k].v);
    below_point_ = std::max({below_point_, -u_[k].e, -v_[k].e});
    const TexturePoint &p = uv[k], &q = uv[(k + 1) % 3];
    extent = std::max({extent, std::fabs(double{p.u} - double{q.u}) * width,
                       std::fabs(double{p.v} - double{q.v}) * height});
  }
  below_point_ = std::max({below_point_, -dilate_x_.e - level_, -dilate_y_.e - level_});
  // 3 more cells: one for the first, one for the last, one for rounding.
  cells_ = static_cast<std::int64_t>(std::ldexp(extent, -level_) + 2 * std::max(dilation.x, dilation.y)) + 3;
  const int fraction = below_point_ + level_;
  const int position = fraction + bits(cells_ + 1);
  const int height_of = std::max(height_bits(sides.limits.opaque, sides.finest, sides.most),
                                 height_bits(sides.limits.lean, sides.finest, sides.most));
  // The bits of positions: 20 of u and v, 15 of width and height, 3 for sums and a sign, one for the dilation.
  take_closings();
  bits_ = std::max(4 * position + 2 * height_of + 12, fraction + 20 + 15 + 4);
}

/// Coordinates (texels (U0 N + i (U1 - U0) + j (U2 - U0))) / N, less 1/2 for cells, in units of 2^-(below_point +
/// level).
template <class Int>
std::array<Int, 3> ExactBase::along(const Axis& axis, std::uint32_t texels,
                                    const index::Corners& corners) const {
  const auto whole = [this](const Binary& b) {
    return b.m == 0 ? Int(0) : Int(b.m) * (Int(1) << (b.e + below_point_));
  };
  const Int first = whole(axis[0]), across = whole(axis[1]) - first, down = whole(axis[2]) - first;
  const Int half = filter_ == Filter::nearest ? Int(0) : Int(1) << (below_point_ + level_ - 1);
  std::array<Int, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
    x[k] =
        Int(texels) * (first * (Int(1) << level_) + Int(corners[k].i) * across + Int(corners[k].j) * down) -
        half;
  return x;
}

/// Finds the closings of lines along the axes, and of the base triangle's edges.  An edge is a/g, b/g times a vector of
/// whole repeats, where a and b are its sides in units of 2^-32 and g divides both.  So after that many repeats, or
/// twice as many if a mirror turns, alpha along the edge is as at its beginning.  Finer fractions get no closing.
void ExactBase::take_closings() {
  const Extent across = sides_.across(), down = sides_.down();
  if (!across.ends()) closings_.push_back({across.period, 0});
  if (!down.ends()) closings_.push_back({0, down.period});
  if (across.ends() || down.ends()) return;
  constexpr int finest = -32;
  std::array<std::int64_t, 3> x, y;
  for (std::size_t k = 0; k < 3; ++k) {
    if (u_[k].e < finest || v_[k].e < finest) return;
    x[k] = u_[k].m * (std::int64_t{1} << (u_[k].e - finest));  // below 2^20 2^32
    y[k] = v_[k].m * (std::int64_t{1} << (v_[k].e - finest));
  }
  const std::int64_t turn_x = across.period / width_, turn_y = down.period / height_;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t dx = x[(k + 1) % 3] - x[k], dy = y[(k + 1) % 3] - y[k];
    if (dx == 0 || dy == 0) continue;
    const std::int64_t g = std::gcd(dx, dy);
    std::int64_t repeats_x = dx / g, repeats_y = dy / g;
    if (std::abs(repeats_x) >> 21 != 0 || std::abs(repeats_y) >> 21 != 0) continue;  // longer than any edge
    if (repeats_x % turn_x != 0 || repeats_y % turn_y != 0) repeats_x *= 2, repeats_y *= 2;
    closings_.push_back({repeats_x * width_, repeats_y * height_});
  }
}

template <class Int>
ExactBase::Answer ExactBase::in(const index::Corners& corners, Marks known) const {
  std::array<Int, 3> x = along<Int>(u_, width_, corners), y = along<Int>(v_, height_, corners);
  const int fraction = below_point_ + level_;
  const auto whole = [fraction](const Binary& b) { return b.m == 0 ? Int(0) : Int(b.m) << (b.e + fraction); };
  const Int across = whole(dilate_x_), down = whole(dilate_y_), unit = Int(1) << fraction;
  const std::int64_t column = moved_to_origin(x, across, fraction), row = moved_to_origin(y, down, fraction);
  const Outline<Int> outline(x, y, across, down);
  const auto exact = [&](const Question<Int>& question) {
    return Exact<Int>(sides_, question, column, row, cells_, fraction, outline, closings_);
  };
  const auto marks = [&](const Question<Int>& question) {
    Exact<Int> asked = exact(question);
    return filter_ == Filter::nearest ? asked.nearest() : asked.bilinear();
  };
  const Height<Int> opaque_height(sides_.limits.opaque, sides_.finest);
  Answer answer{};
  if (known == both) {
    answer.marks = both;
  } else if (!sides_.limits.blend) {
    answer.marks = marks({opaque_height});
  } else {
    const Marks not_opaque = marks({opaque_height, below, [](Marks m) { return m; }});
    // With limits.zero alpha is 0 everywhere; else -r < 0 means that alpha is not transparent.
    const Marks visible =
        sides_.limits.zero ? Marks{0} : marks({Height<Int>(sides_.finest), below, [](Marks m) {
                                                 return static_cast<Marks>((m & opaque) != 0 ? below : 0);
                                               }});
    answer.marks = static_cast<Marks>((not_opaque & below) | ((visible & below) != 0 ? opaque : 0));
  }
  if (answer.marks != both) return answer;
  const Question<Int> lean{Height<Int>(sides_.limits.lean, sides_.finest)};
  const Exact<Int> asked = exact(lean);
  const Int sum_x = x[0] + x[1] + x[2], sum_y = y[0] + y[1] + y[2], three = unit + unit + unit;
  answer.leans_to_opaque = (filter_ == Filter::nearest ? asked.nearest_at(sum_x, sum_y, three)
                                                       : asked.sign_at(sum_x, sum_y, three)) == opaque;
  return answer;
}

ExactBase::Answer ExactBase::operator()(std::uint32_t index, Marks known) const {
  const index::Corners corners = index::corners(index, static_cast<index::Level>(level_));
  if (bits_ <= 128) return in<Int128>(corners, known);
  if (bits_ <= 384) return in<Wide<6>>(corners, known);
  if (bits_ <= 1024) return in<Wide<16>>(corners, known);
  // The widest case: 150 + 12 bits below the point, 36 above it, 447 + 416 + 4 for heights.
  static_assert(4 * (150 + 12 + 36) + 2 * (447 + 416 + 4) + 12 <= 40 * 64);
  return in<Wide<40>>(corners, known);
}

}  // namespace mmverify::impl::bake::detail
