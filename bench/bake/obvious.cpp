#include "bench/bake/obvious.hpp"

#include <algorithm>

namespace mmverify::bench {
namespace {

struct Spot {
  double x, y;
};
using Corners = std::array<Spot, 3>;

constexpr std::uint8_t transparent = 0, opaque = 1, unknown_state = 2;

Spot middle(const Spot& a, const Spot& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// The four children, in the order of the curve.
std::array<Corners, 4> children(const Corners& p) {
  const Spot p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
  return {{{p[0], p01, p02}, {p02, p12, p01}, {p01, p[1], p12}, {p12, p02, p[2]}}};
}

/// Calls state(corners) for each micro-triangle in the order of the curve.
template <class State>
void descend(const Corners& p, std::uint32_t height, std::uint8_t*& out, const State& state) {
  if (height == 0) {
    *out++ = state(p);
    return;
  }
  for (const Corners& child : children(p)) descend(child, height - 1, out, state);
}

template <class State>
void bake(const BakeTexture& t, const impl::bake::BaseTriangle& uv, std::uint32_t level,
          std::span<std::uint8_t> states, const State& state) {
  Corners p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = {double{uv[k].u} * t.view.width, double{uv[k].v} * t.view.height};
  std::uint8_t* out = states.data();
  descend(p, level, out, state);
}

std::int64_t floored(double x) {
  const auto i = static_cast<std::int64_t>(x);
  return i - (x < static_cast<double>(i) ? 1 : 0);
}

std::uint32_t repeated(std::int64_t i, std::uint32_t size) {
  if (i >= 0 && i < size) return static_cast<std::uint32_t>(i);
  const std::int64_t r = i % size;
  return static_cast<std::uint32_t>(r < 0 ? r + size : r);
}

/// alpha = a + b x + c y + d x y between four texels.
struct Cell {
  double a, b, c, d;

  Cell(const BakeTexture& t, std::int64_t i, std::int64_t j) {
    const std::uint8_t *row = t.view.texels + t.view.pitch * repeated(j, t.view.height),
                       *below = t.view.texels + t.view.pitch * repeated(j + 1, t.view.height);
    const std::uint32_t x = repeated(i, t.view.width), right = repeated(i + 1, t.view.width);
    constexpr double unit = 1.0 / 255;
    a = row[x] * unit;
    b = row[right] * unit - a;
    c = below[x] * unit - a;
    d = below[right] * unit - a - b - c;
  }
  double operator()(double x, double y) const { return a + b * x + (c + d * x) * y; }
};

bool opaque_at(const BakeTexture& t, const Spot& p) {
  const double x = p.x - 0.5, y = p.y - 0.5;
  const std::int64_t i = floored(x), j = floored(y);
  return Cell(t, i, j)(x - static_cast<double>(i), y - static_cast<double>(j)) >= t.cutoff;
}

Spot centre(const Corners& p) { return {(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3}; }

std::uint8_t lean(const BakeTexture& t, const Corners& p) {
  return static_cast<std::uint8_t>(unknown_state | (opaque_at(t, centre(p)) ? 1 : 0));
}

/// A part of a triangle: cut by four lines, it has at most seven corners.
struct Part {
  std::array<Spot, 8> at;
  std::size_t size = 0;
  void add(const Spot& p) { at[size++] = p; }
};

/// The part at or above `limit` along an axis, or at or below it.
Part clipped(const Part& part, double Spot::*axis, double limit, bool above) {
  Part kept;
  const auto height = [&](const Spot& p) { return above ? p.*axis - limit : limit - p.*axis; };
  for (std::size_t k = 0; k < part.size; ++k) {
    const Spot &p = part.at[k], &q = part.at[k + 1 == part.size ? 0 : k + 1];
    const double h = height(p), next = height(q);
    if (h >= 0) kept.add(p);
    if ((h > 0 && next < 0) || (h < 0 && next > 0)) {
      const double s = h / (h - next);
      kept.add({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
    }
  }
  return kept;
}

struct AlphaSides {
  bool opaque = false, transparent = false;
  void take(double alpha, double cutoff) { (alpha >= cutoff ? opaque : transparent) = true; }
  bool both() const { return opaque && transparent; }
};

/// Marks alpha at the corners of a part, and at its extremes on the part's edges.
void look(const Cell& cell, const Part& part, double x0, double y0, double cutoff, AlphaSides& seen) {
  for (std::size_t k = 0; k < part.size; ++k) {
    const Spot &p = part.at[k], &q = part.at[k + 1 == part.size ? 0 : k + 1];
    const double px = p.x - x0, py = p.y - y0, x = q.x - p.x, y = q.y - p.y;
    seen.take(cell(px, py), cutoff);
    const double bend = cell.d * x * y, slope = cell.b * x + cell.c * y + cell.d * (px * y + py * x);
    const double s = bend != 0 ? -slope / (2 * bend) : 0;
    if (s > 0 && s < 1) seen.take(cell(px + s * x, py + s * y), cutoff);
  }
}

AlphaSides rasterised(const BakeTexture& t, const Corners& corners) {
  Part all{};
  // Cells begin at the centres of texels.
  for (const Spot& p : corners) all.add({p.x - 0.5, p.y - 0.5});
  const auto ends = [](const Part& part, double Spot::*axis) {
    double low = part.at[0].*axis, high = low;
    for (std::size_t k = 1; k < part.size; ++k) {
      low = std::min(low, part.at[k].*axis);
      high = std::max(high, part.at[k].*axis);
    }
    return std::pair{floored(low), floored(high)};
  };
  AlphaSides seen;
  const auto [top, bottom] = ends(all, &Spot::y);
  for (std::int64_t j = top; j <= bottom && !seen.both(); ++j) {
    const auto y = static_cast<double>(j);
    const Part row = clipped(clipped(all, &Spot::y, y, true), &Spot::y, y + 1, false);
    if (row.size == 0) continue;
    const auto [left, right] = ends(row, &Spot::x);
    for (std::int64_t i = left; i <= right && !seen.both(); ++i) {
      const auto x = static_cast<double>(i);
      const Part part = clipped(clipped(row, &Spot::x, x, true), &Spot::x, x + 1, false);
      if (part.size != 0) look(Cell(t, i, j), part, x, y, t.cutoff, seen);
    }
  }
  return seen;
}

}  // namespace

void bake_centre(const BakeTexture& t, const impl::bake::BaseTriangle& uv, std::uint32_t level,
                 std::span<std::uint8_t> states) {
  bake(t, uv, level, states,
       [&](const Corners& p) { return opaque_at(t, centre(p)) ? opaque : transparent; });
}

void bake_corners(const BakeTexture& t, const impl::bake::BaseTriangle& uv, std::uint32_t level,
                  std::span<std::uint8_t> states) {
  bake(t, uv, level, states, [&](const Corners& p) {
    const bool first = opaque_at(t, p[0]);
    if (opaque_at(t, p[1]) != first || opaque_at(t, p[2]) != first) return lean(t, p);
    return first ? opaque : transparent;
  });
}

void bake_sixteen(const BakeTexture& t, const impl::bake::BaseTriangle& uv, std::uint32_t level,
                  std::span<std::uint8_t> states) {
  bake(t, uv, level, states, [&](const Corners& p) {
    int count = 0;
    for (const Corners& child : children(p))
      for (const Corners& part : children(child)) count += opaque_at(t, centre(part)) ? 1 : 0;
    return count == 16 ? opaque : count == 0 ? transparent : lean(t, p);
  });
}

void bake_rasterised(const BakeTexture& t, const impl::bake::BaseTriangle& uv, std::uint32_t level,
                     std::span<std::uint8_t> states) {
  bake(t, uv, level, states, [&](const Corners& p) {
    const AlphaSides seen = rasterised(t, p);
    return seen.both() ? lean(t, p) : seen.opaque ? opaque : transparent;
  });
}

}  // namespace mmverify::bench
