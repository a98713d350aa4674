// Attribute micromaps: the places of micro-vertices and micro-triangles in a map, and a point's weights at
// vertices.
#include <set>
#include <tuple>

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/attribute/lookup.hpp"

namespace mmverify::vectors::attribute {
namespace {

using namespace spec::attribute;
using spec::Level;

const Column why{"about", Kind::about, "why the vector is there"};
constexpr Level last_whole = 3, highest = 16;

/// Calls each(about, level, index) for selected indices below count(level): all of small levels, some of
/// large ones.
template <class Count, class Each>
void for_each_index(Count count, Each each) {
  for (Level n = 0; n <= last_whole; ++n)
    for (std::uint64_t x = 0; x < count(n); ++x) each("whole level", n, x);
  for (const Level n : {4u, 5u, 8u, 12u, 15u, highest}) {
    const std::uint64_t all = count(n);
    std::set<std::uint64_t> seen;
    const auto once = [&](const char* about, std::uint64_t x) {
      if (seen.insert(x).second) each(about, n, x);
    };
    once("first", 0);
    once("last", all - 1);
    once("last but one", all - 2);
    once("first that the level adds to the one below", count(n - 1));
    once("last of the level below", count(n - 1) - 1);
    const std::uint64_t N = spec::side(n);
    once("end of the first row or strip", N);
    once("begin of the second row or strip", N + 1);
    Mixed mixed(n);
    for (unsigned k = 0; k < 8; ++k) {
      const std::uint64_t high = mixed.bits(24);
      once("anywhere", (high << 16 | mixed.bits(16)) % all);
    }
  }
}

void add_vertices(Builder& out) {
  for (const VertexOrder order : vertex_orders)
    for_each_index(vertex_count, [&](const char* about, Level n, std::uint64_t x) {
      const Vertex at = vertex_at(order, x, n);
      out.add({about, static_cast<std::uint32_t>(order), n, static_cast<std::uint32_t>(x), at.i, at.j});
    });
}

void add_faces(Builder& out) {
  for (const FaceOrder order : face_orders)
    for_each_index(face_count, [&](const char* about, Level n, std::uint64_t x) {
      const MicroTriangle at = triangle_at(order, x, n);
      out.add({about, static_cast<std::uint32_t>(order), n, static_cast<std::uint32_t>(x), at.iu, at.iv,
               at.upper ? 1u : 0u});
    });
}

class Hits {
 public:
  explicit Hits(Builder& out) : out_(out) {}

  void add(const char* about, Level n, std::uint32_t u, std::uint32_t v) {
    const spec::Point<Rational> p{exactly(u), exactly(v)};
    if (p.u < 0 || p.v < 0 || p.u + p.v > 1 || !seen_.emplace(n, u, v).second) return;
    const MicroTriangle at = holder(Ties::vulkan, p, n);
    const Weights<Rational> w = weights_by_pattern(p, at, n);
    bool exact = true;
    for (const Rational& weight : w) exact = exact && exactly(nearest(weight)) == weight;
    const auto vertices = [&](VertexOrder order, std::size_t k) {
      return static_cast<std::uint32_t>(triplet(order, at, n)[k]);
    };
    constexpr auto W = VertexOrder::w_minor, U = VertexOrder::u_major, B = VertexOrder::bird;
    out_.add({about,
              n,
              u,
              v,
              at.iu,
              at.iv,
              at.upper ? 1u : 0u,
              nearest(w[0]),
              nearest(w[1]),
              nearest(w[2]),
              exact ? 1u : 0u,
              vertices(W, 0),
              vertices(W, 1),
              vertices(W, 2),
              vertices(U, 0),
              vertices(U, 1),
              vertices(U, 2),
              vertices(B, 0),
              vertices(B, 1),
              vertices(B, 2)});
  }

