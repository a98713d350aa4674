#include "bench/attribute/bake.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "bench/attribute/clipped.hpp"
#include "bench/timing.hpp"
#include "impl/attribute/bake.hpp"
#include "impl/attribute/bake/codes.hpp"
#include "impl/bake/texture/wrap.hpp"
#include "impl/index/index.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::attribute;
using fast::BaseTriangle;
using fast::Rgba;

struct Texture {
  std::uint32_t side;
  std::vector<Rgba> texels;

  fast::RgbaView view() const { return {texels.data()->data(), side, side, side}; }
  const Rgba& at(std::int64_t x, std::int64_t y) const {
    const auto in = [&](std::int64_t k) {
      return static_cast<std::size_t>(impl::bake::detail::modulo(k, side));
    };
    return texels[in(x) + in(y)*side];
  }
};

/// A texture of waves and grain, so that neighbours are alike and no code is missing.
Texture generated(std::uint32_t side, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Texture t{side, std::vector<Rgba>(std::size_t{side} * side)};
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const double wave = std::sin(0.05 * x * static_cast<double>(c + 1)) + std::cos(0.03 * y);
        t.texels[x + std::size_t{y} * side][c] =
            static_cast<std::uint8_t>(120 + 55 * wave + static_cast<double>(random() % 16));
      }
  return t;
}

/// A mesh of both halves of uneven squares, within the texture.
std::vector<BaseTriangle> mesh(const AttributeBakeOptions& o) {
  std::mt19937_64 random(o.seed + 1);
  const std::uint32_t squares = o.texels / o.triangle - 1;
  const auto uneven = [&] { return (static_cast<double>(random() % 4096) / 4096 - 0.5) * 0.4; };
  std::vector<fast::TexturePoint> points;
  for (std::uint32_t y = 0; y <= squares; ++y)
    for (std::uint32_t x = 0; x <= squares; ++x)
      points.push_back({static_cast<float>((0.5 + x + uneven()) * o.triangle / o.texels),
                        static_cast<float>((0.5 + y + uneven()) * o.triangle / o.texels)});
  std::vector<BaseTriangle> triangles;
  for (std::uint32_t y = 0; y < squares; ++y)
    for (std::uint32_t x = 0; x < squares; ++x) {
      const std::size_t k = x + std::size_t{y} * (squares + 1), below = k + squares + 1;
      triangles.push_back({points[k], points[k + 1], points[below]});
      triangles.push_back({points[below + 1], points[below], points[k + 1]});
    }
  if (triangles.size() > o.triangles) triangles.resize(o.triangles);
  return triangles;
}

using Curves = fast::detail::Curves;
Rgba rounded(const std::array<double, 4>& mean, const Curves& curves) {
  Rgba codes;
  bool sure = true;
  for (std::size_t c = 0; c < 4; ++c) codes[c] = curves[c]->code(mean[c], 0, sure);
  return codes;
}

/// The obvious face bakers.
class Obvious {
 public:
  Obvious(const Texture& t, const Curves& curves) : t_(t), curves_(curves) {}

  void faces(const BaseTriangle& uv, std::uint32_t level, bool clip, std::vector<Rgba>& out) {
    for (std::uint32_t k = 0; k < out.size(); ++k) {
      const auto corners = impl::index::corners(k, level);
      std::array<Point2, 3> p;
      for (std::size_t c = 0; c < 3; ++c) p[c] = place(uv, level, corners[c].i, corners[c].j);
      out[k] = clip ? clipped(p) : centres(p);
    }
  }

