#include "tests/documents/attribute_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "proofs/drawing/canvas.hpp"
#include "spec/attribute/decimation.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::tests {
namespace {

using namespace proofs::drawing;
using namespace spec::attribute;
using spec::Level;

/// A base triangle on the page: w left below, u right, v on top.
struct View {
  double x, y, size;
  Level level;

  Pixel operator()(double i, double j) const {
    const double N = spec::side(level);
    return {x + size * (i + j / 2) / N, y + size * std::numbers::sqrt3 / 2 * (1 - j / N)};
  }
  Pixel operator()(const Vertex& v) const { return (*this)(v.i, v.j); }
  std::vector<Pixel> operator()(const Corners& corners) const {
    std::vector<Pixel> points;
    for (const Vertex& c : corners) points.push_back((*this)(c));
    return points;
  }
};

Pixel middle(const std::vector<Pixel>& points) {
  Pixel sum{0, 0};
  for (const Pixel& p : points) {
    sum.x += p.x / static_cast<double>(points.size());
    sum.y += p.y / static_cast<double>(points.size());
  }
  return sum;
}

template <class Visit>
void each_vertex(Level n, Visit visit) {
  for (std::uint32_t i = 0; i <= spec::side(n); ++i)
    for (std::uint32_t j = 0; i + j <= spec::side(n); ++j) visit(Vertex{i, j});
}

template <class Visit>
void each_face(Level n, Visit visit) {
  for (std::uint32_t iu = 0; iu < spec::side(n); ++iu)
    for (std::uint32_t iv = 0; iu + iv < spec::side(n); ++iv) {
      visit(MicroTriangle{iu, iv, false});
      if (iu + iv + 1 < spec::side(n)) visit(MicroTriangle{iu, iv, true});
    }
}

void name_corners(Canvas& canvas, const View& view) {
  const double N = spec::side(view.level);
  canvas.text({view(0, 0).x - 4, view(0, 0).y + 30}, "w", 14, ink, "middle", true);
  canvas.text({view(N, 0).x + 4, view(N, 0).y + 30}, "u", 14, ink, "middle", true);
  canvas.text({view(0, N).x, view(0, N).y - 18}, "v", 14, ink, "middle", true);
}

void draw_order(Canvas& canvas, const View& view, VertexOrder vertices, FaceOrder faces) {
  const Level n = view.level;
  std::vector<Pixel> walk(vertex_count(n));
  each_vertex(n, [&](const Vertex& v) { walk[vertex_index(vertices, v, n)] = view(v); });
  each_face(n, [&](const MicroTriangle& t) { canvas.polygon(view(corners_of(t)), "none", grey, 1); });
  canvas.polygon(walk, "none", "#a9cbe6", 3, 1, false);
  const bool wide = n <= 2;
  each_face(n, [&](const MicroTriangle& t) {
    const Pixel at = middle(view(corners_of(t)));
    canvas.text({at.x, at.y + (wide ? 4 : 3.2)}, fmt::format("{}", face_index(faces, t, n)), wide ? 12 : 9.5,
                vermilion, "middle");
  });
  for (std::size_t k = 0; k < walk.size(); ++k) {
    canvas.dot(walk[k], wide ? 9.5 : 7.5, "#ffffff", blue);
    canvas.text({walk[k].x, walk[k].y + (wide ? 4 : 3.2)}, fmt::format("{}", k), wide ? 11 : 9, blue,
                "middle", true);
  }
  name_corners(canvas, view);
}

void draw_decimated(Canvas& canvas, const View& view, EdgeFlags flags) {
  const Level n = view.level;
  each_face(n, [&](const MicroTriangle& t) {
    const Corners corners = snapped(t, n, flags);
    if (doubled_area(corners) == 0) return;
    const Corners before = corners_of(t);
    const bool moved = !std::equal(corners.begin(), corners.end(), before.begin());
    canvas.polygon(view(corners), moved ? "#f3d9c4" : "#ffffff", ink, 1);
  });
  for (std::uint32_t edge = 0; edge < 3; ++edge)
    if ((flags >> edge & 1) != 0)
      canvas.polygon({view(on_edge(edge, 0, n)), view(on_edge(edge, spec::side(n), n))}, "none", blue, 4, 0.6,
                     false);
  each_vertex(n, [&](const Vertex& v) {
    const Vertex to = snapped(v, n, flags);
    if (to == v) return;
    // From beside the vertex to beside the one that it is read from, so that both stay in sight.
    const Pixel a = view(v), b = view(to);
    canvas.polygon({{a.x + (b.x - a.x) / 8, a.y + (b.y - a.y) / 8},
                    {a.x + (b.x - a.x) * 5 / 8, a.y + (b.y - a.y) * 5 / 8}},
                   "none", vermilion, 3, 1, false);
  });
  each_vertex(n, [&](const Vertex& v) {
    canvas.dot(view(v), 3.5, snapped(v, n, flags) == v ? ink : "#ffffff",
               snapped(v, n, flags) == v ? ink : vermilion);
  });
}

}  // namespace

std::string attribute_orders() {
  Canvas canvas(1000, 760, "Three orders of micro-vertices and of micro-triangles, levels 2 and 3");
  struct Pair {
    VertexOrder vertices;
    FaceOrder faces;
    const char* words;
  };
  double x = 25;
  for (const Pair& pair : {Pair{VertexOrder::w_minor, FaceOrder::rows, "vertices W-minor, faces in rows"},
                           Pair{VertexOrder::u_major, FaceOrder::u_major, "vertices and faces U-major"},
                           Pair{VertexOrder::bird, FaceOrder::curve, "vertices Bird, faces on the curve"}}) {
    constexpr double size = 290;
    draw_order(canvas, {x, 45, size, 2}, pair.vertices, pair.faces);
    draw_order(canvas, {x, 400, size, 3}, pair.vertices, pair.faces);
    canvas.text({x + size / 2, 725}, pair.words, 15, ink, "middle");
    x += 330;
  }
  canvas.text({20, 32}, "level 2", 14, ink, "start", true);
  canvas.text({20, 387}, "level 3", 14, ink, "start", true);
  return canvas.str();
}

std::string attribute_decimation() {
  Canvas canvas(1120, 390, "Edges decimated: levels 1 and 2 with each set of flags");
  for (EdgeFlags flags = 0; flags < edge_flag_sets; ++flags) {
    const double x = 20 + 137.0 * flags;
    draw_decimated(canvas, {x, 40, 118, 1}, flags);
    draw_decimated(canvas, {x, 190, 118, 2}, flags);
    canvas.text({x + 59, 325}, fmt::format("flags {}", flags), 14, ink, "middle");
  }
  canvas.text({20, 24}, "level 1", 14, ink, "start", true);
  canvas.text({20, 174}, "level 2", 14, ink, "start", true);
  canvas.polygon({{20, 356}, {50, 356}}, "none", blue, 4, 0.6, false);
  canvas.text({58, 361}, "an edge whose neighbour has one level less", 13);
  canvas.dot({400, 356}, 3.5, "#ffffff", vermilion);
  canvas.polygon({{403, 356}, {425, 356}}, "none", vermilion, 3, 1, false);
  canvas.text({433, 361}, "a vertex that is read from another", 13);
  canvas.polygon({{700, 348}, {718, 348}, {718, 364}, {700, 364}}, "#f3d9c4", ink, 1);
  canvas.text({726, 361}, "a micro-triangle with a corner that moved", 13);
  return canvas.str();
}

}  // namespace mmverify::tests
