#include "proofs/attribute/decimation/mesh.hpp"

#include "proofs/attribute/elements.hpp"
#include "spec/rational.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::attribute::doubled_area;

bool on_level(const Vertex& x, Level n) { return std::uint64_t{x.i} + x.j <= spec::side(n); }

/// Which base edges hold both, a bit each.
std::uint32_t base_edges_of(const Vertex& a, const Vertex& b, Level n) {
  const std::uint32_t N = spec::side(n);
  return (a.j == 0 && b.j == 0 ? 1u : 0u) | (a.i + a.j == N && b.i + b.j == N ? 2u : 0u) |
         (a.i == 0 && b.i == 0 ? 4u : 0u);
}

/// An edge that a micro-triangle has on its left, by both ends.
using DirectedEdge = std::pair<std::uint64_t, std::uint64_t>;
DirectedEdge edge_between(const Vertex& a, const Vertex& b) { return {number(a), number(b)}; }

std::string text_of_edge(const DirectedEdge& e) {
  return fmt::format("{} to {}", text_of(spec::attribute::w_minor_vertex(e.first)),
                     text_of(spec::attribute::w_minor_vertex(e.second)));
}

/// How many micro-triangles of the level as it was have the edge on their left: one of each pair of neighbours in the
/// directions that lower ones have, and in the opposite ones that upper ones have, if there is such an upper one.
std::int64_t edges_before(const Vertex& a, const Vertex& b, Level n) {
  const auto step = [](std::uint32_t to, std::uint32_t from) {
    return std::int64_t{to} - std::int64_t{from};
  };
  const std::int64_t di = step(b.i, a.i), dj = step(b.j, a.j);
  const bool lower = (di == 1 && dj == 0) || (di == -1 && dj == 1) || (di == 0 && dj == -1);
  const bool upper = (di == -1 && dj == 0) || (di == 1 && dj == -1) || (di == 0 && dj == 1);
  return lower || (upper && base_edges_of(a, b, n) == 0) ? 1 : 0;
}

/// How many have it now: as it was, and what the changed ones took away and brought.
class Edges {
 public:
  explicit Edges(const DecimatedMesh& mesh) : n_(mesh.level()) {
    for (const Changed& c : mesh.changed())
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        --change_[edge_between(c.before[k], c.before[next])];
        if (doubled_area(c.after) != 0) ++change_[edge_between(c.after[k], c.after[next])];
      }
  }
  std::int64_t count(const DirectedEdge& e) const {
    const auto found = change_.find(e);
    return edges_before(spec::attribute::w_minor_vertex(e.first), spec::attribute::w_minor_vertex(e.second),
                        n_) +
           (found == change_.end() ? 0 : found->second);
  }
  const std::map<DirectedEdge, std::int64_t>& changes() const { return change_; }

 private:
  Level n_;
  std::map<DirectedEdge, std::int64_t> change_;
};

std::string times(std::int64_t k) { return k == 1 ? "once" : fmt::format("{} times", k); }

// ---- Areas of polygons

namespace clipping {

using Number = spec::Rational128;
struct Corner {
  Number x, y;
};
using Polygon = std::vector<Corner>;

/// Twice the area of the triangle; above 0 where c lies to the left of a to b.
Number side_of(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// The part of a convex polygon to the left of a to b.
Polygon clipped(const Polygon& p, const Corner& a, const Corner& b) {
  Polygon left;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Corner &at = p[k], &next = p[(k + 1) % p.size()];
    const Number here = side_of(a, b, at), there = side_of(a, b, next);
    if (here >= 0) left.push_back(at);
    if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
      const Number t = here / (here - there);
      left.push_back({at.x + t * (next.x - at.x), at.y + t * (next.y - at.y)});
    }
  }
  return left;
}

Number doubled_area_of(const Polygon& p) {
  Number sum = 0;
  for (std::size_t k = 2; k < p.size(); ++k) sum += side_of(p[0], p[k - 1], p[k]);
  return sum;
}

/// Corners relative to a vertex.
using Shape = std::array<std::int64_t, 12>;
Shape shape_of(const Changed& c) {
  Shape shape{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto from = [](std::uint32_t x, std::uint32_t origin) {
      return std::int64_t{x} - std::int64_t{origin};
    };
    shape[2 * k] = from(c.before[k].i, c.of.iu);
    shape[2 * k + 1] = from(c.before[k].j, c.of.iv);
    shape[6 + 2 * k] = from(c.after[k].i, c.of.iu);
    shape[7 + 2 * k] = from(c.after[k].j, c.of.iv);
  }
  return shape;
}

