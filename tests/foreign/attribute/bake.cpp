// Maps from textures, and how far they are from these.
// Source: Color and Attribute Micromaps, 5.1; docs/ATTRIBUTE_BAKE.md.
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/foreign/attribute/places.hpp"
#include "tests/foreign/attribute/texture.hpp"

namespace mmverify::tests::foreign::attribute {

std::vector<proofs::attribute::PlannedTriangle> planned(const proofs::attribute::PlanCase&, Fault);

namespace {

using proofs::attribute::Baking;
using proofs::attribute::ChannelError;
using proofs::attribute::MapForm;

/// A place in texels, or within a micro-triangle.
template <class Q>
struct At {
  Q x, y;
};

template <class Q>
std::array<At<Q>, 3> base_of(const BakeCase& one, Fault wrong) {
  std::array<At<Q>, 3> base;
  for (std::size_t k = 0; k < 3; ++k) {
    base[k] = {exactly<Q>(one.uv[2 * k]) * ratio<Q>(one.picture.width, 1),
               exactly<Q>(one.uv[2 * k + 1]) * ratio<Q>(one.picture.height, 1)};
    if (wrong == height_is_the_width)
      base[k].y = exactly<Q>(one.uv[2 * k + 1]) * ratio<Q>(one.picture.width, 1);
    if (wrong == uv_of_16_fraction_bits)
      base[k].x = ratio<Q>(floor_of(Q(exactly<Q>(one.uv[2 * k]) * ratio<Q>(65536, 1))), 65536) *
                  ratio<Q>(one.picture.width, 1);
  }
  return base;
}

/// The place of a micro-vertex of level n in the texture.
template <class Q>
At<Q> place_of(const std::array<At<Q>, 3>& base, Level n, const Vertex& at) {
  const std::int64_t N = side_of(n);
  const Q u = ratio<Q>(at.i, N), v = ratio<Q>(at.j, N);
  return {base[0].x + u * (base[1].x - base[0].x) + v * (base[2].x - base[0].x),
          base[0].y + u * (base[1].y - base[0].y) + v * (base[2].y - base[0].y)};
}

template <class Q>
Shares<Q> sampled(At<Q> at, Filter filter, Fault wrong) {
  if (filter == Filter::nearest) {
    if (wrong == nearest_ties_down) return {{-floor_of(Q(-at.x)) - 1, -floor_of(Q(-at.y)) - 1, Q(1)}};
    return {{floor_of(at.x), floor_of(at.y), Q(1)}};
  }
  const Q half = ratio<Q>(1, 2);
  at = {at.x - half, at.y - half};
  const std::int64_t i = floor_of(at.x), j = floor_of(at.y);
  Q x = at.x - ratio<Q>(i, 1), y = at.y - ratio<Q>(j, 1);
  const Q one(1);
  if (wrong == bilinear_of_8_bits) x = ratio<Q>(floor_of(Q(x * ratio<Q>(256, 1) + half)), 256);
  if (wrong == bilinear_exchanges_corners)
    return {{i, j, (one - x) * (one - y)},
            {i, j + 1, x * (one - y)},
            {i + 1, j, (one - x) * y},
            {i + 1, j + 1, x * y}};
  return {{i, j, (one - x) * (one - y)},
          {i + 1, j, x * (one - y)},
          {i, j + 1, (one - x) * y},
          {i + 1, j + 1, x * y}};
}

// ---- A micro-triangle cut along the texture's grid

/// c + a s + b t, (s, t) within the micro-triangle.
template <class Q>
struct Affine {
  Q c, a, b;
  Q operator()(const At<Q>& at) const { return c + a * at.x + b * at.y; }
};
template <class Q>
using Polygon = std::vector<At<Q>>;

/// The part of a polygon where sign (f - limit) >= 0.
template <class Q>
Polygon<Q> cut_by(const Polygon<Q>& polygon, const Affine<Q>& f, std::int64_t limit, int sign) {
  Polygon<Q> kept;
  const auto height = [&](const At<Q>& at) { return Q(ratio<Q>(sign, 1) * (f(at) - ratio<Q>(limit, 1))); };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const At<Q>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const Q a = height(p), b = height(q);
    if (a >= 0) kept.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
      const Q t = a / (a - b);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

/// Twice the area.
template <class Q>
Q doubled(const At<Q>& p, const At<Q>& q, const At<Q>& r) {
  const Q area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return area < 0 ? Q(-area) : area;
}

/// Calls visit(k, part) for each strip k <= f <= k + 1 with a part of the polygon.
template <class Q, class Visit>
void strips(const Polygon<Q>& polygon, const Affine<Q>& f, Visit visit) {
  std::vector<Q> heights;
  for (const At<Q>& at : polygon) heights.push_back(f(at));
  const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
  const std::int64_t first = floor_of(*least), last = std::max(first, -floor_of(Q(-*greatest)) - 1);
  for (std::int64_t k = first; k <= last; ++k) {
    const Polygon<Q> part = cut_by(cut_by(polygon, f, k, 1), f, k + 1, -1);
    if (part.size() > 2) visit(k, part);
  }
}

template <class Q>
struct Patch {
  Affine<Q> x, y;
  explicit Patch(const std::array<At<Q>, 3>& c, const Q& offset)
      : x{c[0].x - offset, c[1].x - c[0].x, c[2].x - c[0].x},
        y{c[0].y - offset, c[1].y - c[0].y, c[2].y - c[0].y} {}

  /// Calls visit(i, j, part) for each of the grid's squares.
  template <class Visit>
  void squares(Visit visit) const {
    strips(Polygon<Q>{{Q(0), Q(0)}, {Q(1), Q(0)}, {Q(0), Q(1)}}, y,
           [&](std::int64_t j, const Polygon<Q>& row) {
             strips(row, x, [&](std::int64_t i, const Polygon<Q>& part) { visit(i, j, part); });
           });
  }
};

template <class Q>
At<Q> halfway(const At<Q>& p, const At<Q>& q) {
  const Q half = ratio<Q>(1, 2);
  return {(p.x + q.x) * half, (p.y + q.y) * half};
}

/// The mean over the micro-triangle of what has degree 2 on the part, as far as the part goes.
template <class Q, class F>
Q integral(const Polygon<Q>& part, F f) {
  Q sum(0);
  for (std::size_t k = 2; k < part.size(); ++k) {
    const At<Q>&p = part[0], &q = part[k - 1], &r = part[k];
    sum += doubled(p, q, r) * (f(halfway(p, q)) + f(halfway(q, r)) + f(halfway(r, p)));
  }
  return sum * ratio<Q>(1, 3);
}

template <class Q>
Shares<Q> shares_of(const std::array<At<Q>, 3>& corners, Filter filter, Fault wrong) {
  Shares<Q> shares;
  if (filter == Filter::nearest) {
    Q all(0);
    Patch<Q>(corners, Q(0)).squares([&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) {
      Q weight(0);
      for (std::size_t k = 2; k < part.size(); ++k) weight += doubled(part[0], part[k - 1], part[k]);
      if (wrong == face_fans_miss_the_last && part.size() > 5) weight -= doubled(part[0], part[4], part[5]);
      if (wrong == face_weighs_texels_alike && weight != 0) weight = 1;
      all += weight;
      shares.push_back({i, j, weight});
    });
    for (Share<Q>& s : shares) s.weight /= all;
    return shares;
  }
  const Patch<Q> patch(corners, ratio<Q>(1, 2));
  patch.squares([&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) {
    for (int di = 0; di < 2; ++di)
      for (int dj = 0; dj < 2; ++dj) {
        const auto weigh = [&](const At<Q>& at) {
          const Q x = patch.x(at) - ratio<Q>(i, 1), y = patch.y(at) - ratio<Q>(j, 1), one(1);
          return Q((di != 0 ? x : one - x) * (dj != 0 ? y : one - y));
        };
        Q weight = integral(part, weigh);
        if (wrong == mean_of_bilinear_by_centroid) {
          Q area(0);
          At<Q> centre{Q(0), Q(0)};
          for (const At<Q>& at : part) centre = {centre.x + at.x, centre.y + at.y};
          const Q count = ratio<Q>(static_cast<std::int64_t>(part.size()), 1);
          for (std::size_t k = 2; k < part.size(); ++k) area += doubled(part[0], part[k - 1], part[k]);
          weight = area * weigh({centre.x / count, centre.y / count});
        }
        shares.push_back({i + di, j + dj, weight});
      }
  });
  return shares;
}

template <class Q>
std::array<At<Q>, 3> micro_triangle(const std::array<At<Q>, 3>& base, Level n, std::uint32_t index,
                                    Fault wrong) {
  MicroTriangle t = face_of(proofs::attribute::FaceOrder::curve, n, index, none);
  if (wrong == bake_faces_in_rows) t = face_of(proofs::attribute::FaceOrder::rows, n, index, none);
  if (wrong == bake_upper_as_lower_from_4 && n >= 4) t.upper = false;
  if (wrong == bake_last_face_of_5 && n == 5 && index == 1023) t.iv -= 1;
  std::array<At<Q>, 3> corners;
  for (std::size_t c = 0; c < 3; ++c) corners[c] = place_of(base, n, face_corners(t)[c]);
  return corners;
}

/// Along a segment texels that weigh alike, for a fault alone.
template <class Q>
bool without_area(const std::array<At<Q>, 3>& c) {
  return doubled(c[0], c[1], c[2]) == 0;
}

std::vector<Rgba> vertices(const BakeCase& one, Level n, Fault wrong) {
  return exact([&](auto q) {
    using Q = decltype(q);
    auto base = base_of<Q>(one, wrong);
    if (wrong == edges_in_fixed_point_one_way && base[1].x < base[0].x)
      for (At<Q>& at : base) at.x = ratio<Q>(floor_of(Q(at.x * ratio<Q>(4096, 1))), 4096);
    std::vector<Rgba> map;
    for (std::uint32_t k = 0; k < vertices_of(n); ++k) {
      Vertex x = vertex_of(proofs::attribute::VertexOrder::w_minor, n, k, none);
      if (wrong == bake_vertices_in_u_major)
        x = vertex_of(proofs::attribute::VertexOrder::u_major, n, k, none);
      if (wrong == bake_v_corner_inside_from_3 && n >= 3 && x.j == side_of(n)) --x.j;
      At<Q> at = place_of(base, n, x);
      if (wrong == hypotenuse_in_fixed_point_one_way && n > 0 && x.i + x.j == side_of(n) && x.i != 0 &&
          x.j != 0) {
        at.x = ratio<Q>(floor_of(Q(at.x * ratio<Q>(1024, 1))), 1024);
        if (base[1].x <= base[2].x) at.x = place_of(base, n, x).x;
      }
      map.push_back(codes_of(one.picture, sampled(at, one.picture.filter, wrong), wrong));
    }
    if (wrong == last_vertex_is_the_first && !map.empty() && n > 0) map.back() = map.front();
    if (wrong == one_green_in_31_at_5 && n == 5)
      for (std::size_t k = 1; k + 1 < map.size(); k += 31)
        map[k][1] = static_cast<std::uint8_t>(map[k][1] ^ 1);
    return map;
  });
}

std::vector<Rgba> faces(const BakeCase& one, Level n, Fault wrong) {
  return exact([&](auto q) {
    using Q = decltype(q);
    const auto base = base_of<Q>(one, wrong);
    std::vector<Rgba> map;
    for (std::uint32_t k = 0; k < 1u << 2 * n; ++k) {
      const auto corners = micro_triangle(base, n, k, wrong);
      Shares<Q> shares = shares_of(corners, Filter::nearest, wrong);
      const At<Q> centre{(corners[0].x + corners[1].x + corners[2].x) * ratio<Q>(1, 3),
                         (corners[0].y + corners[1].y + corners[2].y) * ratio<Q>(1, 3)};
      if (wrong == face_is_its_centre) shares = sampled(centre, Filter::nearest, wrong);
      if (wrong == face_without_area_is_its_centre && without_area(corners))
        shares = sampled(centre, Filter::nearest, wrong);
      map.push_back(codes_of(one.picture, shares, wrong));
    }
    return map;
  });
}

Rational face_mean(const BakeCase& one, Level n, std::size_t channel, std::uint32_t index, Fault wrong) {
  return exact([&](auto q) {
    using Q = decltype(q);
    const auto corners = micro_triangle(base_of<Q>(one, wrong), n, index, wrong);
    Shares<Q> shares = shares_of(corners, one.picture.filter, wrong);
    if (wrong == mean_without_area_alike && without_area(corners) && !shares.empty())
      for (Share<Q>& s : shares) s.weight = ratio<Q>(1, static_cast<std::int64_t>(shares.size()));
    Q mean = mean_of(one.picture, channel, shares, wrong);
    if (wrong == mean_of_codes_at_level_2 && n == 2)
      mean = ratio<Q>(floor_of(Q(mean * ratio<Q>(255, 1) + ratio<Q>(1, 2))), 255);
    return wide(mean);
  });
}

// ---- Errors

/// Texture less map over a part: the largest size, and the mean of its square as far as the part goes.
template <class Q>
struct Judged {
  Q largest{0}, square{0};

  void see(const Q& e) { largest = std::max(largest, Q(e < 0 ? Q(-e) : e)); }

  template <class F>
  void part(const Polygon<Q>& polygon, F f, Fault wrong) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const At<Q>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const Q a = f(p), b = f(q), m = f(halfway(p, q));
      see(a);
      if (wrong == error_at_corners_alone) continue;
      // f = a + slope t + bend t^2
      const Q bend = 2 * a - 4 * m + 2 * b, slope = 4 * m - 3 * a - b;
      if (bend == 0) continue;
      const Q t = -slope / (2 * bend);
      if (t > 0 && t < 1 && !(wrong == error_still_in_first_half && t > ratio<Q>(3, 4)))
        see(a + slope * t / 2);
    }
    for (std::size_t k = 2; k < polygon.size(); ++k)
      triangle(polygon[0], polygon[k - 1], polygon[k], f, wrong);
  }