  void vertices(const BaseTriangle& uv, std::uint32_t level, std::vector<Rgba>& out) const {
    const auto side = static_cast<float>(1u << level), size = static_cast<float>(t_.side);
    std::size_t k = 0;
    for (std::uint32_t r = 0; r <= 1u << level; ++r)
      for (std::uint32_t j = 0; j <= r; ++j, ++k) {
        const float s = static_cast<float>(r - j) / side, t = static_cast<float>(j) / side;
        const float x = (uv[0].u + (uv[1].u - uv[0].u) * s + (uv[2].u - uv[0].u) * t) * size - 0.5f,
                    y = (uv[0].v + (uv[1].v - uv[0].v) * s + (uv[2].v - uv[0].v) * t) * size - 0.5f;
        const float left = std::floor(x), top = std::floor(y), f = x - left, h = y - top;
        const auto i = static_cast<std::int64_t>(left), l = static_cast<std::int64_t>(top);
        const Rgba &a = t_.at(i, l), &b = t_.at(i + 1, l), &c = t_.at(i, l + 1), &d = t_.at(i + 1, l + 1);
        std::array<double, 4> value;
        for (std::size_t m = 0; m < 4; ++m) {
          const auto number = [&](const Rgba& texel) {
            return static_cast<float>(curves_[m]->number[texel[m]]);
          };
          const float above = number(a) + f * (number(b) - number(a)),
                      below = number(c) + f * (number(d) - number(c));
          value[m] = double{above + h * (below - above)};
        }
        out[k] = rounded(value, curves_);
      }
  }

 private:
  Point2 place(const BaseTriangle& uv, std::uint32_t level, std::uint32_t i, std::uint32_t j) const {
    const double side = 1u << level, s = i / side, t = j / side;
    return {(uv[0].u + s * (double{uv[1].u} - uv[0].u) + t * (double{uv[2].u} - uv[0].u)) * t_.side,
            (uv[0].v + s * (double{uv[1].v} - uv[0].v) + t * (double{uv[2].v} - uv[0].v)) * t_.side};
  }

  void add(std::int64_t x, std::int64_t y, double weight, std::array<double, 4>& sum) const {
    const Rgba& texel = t_.at(x, y);
    for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * curves_[c]->number[texel[c]];
  }
  Rgba mean(std::array<double, 4> sum, double weight) const {
    for (double& s : sum) s /= weight;
    return rounded(sum, curves_);
  }

  Rgba clipped(const std::array<Point2, 3>& p) {
    std::array<double, 4> sum{};
    double all = 0;
    clipping_.each_area(p, [&](std::int64_t x, std::int64_t y, double area) {
      all += area;
      add(x, y, area, sum);
    });
    return mean(sum, all);
  }

  Rgba centres(const std::array<Point2, 3>& p) const {
    std::array<double, 4> sum{};
    double count = 0;
    each_texel(p, [&](std::int64_t x, std::int64_t y) {
      const double cx = static_cast<double>(x) + 0.5, cy = static_cast<double>(y) + 0.5;
      bool left = true, right = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point2 &a = p[k], &b = p[(k + 1) % 3];
        const double side = (b.x - a.x) * (cy - a.y) - (b.y - a.y) * (cx - a.x);
        left = left && side >= 0;
        right = right && side <= 0;
      }
      if (!left && !right) return;
      ++count;
      add(x, y, 1, sum);
    });
    if (count == 0) {
      add(static_cast<std::int64_t>(std::floor((p[0].x + p[1].x + p[2].x) / 3)),
          static_cast<std::int64_t>(std::floor((p[0].y + p[1].y + p[2].y) / 3)), 1, sum);
      count = 1;
    }
    return mean(sum, count);
  }

  const Texture& t_;
  const Curves& curves_;
  Clipping clipping_ = {};
};

std::uint64_t differing(const std::vector<Rgba>& a, const std::vector<Rgba>& b) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) count += a[k] != b[k] ? 1 : 0;
  return count;
}

