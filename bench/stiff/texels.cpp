// Stiff texels of binary32, for attribute bakers.
#include <bit>
#include <cmath>

#include "bench/attribute/clipped.hpp"
#include "bench/stiff/parts.hpp"
#include "impl/attribute/bake.hpp"
#include "impl/index/index.hpp"
#include "spec/attribute/bake.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::bench::stiff {
namespace {

namespace fast = impl::attribute;
namespace exact = spec::attribute;
using fast::RgbaFloat;
using spec::Rational;

constexpr std::uint32_t map_level = 2, map_side = 1u << map_level, map_faces = map_side * map_side,
                        map_vertices = (map_side + 1) * (map_side + 2) / 2;
constexpr std::uint64_t samples_a_map = 2048, fewest_maps = 16;

/// A texture of floats, repeated.
struct Floats {
  std::uint32_t width = 0, height = 0;
  std::vector<RgbaFloat> texels = {};
  fast::BaseTriangle uv = {};

  const RgbaFloat& at(std::int64_t x, std::int64_t y) const {
    const auto in = [](std::int64_t k, std::int64_t side) {
      return static_cast<std::size_t>((k % side + side) % side);
    };
    return texels[in(x, width) + in(y, height) * width];
  }
};

float of_exponent(Random& random, int exponent) {
  const float size = std::ldexp(1 + std::ldexp(static_cast<float>(below(random, 1u << 23)), -23), exponent);
  return coin(random) ? size : -size;
}
/// Positive numbers of 2^-10 to 2^14, as high dynamic range has them.
float ordinary_texel(Random& random) {
  return std::fabs(of_exponent(random, static_cast<int>(below(random, 25)) - 10));
}
float large_or_small(Random& random) {
  const int more = static_cast<int>(below(random, 11)) - 5;
  return of_exponent(random, (coin(random) ? 100 : -100) + more);
}
float subnormal_texel(Random& random) { return (coin(random) ? 1.0f : -1.0f) * subnormal(random); }

using DrawTexel = float (*)(Random&);
using DrawCoordinate = float (*)(Random&);

/// A multiple of 2^-8 within two repeats.
float any_coordinate(Random& random) { return std::ldexp(static_cast<float>(below(random, 1025)), -8) - 2; }
/// An eighth, or a hair beside 0: micro-vertices then often lie on the borders and centres of texels or beside them by
/// less than binary64 holds, where a texel of 2^100 has next to no weight.
float coordinate_by_a_hair(Random& random) {
  if (below(random, 4) != 0) return static_cast<float>(below(random, 33)) / 8 - 2;
  const float hair = std::ldexp(1.0f, -30 - static_cast<int>(below(random, 41)));
  return coin(random) ? hair : -hair;
}

struct TexelKind {
  const char* name;
  DrawTexel texel;
  DrawCoordinate coordinate;
};

/// Sides of 1 to 7 texels.
Floats drawn(Random& random, const TexelKind& kind) {
  Floats one;
  one.width = static_cast<std::uint32_t>(1 + below(random, 7));
  one.height = static_cast<std::uint32_t>(1 + below(random, 7));
  one.texels.resize(std::size_t{one.width} * one.height);
  for (RgbaFloat& t : one.texels)
    for (float& channel : t) channel = kind.texel(random);
  for (fast::TexturePoint& p : one.uv) {
    p.u = kind.coordinate(random);
    p.v = kind.coordinate(random);
  }
  return one;
}

RgbaFloat exact_value(const Floats& one, const exact::Shares<Rational>& shares) {
  RgbaFloat value{};
  for (std::size_t c = 0; c < 4; ++c) {
    Rational sum(0);
    for (const exact::Share<Rational>& s : shares)
      sum += s.weight * spec::bake::number<Rational>(
                            spec::bake::Binary32{std::bit_cast<std::uint32_t>(one.at(s.i, s.j)[c])});
    value[c] = std::bit_cast<float>(exact::Rounded<exact::Binary32>::of(sum).bits);
  }
  return value;
}

exact::BaseTriangle<Rational> exact_triangle_of(const Floats& one) {
  const auto vertex = [&](std::size_t k) {
    return spec::bake::place<Rational>({std::bit_cast<std::uint32_t>(one.uv[k].u)},
                                       {std::bit_cast<std::uint32_t>(one.uv[k].v)});
  };
  return {vertex(0), vertex(1), vertex(2)};
}

using Values = std::vector<RgbaFloat>;

void exact_vertices(const Floats& one, Values& out) {
  const auto uv = exact_triangle_of(one);
  for (std::uint32_t k = 0; k < map_vertices; ++k)
    out[k] = exact_value(
        one, exact::shares_at(exact::micro_vertex(uv, map_level,
                                                  exact::vertex_at(exact::VertexOrder::w_minor, k, map_level),
                                                  one.width, one.height),
                              exact::Filter::bilinear));
}

void exact_faces(const Floats& one, Values& out) {
  const auto uv = exact_triangle_of(one);
  for (std::uint32_t k = 0; k < map_faces; ++k)
    out[k] =
        exact_value(one, exact::shares_on(spec::bake::micro_triangle(uv, map_level, k, one.width, one.height),
                                          exact::Filter::nearest));
}

/// Bilinear values at the micro-vertices, computed in Real.
template <class Real>
void sampled_vertices(const Floats& one, Values& out) {
  const auto real = [](auto x) { return static_cast<Real>(x); };
  const auto& uv = one.uv;
  std::size_t k = 0;
  for (std::uint32_t r = 0; r <= map_side; ++r)
    for (std::uint32_t j = 0; j <= r; ++j, ++k) {
      const Real s = real(r - j) / map_side, t = real(j) / map_side;
      const Real x = (real(uv[0].u) + (real(uv[1].u) - real(uv[0].u)) * s +
                      (real(uv[2].u) - real(uv[0].u)) * t) *
                         real(one.width) -
                     real(0.5),
                 y = (real(uv[0].v) + (real(uv[1].v) - real(uv[0].v)) * s +
                      (real(uv[2].v) - real(uv[0].v)) * t) *
                         real(one.height) -
                     real(0.5);
      const Real left = std::floor(x), top = std::floor(y), f = x - left, h = y - top;
      const auto i = static_cast<std::int64_t>(left), l = static_cast<std::int64_t>(top);
      const RgbaFloat &a = one.at(i, l), &b = one.at(i + 1, l), &c = one.at(i, l + 1),
                      &d = one.at(i + 1, l + 1);
      for (std::size_t m = 0; m < 4; ++m)
        out[k][m] = static_cast<float>((1 - h) * ((1 - f) * real(a[m]) + f * real(b[m])) +
                                       h * ((1 - f) * real(c[m]) + f * real(d[m])));
    }
}

/// The means over the micro-triangles, clipped by each texel, in binary64.
void clipped_faces(const Floats& one, Values& out) {
  Clipping clipping;
  const auto& uv = one.uv;
  for (std::uint32_t k = 0; k < map_faces; ++k) {
    std::array<Point2, 3> p;
    const auto corners = impl::index::corners(k, map_level);
    for (std::size_t c = 0; c < 3; ++c) {
      const double s = double{static_cast<float>(corners[c].i)} / map_side,
                   t = double{static_cast<float>(corners[c].j)} / map_side;
      p[c] = {(uv[0].u + s * (double{uv[1].u} - uv[0].u) + t * (double{uv[2].u} - uv[0].u)) * one.width,
              (uv[0].v + s * (double{uv[1].v} - uv[0].v) + t * (double{uv[2].v} - uv[0].v)) * one.height};
    }
    std::array<double, 4> sum{};
    double all = 0;
    clipping.each_area(p, [&](std::int64_t x, std::int64_t y, double area) {
      all += area;
      for (std::size_t c = 0; c < 4; ++c) sum[c] += area * one.at(x, y)[c];
    });
    for (std::size_t c = 0; c < 4; ++c) out[k][c] = static_cast<float>(sum[c] / all);
  }
}

/// Maps with their exact values, and the time of one of those.
struct FloatMaps {
  std::vector<Floats> cases = {};
  std::vector<fast::AttributeBakerFloat> bakers = {};
  Values vertices = {}, faces = {};
  double vertex_ns = 0, face_ns = 0;

