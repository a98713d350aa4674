#include "scene/attribute/baker.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "impl/index/index.hpp"
#include "scene/plan/plan.hpp"

// A stand-in: plain binary64, a texel at a time.
namespace mmverify::scene {
namespace {

using Mean = CodeMeaning::Mean;
using MapPoint = std::array<double, 2>;

double light_of(double code) {
  const double c = code / 255;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint32_t wrapped(std::int64_t x, std::uint32_t side, Wrap wrap) {
  const std::int64_t n = side;
  if (wrap == Wrap::clamp_to_edge) return static_cast<std::uint32_t>(std::clamp<std::int64_t>(x, 0, n - 1));
  const std::int64_t period = wrap == Wrap::repeat ? n : 2 * n;
  const std::int64_t r = (x % period + period) % period;
  return static_cast<std::uint32_t>(r < n ? r : period - 1 - r);
}

/// The part of a convex polygon where sign (p[axis] - at) >= 0.
void clip(std::vector<MapPoint>& polygon, std::vector<MapPoint>& room, std::size_t axis, double at,
          double sign) {
  room.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const MapPoint &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double a = sign * (p[axis] - at), b = sign * (q[axis] - at);
    if (a >= 0) room.push_back(p);
    if ((a < 0) != (b < 0)) {
      const double t = a / (a - b);
      MapPoint middle{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
      middle[axis] = at;
      room.push_back(middle);
    }
  }
  polygon.swap(room);
}

double area_of(const std::vector<MapPoint>& polygon) {
  double twice = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    twice += (polygon[k - 1][0] - polygon[0][0]) * (polygon[k][1] - polygon[0][1]) -
             (polygon[k][0] - polygon[0][0]) * (polygon[k - 1][1] - polygon[0][1]);
  return std::abs(twice) / 2;
}

void add(Mean& sum, const Mean& value, double weight) {
  for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * value[c];
}

/// (i, j) of a map in texels.
MapPoint at_vertex(const TexelTriangle& corners, double i, double j, double n) {
  MapPoint p;
  for (std::size_t k = 0; k < 2; ++k)
    p[k] =
        corners[0][k] + (corners[1][k] - corners[0][k]) * (i / n) + (corners[2][k] - corners[0][k]) * (j / n);
  return p;
}

}  // namespace

CodeMeaning::CodeMeaning(AttributeSet set, Averaging averaging)
    : light_(averaging == Averaging::meaning && is_srgb(set)),
      directions_(averaging == Averaging::meaning && has(set, Attribute::normal)),
      channels_(channels_of(set)) {
  for (std::size_t code = 0; code < 256; ++code) {
    const auto c = static_cast<double>(code);
    table_[code] = light_ ? light_of(c) : c / 255;
    thresholds_[code] = light_ ? light_of(c + 0.5) : (c + 0.5) / 255;
  }
}

Mean CodeMeaning::mean_of(const MapValue& value) const {
  Mean mean{};
  for (std::size_t c = 0; c < 3; ++c)
    if ((channels_ >> c & 1) != 0) mean[c] = directions_ ? 2 * table_[value[c]] - 1 : table_[value[c]];
  return mean;
}

MapValue CodeMeaning::code_of(Mean mean) const {
  if (directions_) {
    const double length = std::hypot(mean[0], mean[1], mean[2]);
    // Opposite directions leave none: the surface's own.
    if (length < 1e-9)
      mean = {0, 0, 1};
    else
      for (double& c : mean) c /= length;
    for (double& c : mean) c = (c + 1) / 2;
  }
  MapValue value{};
  for (std::size_t c = 0; c < 3; ++c) {
    if ((channels_ >> c & 1) == 0) continue;
    // The last threshold is above 1.
    const auto above = std::upper_bound(thresholds_.begin(), thresholds_.end() - 1, mean[c] + 1e-12);
    value[c] = static_cast<std::uint8_t>(above - thresholds_.begin());
  }
  return value;
}

std::size_t wrapped_texel(const ColourImage& image, const Sampler& sampler, std::int64_t x, std::int64_t y) {
  return wrapped(x, image.width, sampler.wrap_u) +
         std::size_t{wrapped(y, image.height, sampler.wrap_v)} * image.width;
}

MapBaker::MapBaker(const ColourImage& image, const AttributeTexture& texture, Averaging averaging)
    : image_(&image), texture_(texture), meaning_(texture.set, averaging) {}

Mean MapBaker::texel(std::int64_t x, std::int64_t y) const {
  const std::uint8_t* const rgba = image_->rgba.data() + 4 * wrapped_texel(*image_, texture_.sampler, x, y);
  return meaning_.mean_of({rgba[0], rgba[1], rgba[2], 0});
}

Mean MapBaker::sample(double x, double y) const {
  if (filter_of(texture_.sampler) == Filter::nearest)
    return texel(static_cast<std::int64_t>(std::floor(x)), static_cast<std::int64_t>(std::floor(y)));
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), a = x - 0.5 - left, b = y - 0.5 - top;
  const auto i = static_cast<std::int64_t>(left), j = static_cast<std::int64_t>(top);
  Mean sum{};
  add(sum, texel(i, j), (1 - a) * (1 - b));
  if (a != 0) add(sum, texel(i + 1, j), a * (1 - b));
  if (b != 0) add(sum, texel(i, j + 1), (1 - a) * b);
  if (a != 0 && b != 0) add(sum, texel(i + 1, j + 1), a * b);
  return sum;
}

Mean MapBaker::face(const TexelTriangle& corners) const {
  const auto bounds = [&](std::size_t axis) {
    const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    return std::pair(static_cast<std::int64_t>(std::floor(least)),
                     static_cast<std::int64_t>(std::ceil(most)));
  };
  const auto [left, right] = bounds(0);
  const auto [top, bottom] = bounds(1);
  if (right - left <= 1 && bottom - top <= 1) return texel(left, top);
  thread_local std::vector<MapPoint> row, cell, rest, room;
  Mean sum{};
  double area = 0;
  rest.assign(corners.begin(), corners.end());
  for (std::int64_t j = top; j < bottom; ++j) {
    row = rest;
    clip(row, room, 1, static_cast<double>(j + 1), -1);
    clip(rest, room, 1, static_cast<double>(j + 1), 1);
    for (std::int64_t i = left; i < right && row.size() > 2; ++i) {
      cell = row;
      clip(cell, room, 0, static_cast<double>(i + 1), -1);
      clip(row, room, 0, static_cast<double>(i + 1), 1);
      if (const double share = area_of(cell); share > 0) {
        add(sum, texel(i, j), share);
        area += share;
      }
    }
  }
  if (area > 0) {
    for (double& c : sum) c /= area;
    return sum;
  }
  // No area: the texel of its middle.
  const auto middle = [&](std::size_t axis) {
    return static_cast<std::int64_t>(
        std::floor((corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3));
  };
  return texel(middle(0), middle(1));
}

void MapBaker::bake(const UvTriangle& uvs, MapKind kind, unsigned level, std::span<MapValue> out) const {
  for (const Uv& uv : uvs)
    if (!(std::abs(uv[0]) < 0x1p20f && std::abs(uv[1]) < 0x1p20f))
      throw std::invalid_argument("attribute map: UVs of 2^20 or more");
  if (level > finest_attribute_level || out.size() != values_of_map(kind, level))
    throw std::invalid_argument("attribute map: another number of values than the level has");
  const TexelTriangle corners = in_texels(uvs, image_->width, image_->height);
  const std::uint32_t n = std::uint32_t{1} << level;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return at_vertex(corners, i, j, n); };
  if (kind == MapKind::vertices) {
    for (std::uint32_t r = 0; r <= n; ++r)
      for (std::uint32_t j = 0; j <= r; ++j) {
        const MapPoint p = at(r - j, j);
        out[r * (r + 1) / 2 + j] = meaning_.code_of(sample(p[0], p[1]));
      }
    return;
  }
  for (std::uint32_t k = 0; k < out.size(); ++k) {
    const auto c = impl::index::corners(k, level);
    out[k] = meaning_.code_of(face({at(c[0].i, c[0].j), at(c[1].i, c[1].j), at(c[2].i, c[2].j)}));
  }
}

}  // namespace mmverify::scene
