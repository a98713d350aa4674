#include "bench/vq/rivals/painter.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>

namespace mmverify::bench::rivals {
namespace {

/// The columns of a row relative to the brush's centre; empty if first > last.
struct Run {
  std::int8_t first = 1, last = 0;
};
constexpr std::int32_t reach = 31;  ///< the greatest distance of a centre and a region in one map
struct Outline {
  std::array<Run, 2 * reach + 1> runs{};  ///< by the row relative to the centre, from -reach on
  std::uint32_t rows = 0;                 ///< rows on either side of the centre that are not empty
};

/// The outlines of every shape and direction at every size up to 31.
struct Outlines {
  std::vector<Outline> all = std::vector<Outline>(4 * 8 * 32);

  static std::size_t place(BrushShape shape, std::uint32_t direction, std::uint32_t size) {
    return (static_cast<std::size_t>(shape) * 8 + direction) * 32 + size;
  }
  Outlines() {
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      const Brush brush{.shape = static_cast<BrushShape>(k / 256), .direction = k / 32 % 8, .size = k % 32};
      for (std::int32_t dy = -reach; dy <= reach; ++dy) {
        Run& run = all[k].runs[static_cast<std::size_t>(dy + reach)];
        for (std::int32_t dx = -reach; dx <= reach; ++dx) {
          if (!covers(brush, dx, dy)) continue;
          if (run.first > run.last) run.first = static_cast<std::int8_t>(dx);
          run.last = static_cast<std::int8_t>(dx);
          all[k].rows = static_cast<std::uint32_t>(std::abs(dy));
        }
      }
    }
  }
};

const Outline& outline_of(const Brush& brush) {
  static const Outlines outlines;
  return outlines.all[Outlines::place(brush.shape, brush.direction, brush.size)];
}

/// The brush's regions in row y.
std::uint32_t row_of(const Brush& brush, const Outline& outline, std::uint32_t side, std::uint32_t y) {
  const Run run = outline.runs[y + reach - brush.y];
  const std::int32_t x = static_cast<std::int32_t>(brush.x), first = std::max(x + run.first, 0),
                     last = std::min(x + run.last, static_cast<std::int32_t>(side) - 1);
  if (run.first > run.last || first > last) return 0;
  return static_cast<std::uint32_t>((std::uint64_t{2} << last) - (std::uint64_t{1} << first));
}

/// The rows of the map that a brush can cover: [first, end).
struct Span {
  std::uint32_t first, end;
};
Span rows_under(const Brush& brush, const Outline& outline, std::uint32_t side) {
  return {brush.y - std::min(brush.y, outline.rows), std::min(brush.y + outline.rows + 1, side)};
}

std::uint32_t count(std::uint32_t row) { return static_cast<std::uint32_t>(std::popcount(row)); }

std::uint32_t count(const Rows& rows) {
  std::uint32_t sum = 0;
  for (const std::uint32_t row : rows) sum += count(row);
  return sum;
}

/// The shapes that differ: a square looks the same after 90 degrees, a disc always.
std::vector<Brush> distinct_shapes() {
  std::vector<Brush> shapes;
  for (const auto& [shape, directions] : {std::pair{BrushShape::square, 4u},
                                          {BrushShape::disc, 1u},
                                          {BrushShape::half_bar, 8u},
                                          {BrushShape::quarter_bar, 8u}})
    for (std::uint32_t direction = 0; direction < directions; ++direction)
      shapes.push_back({.shape = shape, .direction = direction});
  return shapes;
}

}  // namespace

Painter::Painter(States map, std::uint32_t side) : side_(side) {
  for (std::uint32_t k = 0; k < map.size(); ++k) {
    states_[static_cast<std::size_t>(map[k])][k / side] |= 1u << (k % side);
    all_[k / side] |= 1u << (k % side);
  }
}

Rows Painter::rows_of(const Brush& brush) const {
  const Outline& outline = outline_of(brush);
  Rows rows{};
  for (std::uint32_t y = 0; y < side_; ++y) rows[y] = row_of(brush, outline, side_, y);
  return rows;
}

void Painter::cover(const Brush& brush, Rows& open) const {
  const Rows rows = rows_of(brush);
  for (std::uint32_t y = 0; y < side_; ++y) open[y] &= ~rows[y];
}

std::uint32_t Painter::exact_brush(State colour, const Rows& open, Brush& best) const {
  std::uint32_t most = 0;
  for (Brush brush : distinct_shapes()) {
    brush.colour = colour;
    for (brush.y = 0; brush.y < side_; ++brush.y)
      for (brush.x = 0; brush.x < side_; ++brush.x) {
        // A larger brush covers all of a smaller one, so a wrong brush stays wrong.
        bool right = true;
        for (brush.size = 0; right && brush.size < side_; ++brush.size) {
          const Outline& outline = outline_of(brush);
          const Span rows = rows_under(brush, outline, side_);
          std::uint32_t kept = 0;
          for (std::uint32_t y = rows.first; right && y < rows.end; ++y) {
            const std::uint32_t covered = row_of(brush, outline, side_, y) & open[y];
            right = (covered & ~of(colour)[y]) == 0;
            kept += count(covered);
          }
          if (!right || kept <= most) continue;
          most = kept;
          best = brush;
        }
      }
  }
  return most;
}

