#include "proofs/index/picture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "proofs/drawing/canvas.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::index {
namespace {

using spec::index::Corners;

using drawing::blue, drawing::Canvas, drawing::grey, drawing::ink, drawing::Pixel, drawing::vermilion;
constexpr double width = 760, drawing_size = 600, left = 80, top = 96;
constexpr double slope = std::numbers::sqrt3 / 2;
constexpr std::uint32_t widest = 8;  // the most squares along a side with legible numbers in them

/// Maps grid coordinates (in squares of the level, from the window's origin) to pixels: w left below, u right, v on
/// top.
struct View {
  double i0, j0, span;
  double x0, y0, size;
  Pixel operator()(double i, double j) const {
    const double a = (i - i0) / span, b = (j - j0) / span;
    return {x0 + size * (a + b / 2), y0 + size * slope * (1 - b)};
  }
};

Corners corners_of(std::uint32_t index, Level n, Order order) {
  return order == Order::curve ? spec::index::corners(index, n) : spec::index::w_minor_corners(index);
}

std::vector<Pixel> outline(const Corners& c, const View& view) {
  std::vector<Pixel> points;
  for (const auto& vertex : c) points.push_back(view(vertex.i, vertex.j));
  return points;
}

Pixel middle(const Corners& c, const View& view) {
  const double i = (double{0} + c[0].i + c[1].i + c[2].i) / 3, j = (double{0} + c[0].j + c[1].j + c[2].j) / 3;
  return view(i, j);
}

bool inside(const Corners& c, const View& view) {
  for (const auto& vertex : c)
    if (vertex.i < view.i0 || vertex.j < view.j0 || vertex.i + vertex.j > view.i0 + view.j0 + view.span)
      return false;
  return true;
}

/// A triangular window of the grid: all of it if it stays legible, or the part around the point.
View window(Level n, double pi, double pj) {
  const double N = side(n), span = std::min<double>(N, widest);
  double i0 = std::floor(pi - span / 3), j0 = std::floor(pj - span / 3);
  i0 = std::clamp(i0, 0.0, N - span);
  j0 = std::clamp(j0, 0.0, N - span);
  if (const double over = i0 + j0 + span - N; over > 0) {
    const double from_i = std::min(i0, std::ceil(over / 2));
    i0 -= from_i;
    j0 -= std::min(j0, over - from_i);
  }
  return {i0, j0, span, left, top, drawing_size};
}

void draw_grid(Canvas& canvas, const View& view) {
  for (double k = 0; k <= view.span; ++k) {
    const double i = view.i0 + k, j = view.j0 + k, end = view.i0 + view.j0 + view.span;
    canvas.polygon({view(i, view.j0), view(i, end - i)}, "none", grey, 1, 1, false);
    canvas.polygon({view(view.i0, j), view(end - j, j)}, "none", grey, 1, 1, false);
    canvas.polygon({view(view.i0 + k, view.j0), view(view.i0, view.j0 + k)}, "none", grey, 1, 1, false);
  }
  const double end = view.span;
  canvas.polygon({view(view.i0, view.j0), view(view.i0 + end, view.j0), view(view.i0, view.j0 + end)}, "none",
                 ink, 1.5);
}

/// Draws numbers in the micro-triangles of the window, and their order as a thin line.
void draw_indices(Canvas& canvas, const View& view, Level n, Order order, std::uint32_t expected,
                  std::uint32_t got) {
  std::vector<Pixel> stretch;
  std::uint32_t before = 0;
  const auto flush = [&] {
    if (stretch.size() > 1) canvas.polygon(stretch, "none", "#a9b8d6", 2, 1, false);
    stretch.clear();
  };
  std::vector<std::pair<std::uint32_t, Pixel>> numbers;
  for (std::uint32_t j = static_cast<std::uint32_t>(view.j0); j < view.j0 + view.span; ++j)
    for (std::uint32_t i = static_cast<std::uint32_t>(view.i0); i < view.i0 + view.span; ++i)
      for (const bool upside_down : {false, true}) {
        if (i + j + (upside_down ? 1 : 0) >= view.i0 + view.j0 + view.span) continue;
        const GridPoint p = representative(MicroTriangle{i, j, upside_down}, n);
        const std::uint32_t k =
            order == Order::curve ? spec::index::reference(p, n) : spec::index::w_minor(p, n);
        numbers.emplace_back(k, middle(corners_of(k, n, order), view));
      }
  std::sort(numbers.begin(), numbers.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [k, pixel] : numbers) {
    if (!stretch.empty() && k != before + 1) flush();
    stretch.push_back(pixel);
    before = k;
  }
  flush();
  const double size = view.span <= 2 ? 22 : view.span <= 4 ? 16 : n <= 4 ? 12 : 8;
  for (const auto& [k, pixel] : numbers)
    if (k != expected && k != got)
      canvas.text({pixel.x, pixel.y + size / 3}, fmt::format("{}", k), size, "#555555", "middle");
}

void draw_answer(Canvas& canvas, const View& view, const Corners& c, const char* fill, double opacity,
                 const char* stroke) {
  canvas.polygon(outline(c, view), fill, stroke, 3, opacity);
}

std::string coordinate_text(const Rational& q) {
  const std::string fraction =
      q.denominator() == 1 ? q.numerator().str() : q.numerator().str() + "/" + q.denominator().str();
  return fraction.size() <= 24 ? fraction : fmt::format("{:a}", nearest(q));
}

void label_corners(Canvas& canvas, const View& view, double N) {
  const Pixel w = view(view.i0, view.j0), u = view(view.i0 + view.span, view.j0),
              v = view(view.i0, view.j0 + view.span);
  if (view.span == N) {
    canvas.text({w.x - 8, w.y + 22}, "w = 1 (first vertex)", 13, ink, "middle");
    canvas.text({u.x, u.y + 22}, "u = 1 (second vertex)", 13, ink, "middle");
    canvas.text({v.x + 12, v.y + 2}, "v = 1 (third vertex)", 13, ink, "start");
  } else {
    canvas.text({w.x, w.y + 22}, fmt::format("u = {}/{}, v = {}/{}", view.i0, N, view.j0, N), 13, ink,
                "middle");
    canvas.text({u.x, u.y + 22}, fmt::format("u = {}/{}", view.i0 + view.span, N), 13, ink, "middle");
    canvas.text({v.x + 12, v.y + 2}, fmt::format("v = {}/{}", view.j0 + view.span, N), 13, ink, "start");
  }
}

/// Draws the legend.  `wrong_answer`: the words beside the hatched square, which a right answer has not.
void draw_legend(Canvas& canvas, const std::string& wrong_answer, Order order) {
  const double y = top + drawing_size * slope + 58;
  canvas.dot({34, y}, 6, "#000000", "#ffffff");
  canvas.text({48, y + 5}, "the point", 14);
  canvas.polygon({{140, y - 8}, {158, y - 8}, {158, y + 8}, {140, y + 8}}, blue, blue, 2, 0.25);
  canvas.text({166, y + 5}, wrong_answer.empty() ? "expected and returned" : "expected", 14);
  if (!wrong_answer.empty()) {
    canvas.polygon({{260, y - 8}, {278, y - 8}, {278, y + 8}, {260, y + 8}}, "url(#hatch)", vermilion, 2);
    canvas.text({286, y + 5}, wrong_answer, 14);
  }
  canvas.text({24, y + 38},
              order == Order::curve ? "Numbers are indices along the space-filling curve, the thin line."
                                    : "Numbers are indices in row order, rows counted from the w-corner.",
              13, "#555555");
}

}  // namespace