  FloatMaps(const TexelKind& kind, Random random, std::size_t maps) {
    for (std::size_t k = 0; k < maps; ++k) cases.push_back(drawn(random, kind));
    for (const Floats& one : cases)
      bakers.emplace_back(fast::RgbaViewFloat{one.texels.data()->data(), one.width, one.height, one.width});
    vertex_ns = specify(vertices, map_vertices, exact_vertices);
    face_ns = specify(faces, map_faces, exact_faces);
  }

  /// Appends the exact values of all maps; the time of one.
  double specify(Values& to, std::size_t size, void (*values)(const Floats&, Values&)) {
    Values out(size);
    return once_ns([&] {
             for (const Floats& one : cases) {
               values(one, out);
               to.insert(to.end(), out.begin(), out.end());
             }
           }) /
           static_cast<double>(size * cases.size());
  }
};

/// Returns the number of values that took whole numbers.
using BakeFloats = std::function<std::uint64_t(const FloatMaps&, std::size_t map, Values& out)>;

BakeFloats plainly(void (*values)(const Floats&, Values&)) {
  return [values](const FloatMaps& maps, std::size_t map, Values& out) {
    values(maps.cases[map], out);
    return std::uint64_t{0};
  };
}

/// Whether a is not b, nor the number of binary32 above it or below it.
bool off_by_ulps(float a, float b) { return a != b && std::nextafter(a, b) != b; }

/// The number of values with a channel that is off by more than the last place of binary32.
std::uint64_t wrong_values(const FloatMaps& maps, const Values& truth, std::size_t size,
                           const BakeFloats& bake) {
  std::uint64_t wrong = 0;
  Values out(size);
  for (std::size_t m = 0; m < maps.cases.size(); ++m) {
    bake(maps, m, out);
    for (std::size_t k = 0; k < size; ++k) {
      const RgbaFloat& right = truth[m * size + k];
      wrong += off_by_ulps(out[k][0], right[0]) || off_by_ulps(out[k][1], right[1]) ||
                       off_by_ulps(out[k][2], right[2]) || off_by_ulps(out[k][3], right[3])
                   ? 1
                   : 0;
    }
  }
  return wrong;
}

struct FloatMethod {
  const char* name;
  bool of_faces;
  BakeFloats bake;
};

StiffFigure float_figure(const FloatMaps& stiff, const FloatMaps& ordinary, const FloatMethod& method,
                         std::size_t rounds) {
  const std::size_t size = method.of_faces ? map_faces : map_vertices, all = size * stiff.cases.size();
  const auto truth = [&](const FloatMaps& m) -> const Values& {
    return method.of_faces ? m.faces : m.vertices;
  };
  StiffFigure figure{.method = method.name,
                     .cases = all,
                     .wrong = wrong_values(stiff, truth(stiff), size, method.bake),
                     .ordinary_wrong = wrong_values(ordinary, truth(ordinary), size, method.bake)};
  Values out(size);
  if (figure.method.ends_with("ours")) {
    figure.is_ours = true;
    std::uint64_t exact = 0;
    for (std::size_t m = 0; m < stiff.cases.size(); ++m) exact += method.bake(stiff, m, out);
    figure.exact = static_cast<double>(exact) / static_cast<double>(all);
  }
  add_times(figure, all, all, rounds, [&](bool is_stiff) {
    const FloatMaps& maps = is_stiff ? stiff : ordinary;
    for (std::size_t m = 0; m < maps.cases.size(); ++m) method.bake(maps, m, out);
  });
  return figure;
}

}  // namespace