AttributeBakeLevel measured(const Texture& texture, const std::vector<BaseTriangle>& triangles,
                            std::uint32_t level, bool srgb, std::size_t rounds) {
  constexpr std::size_t slow_share = 8;  // of the triangles, the obvious ways bake every eighth
  AttributeBakeLevel result;
  result.level = level;
  result.srgb = srgb;
  fast::AttributeSampling sampling;
  sampling.meaning = srgb ? fast::Meaning::srgb : fast::Meaning::linear;
  const fast::AttributeBaker baker(texture.view(), sampling);
  const Curves curves = fast::detail::curves_of(sampling.meaning);
  Obvious obvious(texture, curves);
  const std::size_t side = std::size_t{1} << level;
  std::vector<Rgba> faces(side * side), vertices((side + 1) * (side + 2) / 2), other;
  std::uint64_t exact = 0, values = 0;
  const auto way = [&](AttributeBakeWay w) -> AttributeWay& {
    return result.by[static_cast<std::size_t>(w)];
  };
  const auto all = [&](AttributeBakeWay w, std::size_t each, auto bake) {
    way(w).ns = median_ns(rounds,
                          [&] {
                            for (const BaseTriangle& uv : triangles) bake(uv);
                          }) /
                static_cast<double>(each * triangles.size());
  };
  all(AttributeBakeWay::faces, faces.size(), [&](const BaseTriangle& uv) {
    const auto counts = baker.faces(uv, level, faces);
    exact += counts.exact;
    values += counts.values;
  });
  all(AttributeBakeWay::vertices, vertices.size(), [&](const BaseTriangle& uv) {
    const auto counts = baker.vertices(uv, level, vertices);
    exact += counts.exact;
    values += counts.values;
  });
  result.exact = static_cast<double>(exact) / static_cast<double>(values);
  const auto beside = [&](AttributeBakeWay w, const std::vector<Rgba>& right, auto bake) {
    other.resize(right.size());
    way(w).ns += once_ns([&] { bake(other); });
    way(w).wrong += differing(right, other);
  };
  for (std::size_t t = 0; t < triangles.size(); t += slow_share) {
    const BaseTriangle& uv = triangles[t];
    baker.faces(uv, level, faces);
    baker.vertices(uv, level, vertices);
    beside(AttributeBakeWay::clipped, faces, [&](auto& to) { obvious.faces(uv, level, true, to); });
    beside(AttributeBakeWay::centres, faces, [&](auto& to) { obvious.faces(uv, level, false, to); });
    beside(AttributeBakeWay::binary32, vertices, [&](auto& to) { obvious.vertices(uv, level, to); });
    result.face_values += faces.size();
    result.vertex_values += vertices.size();
  }
  way(AttributeBakeWay::clipped).ns /= static_cast<double>(result.face_values);
  way(AttributeBakeWay::centres).ns /= static_cast<double>(result.face_values);
  way(AttributeBakeWay::binary32).ns /= static_cast<double>(result.vertex_values);
  return result;
}

}  // namespace

const char* to_string(AttributeBakeWay way) {
  constexpr const char* names[] = {"faces, ours", "faces, clipped in binary64", "faces, centres inside",
                                   "vertices, ours", "vertices, binary32"};
  return names[static_cast<std::size_t>(way)];
}

std::vector<AttributeBakeLevel> attribute_bake_figures(const AttributeBakeOptions& o) {
  if (o.rounds == 0 || o.triangles == 0 || o.first > o.last || o.last > 8 || o.triangle < 4 ||
      o.texels > 8192 || 2 * o.triangle >= o.texels)
    throw std::invalid_argument(
        "attribute bench: a round and a triangle at least, levels up to 8, triangles smaller than half of a "
        "texture of up to 8192 texels a side");
  if (o.progress) o.progress("generating a texture");
  const Texture texture = generated(o.texels, o.seed);
  const std::vector<BaseTriangle> triangles = mesh(o);
  std::vector<AttributeBakeLevel> levels;
  for (std::uint32_t level = o.first; level <= o.last; ++level)
    for (const bool srgb : {false, true}) {
      if (o.progress) o.progress("baking at level " + std::to_string(level) + (srgb ? ", sRGB" : ""));
      levels.push_back(measured(texture, triangles, level, srgb, o.rounds));
    }
  return levels;
}

}  // namespace mmverify::bench