std::string picture(Level n, const RationalPoint& p, std::uint32_t expected, std::uint32_t got, Order order) {
  const double N = side(n), pi = nearest(p.u) * N, pj = nearest(p.v) * N;
  const View view = window(n, pi, pj);
  const bool in_range = got < triangle_count(n), right = expected == got;
  const std::string title =
      fmt::format("Level {}: the point (u, v) = ({}, {})", n, coordinate_text(p.u), coordinate_text(p.v));
  const std::string line =
      right ? fmt::format("belongs to micro-triangle {}, and that was the answer.", expected)
            : fmt::format("belongs to micro-triangle {}; the answer was {}{}.", expected, got,
                          in_range ? "" : fmt::format(", but the last one is {}", triangle_count(n) - 1));

  Canvas canvas(width, top + drawing_size * slope + 130, title);
  canvas.text({24, 34}, title, 19, ink, "start", true);
  canvas.text({24, 60}, line, 17);

  const Corners expected_corners = corners_of(expected, n, order);
  if (inside(expected_corners, view)) draw_answer(canvas, view, expected_corners, blue, 0.25, "none");
  const bool shown = !right && in_range && inside(corners_of(got, n, order), view);
  if (shown) draw_answer(canvas, view, corners_of(got, n, order), "url(#hatch)", 1, "none");
  draw_grid(canvas, view);
  draw_indices(canvas, view, n, order, expected, got);
  if (inside(expected_corners, view)) draw_answer(canvas, view, expected_corners, "none", 0, blue);
  if (shown) draw_answer(canvas, view, corners_of(got, n, order), "none", 0, vermilion);
  const double size = view.span <= 4 ? 20 : 14;
  const auto label = [&](std::uint32_t index, const char* colour) {
    Pixel at = middle(corners_of(index, n, order), view);
    canvas.text({at.x, at.y + size / 3}, fmt::format("{}", index), size, colour, "middle", true);
  };
  if (inside(expected_corners, view)) label(expected, blue);
  if (shown) label(got, vermilion);
  canvas.dot(view(pi, pj), 6, "#000000", "#ffffff");

  label_corners(canvas, view, N);
  if (view.span != N) {
    // A small picture of the whole triangle shows the window's place.
    const View small{0, 0, N, width - 190, top + 6, 160};
    canvas.polygon({small(0, 0), small(N, 0), small(0, N)}, "#f4f4f4", ink, 1);
    canvas.polygon(
        {small(view.i0, view.j0), small(view.i0 + view.span, view.j0), small(view.i0, view.j0 + view.span)},
        "none", ink, 1);
    canvas.dot(middle(expected_corners, small), 4, blue, "#ffffff");
    if (!right && in_range) canvas.dot(middle(corners_of(got, n, order), small), 4, vermilion, "#ffffff");
    canvas.text({small(0, 0).x + 80, small(0, 0).y + 16}, "the whole triangle", 12, ink, "middle");
  }

  draw_legend(canvas,
              right      ? ""
              : shown    ? "returned"
              : in_range ? "returned: outside this window"
                         : "returned: no such micro-triangle",
              order);

  return canvas.str();
}

}  // namespace mmverify::proofs::index
