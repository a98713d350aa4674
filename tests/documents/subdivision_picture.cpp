#include "tests/documents/subdivision_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "proofs/drawing/canvas.hpp"
#include "spec/subdivision/subdivision.hpp"

namespace mmverify::tests {
namespace {

using namespace proofs::drawing;
using namespace spec::subdivision;
using Cells = std::vector<Corners<double>>;
using spec::Level;

constexpr char light[] = "#a9b8d6", pale[] = "#dfe6f2";

/// The cells of a level in the unit shape, in order.
Cells cells_of(Scheme scheme, Level n) {
  Cells all;
  for (std::uint64_t k = 0; k < cells(scheme, n); ++k) all.push_back(cell<double>(scheme, n, k, 1).corners);
  return all;
}

At<double> mean(const Cut& c, const Corners<double>& corners) {
  At<double> sum{};
  for (std::size_t k = 0; k < c.corners; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += corners[k][axis] / c.corners;
  return sum;
}

/// A square of the page.
struct Panel {
  double x, y, size;
};

/// Equilateral triangles, the others as they are.
Pixel on_page(Scheme scheme, const Panel& panel, const At<double>& p) {
  const bool slanted = scheme == Scheme::triangle_4 || scheme == Scheme::triangle_9;
  const double up = slanted ? std::numbers::sqrt3 / 2 : 1;
  return {panel.x + panel.size * (p[0] + (slanted ? p[1] / 2 : 0)), panel.y + panel.size * (1 - up * p[1])};
}

void path(Canvas& canvas, Scheme scheme, const std::vector<Pixel>& middles) {
  for (std::size_t k = 0; k + 1 < middles.size(); ++k)
    canvas.polygon({middles[k], middles[k + 1]}, "none", breaks_after(scheme, k) ? vermilion : light,
                   breaks_after(scheme, k) ? 2 : 3, 1, false);
}

void numbers(Canvas& canvas, const std::vector<Pixel>& middles, double size) {
  for (std::size_t k = 0; k < middles.size(); ++k)
    canvas.text({middles[k].x, middles[k].y + size / 3}, fmt::format("{}", k), size, ink, "middle");
}

void title(Canvas& canvas, const Panel& panel, const std::string& words) {
  canvas.text({panel.x + panel.size / 2, panel.y + panel.size + 24}, words, 15, ink, "middle");
}

void in_plane(Canvas& canvas, Scheme scheme, Level n, const Panel& panel, const std::string& words) {
  const Cut c = cut(scheme);
  std::vector<Pixel> middles;
  for (const auto& corners : cells_of(scheme, n)) {
    std::vector<Pixel> points;
    for (std::size_t k = 0; k < c.corners; ++k) points.push_back(on_page(scheme, panel, corners[k]));
    canvas.polygon(points, "none", grey, 1);
    middles.push_back(on_page(scheme, panel, mean(c, corners)));
  }
  path(canvas, scheme, middles);
  numbers(canvas, middles, 9);
  title(canvas, panel, words);
}

/// A regular tetrahedron seen from the front and a little above; larger z is nearer.
struct Seen {
  Pixel at;
  double depth;
};
Seen seen(const Panel& panel, const At<double>& p) {
  // The corners 0 to 3: left, right, behind, top.
  constexpr double corners[4][3] = {{0, 0, 0.35}, {1, 0, 0.1}, {0.62, 0.28, -0.6}, {0.45, 0.95, -0.1}};
  const double weights[4] = {1 - p[0] - p[1] - p[2], p[0], p[1], p[2]};
  double x = 0, y = 0, z = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    x += weights[k] * corners[k][0];
    y += weights[k] * corners[k][1];
    z += weights[k] * corners[k][2];
  }
  // Room for the gaps.
  constexpr double scale = 0.62, left = 0.22, below = 0.15;
  return {{panel.x + panel.size * (left + scale * x), panel.y + panel.size * (1 - below - scale * y)}, z};
}

/// The eight children, moved away from the middle so that a gap lies between each two.
void exploded(Canvas& canvas, const Panel& panel, const std::string& words) {
  constexpr double apart = 0.7;
  const Cut c = cut(Scheme::tetrahedron);
  struct Face {
    std::vector<Pixel> points;
    double depth;
  };
  std::vector<Face> faces;
  std::vector<Pixel> middles;
  for (const auto& corners : cells_of(Scheme::tetrahedron, 1)) {
    const At<double> m = mean(c, corners);
    const auto moved = [&](At<double> p) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += apart * (m[axis] - 0.25);
      return seen(panel, p);
    };
    middles.push_back(moved(m).at);
    for (std::size_t off = 0; off < 4; ++off) {
      Face face{{}, 0};
      for (std::size_t k = 0; k < 4; ++k)
        if (k != off) {
          const Seen s = moved(corners[k]);
          face.points.push_back(s.at);
          face.depth += s.depth;
        }
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.depth < b.depth; });
  for (const Face& f : faces) canvas.polygon(f.points, pale, grey, 1, 0.35);
  path(canvas, Scheme::tetrahedron, middles);
  numbers(canvas, middles, 14);
  title(canvas, panel, words);
}

}  // namespace

std::string subdivision_curves() {
  Canvas canvas(1000, 710, "The curves of six schemes");
  constexpr double size = 280;
  const auto panel = [](double column, double row) { return Panel{30 + 325 * column, 20 + 345 * row, size}; };
  in_plane(canvas, Scheme::triangle_4, 3, panel(0, 0), "triangle-4, level 3");
  in_plane(canvas, Scheme::triangle_9, 2, panel(1, 0), "triangle-9, level 2");
  in_plane(canvas, Scheme::bisection, 6, panel(2, 0), "bisection, level 6");
  in_plane(canvas, Scheme::hilbert, 3, panel(0, 1), "hilbert, level 3");
  in_plane(canvas, Scheme::morton, 3, panel(1, 1), "morton, level 3");
  exploded(canvas, panel(2, 1), "tetrahedron, level 1, pulled apart");
  return canvas.str();
}

}  // namespace mmverify::tests