void add_texels(const StiffBenchOptions& o, std::vector<StiffFigure>& figures) {
  const std::size_t maps = std::max(fewest_maps, o.samples / samples_a_map);
  const auto begins = [&](const char* kind) {
    if (o.progress) o.progress(kind);
  };
  const BakeFloats our_vertices = [](const FloatMaps& m, std::size_t map, Values& out) {
    return m.bakers[map].vertices(m.cases[map].uv, map_level, out).exact;
  };
  const BakeFloats our_faces = [](const FloatMaps& m, std::size_t map, Values& out) {
    return m.bakers[map].faces(m.cases[map].uv, map_level, out).exact;
  };
  const FloatMethod methods[] = {{"vertices, binary32", false, plainly(sampled_vertices<float>)},
                                 {"vertices, binary64", false, plainly(sampled_vertices<double>)},
                                 {"vertices, ours", false, our_vertices},
                                 {"faces, binary64", true, plainly(clipped_faces)},
                                 {"faces, ours", true, our_faces}};
  begins("ordinary texels");
  const FloatMaps ordinary({"", ordinary_texel, any_coordinate}, stream(o.seed, 10), maps);
  std::uint32_t number = 11;
  for (const TexelKind& kind : {TexelKind{"magnitudes", large_or_small, coordinate_by_a_hair},
                                TexelKind{"subnormal texels", subnormal_texel, any_coordinate}}) {
    begins(kind.name);
    const FloatMaps stiff(kind, stream(o.seed, number++), maps);
    for (const FloatMethod& method : methods) {
      figures.push_back(float_figure(stiff, ordinary, method, o.rounds));
      figures.back().kind = kind.name;
    }
    figures.push_back({.kind = kind.name,
                       .method = "vertices, rational",
                       .cases = stiff.vertices.size(),
                       .ns = stiff.vertex_ns,
                       .ratio = stiff.vertex_ns / ordinary.vertex_ns});
    figures.push_back({.kind = kind.name,
                       .method = "faces, rational",
                       .cases = stiff.faces.size(),
                       .ns = stiff.face_ns,
                       .ratio = stiff.face_ns / ordinary.face_ns});
  }
}

}  // namespace mmverify::bench::stiff