/// The doubled area of the micro-triangle as it was that it does not cover any more.
Number lost(const Shape& shape) {
  const auto corner = [&](std::size_t at) { return Corner{Number(shape[at]), Number(shape[at + 1])}; };
  const Polygon before{corner(0), corner(2), corner(4)}, after{corner(6), corner(8), corner(10)};
  Polygon both = before;
  if (doubled_area_of(after) <= 0) both.clear();
  for (std::size_t k = 0; k < 3; ++k) both = clipped(both, after[k], after[(k + 1) % 3]);
  return doubled_area_of(before) - doubled_area_of(both);
}

}  // namespace clipping

}  // namespace

// ---- The mesh

DecimatedMesh::DecimatedMesh(const AttributeSubject& subject, Level n, EdgeFlags flags, VertexChoice asked)
    : n_(n), flags_(flags) {
  constexpr std::uint64_t at_once = 4096;
  std::vector<Vertex> at;
  if (asked == VertexChoice::all) {
    const std::uint64_t all = spec::attribute::vertex_count(n);
    for (std::uint64_t first = 0; first < all; first += at_once) {
      at.resize(static_cast<std::size_t>(std::min(at_once, all - first)));
      fill(n, first, std::span(at));
      ask(subject, at);
    }
  } else {
    const std::uint32_t N = spec::side(n);
    for (std::uint32_t i = 0; i <= N; ++i)
      for (std::uint32_t j = 0; j <= N - i; ++j) {
        at.push_back({i, j});
        // Between one step from v = 0 and one from w = 0 there is nothing to ask.
        if (i > 1 && j == 1 && N - i > 3) j = N - i - 2;
      }
    ask(subject, at);
  }
  std::sort(moves_.begin(), moves_.end(),
            [](const Move& a, const Move& b) { return number(a.from) < number(b.from); });
  for (const Move& m : moves_)
    spec::attribute::around(m.from, n, [&](const MicroTriangle& t) {
      const Corners before = spec::attribute::corners_of(t);
      Corners then = before;
      for (Vertex& x : then) x = after(x);
      changed_.push_back({t, before, then});
    });
  // One with two corners that moved was met twice.
  const auto place = [](const Changed& c) { return std::array{c.of.iu, c.of.iv, c.of.upper ? 1u : 0u}; };
  std::sort(changed_.begin(), changed_.end(),
            [&](const Changed& a, const Changed& b) { return place(a) < place(b); });
  changed_.erase(std::unique(changed_.begin(), changed_.end(),
                             [](const Changed& a, const Changed& b) { return a.of == b.of; }),
                 changed_.end());
}

void DecimatedMesh::ask(const AttributeSubject& subject, std::span<const Vertex> at) {
  std::vector<Vertex> to(at.size());
  subject.functions.decimation.snapped(n_, flags_, at, to);
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (to[k] == at[k]) continue;
    digest_ += Tally::digest_of(number(at[k]), number(to[k]));
    if (complaint_) continue;
    if (!spec::attribute::decimated_at(at[k], n_, flags_).decimated)
      complaint_ = {text_of(at[k]) + " stays", "goes to " + text_of(to[k])};
    else if (!on_level(to[k], n_))
      complaint_ = {text_of(at[k]) + " stays in the triangle", "goes to " + text_of(to[k])};
    else
      moves_.push_back({at[k], to[k]});
  }
}

Vertex DecimatedMesh::after(const Vertex& x) const {
  const auto found = std::lower_bound(moves_.begin(), moves_.end(), number(x),
                                      [](const Move& m, std::uint64_t k) { return number(m.from) < k; });
  return found != moves_.end() && found->from == x ? found->to : x;
}

bool DecimatedMesh::has_changed(const MicroTriangle& t) const {
  const Corners c = spec::attribute::corners_of(t);
  return std::any_of(c.begin(), c.end(), [&](const Vertex& x) { return !(after(x) == x); });
}