Brush Painter::checking_brush(const Rows& wanted, const Rows& open) const {
  std::int64_t most = std::numeric_limits<std::int64_t>::min();
  Brush brush{.colour = State::C}, best;
  for (const BrushShape shape : {BrushShape::square, BrushShape::disc}) {
    brush.shape = shape;
    for (brush.y = 0; brush.y < side_; brush.y += side_ / 16)
      for (brush.x = 0; brush.x < side_; brush.x += side_ / 16)
        // A brush of half the side in the middle covers the whole map.
        for (brush.size = 0; brush.size <= side_ / 2; ++brush.size) {
          const Outline& outline = outline_of(brush);
          const Span rows = rows_under(brush, outline, side_);
          std::int64_t gain = 0;
          for (std::uint32_t y = rows.first; y < rows.end; ++y) {
            const std::uint32_t covered = row_of(brush, outline, side_, y);
            gain += count(covered & wanted[y]);
            gain -= count(covered & open[y] & ~of(State::C)[y]);
          }
          if (gain <= most) continue;
          most = gain;
          best = brush;
        }
  }
  return best;
}

void Painter::add_exact(std::span<const State> colours, std::uint32_t most, Rows& open,
                        std::vector<Brush>& painting) const {
  while (painting.size() < most) {
    Brush best;
    std::uint32_t best_kept = 0;
    for (const State colour : colours) {
      Brush brush;
      const std::uint32_t kept = exact_brush(colour, open, brush);
      if (kept <= best_kept) continue;
      best_kept = kept;
      best = brush;
    }
    if (best_kept == 0) return;
    painting.push_back(best);
    cover(best, open);
  }
}

std::vector<Brush> Painter::greedy(std::uint32_t most) const {
  constexpr State both[] = {State::T, State::O};
  std::vector<Brush> best;
  Rows open = all_;
  add_exact(both, most, open, best);
  for (const State inner : both) {
    const State outer = inner == State::T ? State::O : State::T;
    std::vector<Brush> top;
    Rows below_top = all_;
    for (std::uint32_t inners = 0; inners <= most / 2; inners += std::max(most / 4, 1u)) {
      add_exact({&inner, 1}, inners, below_top, top);
      std::vector<Brush> painting = top;
      open = below_top;
      while (painting.size() + 1 < most) {
        Rows wanted = open;
        for (std::uint32_t y = 0; y < side_; ++y) wanted[y] &= ~of(outer)[y];
        if (count(wanted) == 0) break;
        const Brush brush = checking_brush(wanted, open);
        painting.push_back(brush);
        cover(brush, open);
      }
      add_exact({&outer, 1}, most, open, painting);
      if (kept(painting) > kept(best)) best = painting;
    }
  }
  return best;
}

std::int64_t Painter::kept_of(const std::vector<Rows>& covered, const std::vector<Brush>& painting) const {
  std::int64_t kept = 0;
  for (std::uint32_t y = 0; y < side_; ++y) {
    std::uint32_t open = all_[y];
    for (std::size_t k = 0; k < painting.size(); ++k) {
      const std::uint32_t here = covered[k][y] & open;
      open &= ~here;
      if (painting[k].colour == State::C) continue;
      if ((here & ~of(painting[k].colour)[y]) != 0) return -1;
      kept += count(here);
    }
  }
  return kept;
}

std::int64_t Painter::kept(const std::vector<Brush>& painting) const {
  std::vector<Rows> covered;
  for (const Brush& brush : painting) covered.push_back(rows_of(brush));
  return kept_of(covered, painting);
}

std::vector<Brush> Painter::mutated(const std::vector<Brush>& painting, std::uint32_t most,
                                    std::uint32_t tries, std::uint64_t seed) const {
  std::vector<Brush> now = painting;
  // The missing brushes lie on the ground, and change nothing until they are mutated.
  while (now.size() < most) now.push_back({.x = side_ / 2, .y = side_ / 2});
  std::vector<Rows> covered;
  for (const Brush& brush : now) covered.push_back(rows_of(brush));
  std::int64_t best = kept_of(covered, now);
  std::mt19937_64 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  const auto beside = [&](std::uint32_t value) {
    return (value + side_ + (below(2) == 0 ? 1 : -1u)) % side_;
  };
  const auto state = [&] { return static_cast<State>(below(3)); };
  for (std::uint32_t k = 0; k < tries; ++k) {
    const std::uint32_t which = below(now.size()), other = below(now.size());
    const Brush before = now[which];
    const Rows covered_before = covered[which];
    Brush& brush = now[which];
    const std::uint32_t change = below(8);
    if (change == 0) brush.x = beside(brush.x);
    if (change == 1) brush.y = beside(brush.y);
    if (change == 2) brush.size = beside(brush.size);
    if (change == 3) brush.direction = below(8);
    if (change == 4) brush.shape = static_cast<BrushShape>(below(4));
    if (change == 5) brush.colour = state();
    if (change == 6)
      brush = {
          static_cast<BrushShape>(below(4)), below(8), below(side_ / 4), below(side_), below(side_), state()};
    if (change < 7) {
      covered[which] = rows_of(brush);
    } else {
      std::swap(now[which], now[other]);
      std::swap(covered[which], covered[other]);
    }
    const std::int64_t kept = kept_of(covered, now);
    if (kept >= best) {
      best = kept;
    } else if (change < 7) {
      now[which] = before;
      covered[which] = covered_before;
    } else {
      std::swap(now[which], now[other]);
      std::swap(covered[which], covered[other]);
    }
  }
  return now;
}

}  // namespace mmverify::bench::rivals