  /// The square of a polynomial of degree 2 in p and q, term by term: the integral of p^a q^b is a! b! / (a+b+2)!.
  template <class F>
  void triangle(const At<Q>& o, const At<Q>& a, const At<Q>& b, F f, Fault wrong) {
    const Q area = doubled(o, a, b);
    if (area == 0) return;
    const Q f0 = f(o), fa = f(a), fb = f(b), ma = f(halfway(o, a)), mb = f(halfway(o, b)),
            mab = f(halfway(a, b));
    const Q p = 4 * ma - 3 * f0 - fa, pp = 2 * f0 + 2 * fa - 4 * ma, q = 4 * mb - 3 * f0 - fb,
            qq = 2 * f0 + 2 * fb - 4 * mb;
    const Q pq = 4 * (mab - f0) - 2 * (p + q) - (pp + qq);
    const std::array<std::pair<std::array<int, 2>, Q>, 6> terms{
        {{{0, 0}, f0}, {{1, 0}, p}, {{0, 1}, q}, {{2, 0}, pp}, {{0, 2}, qq}, {{1, 1}, pq}}};
    const auto factorial = [](int k) {
      std::int64_t product = 1;
      for (; k > 1; --k) product *= k;
      return product;
    };
    if (wrong == error_square_by_middles) {
      square += area * (ma * ma + mb * mb + mab * mab) * ratio<Q>(1, 3);
      return;
    }
    Q sum(0);
    for (const auto& [x, c] : terms)
      for (const auto& [y, d] : terms) {
        const int i = x[0] + y[0], j = x[1] + y[1];
        sum += c * d * ratio<Q>(factorial(i) * factorial(j), factorial(i + j + 2));
      }
    square += 2 * area * sum;
  }
};

template <class Q>
ChannelError channel_error(const BakeCase& one, Level n, MapForm form, const std::vector<Rgba>& map,
                           std::size_t c, Fault wrong) {
  const Picture& p = one.picture;
  const Meaning as_stored = p.meaning == Meaning::srgb ? Meaning::srgb : Meaning::linear;
  const auto number = [&](std::uint8_t code) { return number_of<Q>(as_stored, c, code, wrong); };
  const auto base = base_of<Q>(one, wrong);
  Judged<Q> judged;
  const std::uint32_t count = 1u << 2 * n;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (wrong == error_skips_the_last_face && count > 1 && k + 1 == count) continue;
    const MicroTriangle t = face_of(proofs::attribute::FaceOrder::curve, n, k, none);
    const auto corners = face_corners(t);
    std::array<Q, 3> shown;
    for (std::size_t v = 0; v < 3; ++v)
      shown[v] = number(form == MapForm::faces
                            ? map[k][c]
                            : map[index_of(proofs::attribute::VertexOrder::w_minor, n, corners[v], none)][c]);
    std::array<At<Q>, 3> places;
    for (std::size_t v = 0; v < 3; ++v) places[v] = place_of(base, n, corners[v]);
    if (wrong == error_turns_upper && t.upper && form == MapForm::vertices) std::swap(shown[1], shown[2]);
    const Patch<Q> patch(places, ratio<Q>(1, 2));
    patch.squares([&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) {
      const auto at_texel = [&](std::int64_t di, std::int64_t dj) {
        return number(texel(p, i + di, j + dj, wrong)[c]);
      };
      const Q a = at_texel(0, 0), b = at_texel(1, 0), d = at_texel(0, 1), e = at_texel(1, 1);
      judged.part(
          part,
          [&](const At<Q>& at) {
            const Q x = patch.x(at) - ratio<Q>(i, 1), y = patch.y(at) - ratio<Q>(j, 1);
            const Q texture = a + x * (b - a) + y * (d - a) + x * y * (a - b - d + e);
            return Q(texture - shown[0] - at.x * (shown[1] - shown[0]) - at.y * (shown[2] - shown[0]));
          },
          wrong);
    });
  }
  Rational square = wide(judged.square) / Rational(count);
  if (wrong == error_mean_over_one_more) square = wide(judged.square) / Rational(count + (count > 4 ? 1 : 0));
  return {wide(judged.largest), square};
}

}  // namespace

proofs::attribute::Baking baking_with(Fault wrong) {
  Baking f;
  f.vertices = [=](const BakeCase& one, Level n) { return vertices(one, n, wrong); };
  f.faces = [=](const BakeCase& one, Level n) { return faces(one, n, wrong); };
  f.face_mean = [=](const BakeCase& one, Level n, std::size_t channel, std::uint32_t index) {
    return face_mean(one, n, channel, index, wrong);
  };
  f.error = [=](const BakeCase& one, Level n, MapForm form, const std::vector<Rgba>& map) {
    std::array<ChannelError, 4> error;
    for (std::size_t c = 0; c < 4; ++c)
      error[c] = exact([&](auto q) { return channel_error<decltype(q)>(one, n, form, map, c, wrong); });
    return error;
  };
  f.light = [=](std::uint32_t m) { return light_at(m, wrong); };
  f.plan = [=](const proofs::attribute::PlanCase& one) { return planned(one, wrong); };
  return f;
}

}  // namespace mmverify::tests::foreign::attribute