  void add_around(Level n, std::uint32_t u, std::uint32_t v) {
    add("a tie", n, u, v);
    for (const int d : {-1, 1}) {
      add("one float from a tie", n, u == 0 ? u : stepped(u, d), v);
      add("one float from a tie", n, u, v == 0 ? v : stepped(v, d));
    }
  }

 private:
  Builder& out_;
  std::set<std::tuple<Level, std::uint32_t, std::uint32_t>> seen_;
};

void add_hits(Builder& out) {
  Hits hits(out);
  for (Level n = 0; n <= 2; ++n)
    for (std::uint32_t b = 0; b <= 4 * spec::side(n); ++b)
      for (std::uint32_t a = 0; a + b <= 4 * spec::side(n); ++a)
        hits.add("quarters of a whole level: weights are exact", n, dyadic(a, n + 2), dyadic(b, n + 2));
  for (const Level n : {3u, 5u, 8u, 12u, highest}) {
    const std::uint32_t N = spec::side(n);
    for (const auto& [a, b] : {std::pair{0u, 0u},
                               {4 * N, 0u},
                               {0u, 4 * N},
                               {4u, 4u},
                               {2 * N, 2 * N},
                               {4u, 1u},
                               {1u, 4u},
                               {1u, 3u},
                               {4 * N - 8, 4u},
                               {2 * N, 1u},
                               {2 * N - 1, N + 1}})
      hits.add_around(n, dyadic(a, n + 2), dyadic(b, n + 2));
    Mixed mixed(n);
    for (unsigned k = 0; k < 12; ++k) {
      const auto v = dyadic(mixed.bits(23), 24);
      hits.add("anywhere", n, dyadic(mixed.bits(23), 24), v);
    }
  }
}

}  // namespace

Family family() {
  Builder out("attribute", 1,
              "values at micro-vertices and micro-triangles: their orders, and a point's weights");
  out.table("vertices", "A micro-vertex and its place in a map.",
            {why,
             {"order", Kind::name, "of the map", {"w-minor", "u-major", "bird"}},
             {"level", Kind::number, "n; (N+1)(N+2)/2 vertices, N = 2^n"},
             {"index", Kind::number, "its place"},
             {"i", Kind::number, "steps of 1/N along u"},
             {"j", Kind::number, "steps of 1/N along v"}});
  add_vertices(out);
  out.table("faces", "A micro-triangle and its place in a map.",
            {why,
             {"order", Kind::name, "of the map", {"curve", "rows", "u-major"}},
             {"level", Kind::number, "n; 4^n micro-triangles"},
             {"index", Kind::number, "its place"},
             {"iu", Kind::number, "its grid square along u"},
             {"iv", Kind::number, "its grid square along v"},
             {"upper", Kind::number, "1 where it is the half of the square beyond the diagonal"}});
  add_faces(out);
  std::vector<Column> columns{why,
                              {"level", Kind::number, "n"},
                              {"u", Kind::binary32, "barycentric of the second vertex"},
                              {"v", Kind::binary32, "barycentric of the third vertex"},
                              {"iu", Kind::number, "the micro-triangle's grid square"},
                              {"iv", Kind::number, "the micro-triangle's grid square"},
                              {"upper", Kind::number, "1: beyond its diagonal"}};
  for (const char* k : {"0", "1", "2"})
    columns.push_back(
        {std::string("weight") + k, Kind::binary32, "of vertex " + std::string(k) + ", to the nearest"});
  columns.push_back({"exact", Kind::number, "1 where the three weights are exact"});
  for (const char* order : {"w_minor", "u_major", "bird"})
    for (const char* k : {"0", "1", "2"})
      columns.push_back(
          {std::string(order) + k, Kind::number, "place of vertex " + std::string(k) + " in that order"});
  out.table("hits", "A point's micro-triangle by Vulkan's rule for ties, its vertices and their weights.",
            columns);
  add_hits(out);
  return out.take();
}

}  // namespace mmverify::vectors::attribute