Finding watertight(const DecimatedMesh& mesh) {
  if (mesh.complaint()) return wrong(mesh.complaint()->expected, mesh.complaint()->got);
  const Level n = mesh.level();
  const Edges edges(mesh);
  // Every edge that did not change met its opposite before, or lies on a base edge, which is walked below.
  for (const auto& [e, change] : edges.changes()) {
    const Vertex a = spec::attribute::w_minor_vertex(e.first), b = spec::attribute::w_minor_vertex(e.second);
    const std::int64_t there = edges.count(e), back = edges.count({e.second, e.first});
    if (base_edges_of(a, b, n) == 0) {
      if (there != back || there > 1 || there < 0)
        return wrong("edge " + text_of_edge(e) + " and its opposite once each, or neither",
                     fmt::format("{} and {}", times(there), times(back)));
    } else if (there + back > 1 || back > edges_before(b, a, n)) {
      return wrong("base edge " + text_of_edge(e) + " once at most", fmt::format("{}", times(there + back)));
    }
  }
  const std::uint32_t N = spec::side(n);
  for (std::uint32_t edge = 0; edge < 3; ++edge) {
    const std::uint32_t step = n != 0 && (mesh.flags() >> edge & 1) != 0 ? 2 : 1;
    for (std::uint32_t at = 0; at < N; at += step) {
      const DirectedEdge e =
          edge_between(spec::attribute::on_edge(edge, at, n), spec::attribute::on_edge(edge, at + step, n));
      if (const std::int64_t there = edges.count(e); there != 1)
        return wrong("base edge " + text_of_edge(e) + " once", times(there));
    }
  }
  return {.answer = mesh.digest()};
}

Finding areas_kept(const DecimatedMesh& mesh) {
  if (mesh.complaint()) return wrong(mesh.complaint()->expected, mesh.complaint()->got);
  std::int64_t gained = 0;
  for (const Changed& c : mesh.changed()) {
    const std::int64_t area = doubled_area(c.after);
    if (area < 0) return wrong(text_of(c.of) + " not turned over", fmt::format("an area of {}", area));
    gained += area - 1;
  }
  const auto all = static_cast<std::int64_t>(spec::attribute::face_count(mesh.level()));
  if (gained != 0)
    return wrong(fmt::format("{} micro-triangles of area", all), fmt::format("{}", all + gained));
  return {.answer = static_cast<std::uint64_t>(all)};
}

Finding counted(const DecimatedMesh& mesh) {
  if (mesh.complaint()) return wrong(mesh.complaint()->expected, mesh.complaint()->got);
  std::vector<std::uint64_t> used, asked;
  std::uint64_t degenerate = 0;
  for (const Changed& c : mesh.changed()) {
    for (const Vertex& x : c.before) asked.push_back(number(x));
    if (doubled_area(c.after) == 0) {
      ++degenerate;
      continue;
    }
    for (const Vertex& x : c.after) used.push_back(number(x));
  }
  std::sort(used.begin(), used.end());
  std::sort(asked.begin(), asked.end());
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  std::uint64_t unused = 0;
  for (const std::uint64_t x : asked) {
    bool is_used = std::binary_search(used.begin(), used.end(), x);
    spec::attribute::around(spec::attribute::w_minor_vertex(x), mesh.level(),
                            [&](const MicroTriangle& t) { is_used = is_used || !mesh.has_changed(t); });
    unused += is_used ? 0 : 1;
  }
  const std::uint64_t odd = odd_vertices(mesh.level(), mesh.flags());
  if (degenerate != odd || unused != odd)
    return wrong(fmt::format("{} degenerate micro-triangles and {} unused vertices", odd, odd),
                 fmt::format("{} and {}", degenerate, unused));
  return {.answer = spec::attribute::face_count(mesh.level()) - degenerate};
}

std::uint64_t lost_quarters(const DecimatedMesh& mesh) {
  using namespace clipping;
  std::map<Shape, Number> known;
  Number sum = 0;
  for (const Changed& c : mesh.changed()) {
    const Shape shape = shape_of(c);
    auto found = known.find(shape);
    if (found == known.end()) found = known.emplace(shape, lost(shape)).first;
    sum += found->second;
  }
  const Number quarters = 4 * sum;
  return quarters.denominator() == 1 ? static_cast<std::uint64_t>(quarters.numerator()) : ~std::uint64_t{0};
}

}  // namespace mmverify::proofs::attribute
