#include "scene/attribute/mip_errors.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "impl/attribute/mip.hpp"
#include "scene/attribute/atlas.hpp"
#include "scene/attribute/charts.hpp"
#include "scene/attribute/map_reading.hpp"
#include "scene/attribute/reduced_texture.hpp"
#include "scene/flip/flip.hpp"

namespace mmverify::scene {
namespace {

/// The values of the level below; each is the mean of four children.
std::vector<MapValue> parents(std::span<const MapValue> children, const CodeMeaning& meaning) {
  std::vector<MapValue> values;
  for (std::size_t k = 0; k < children.size(); k += 4) {
    CodeMeaning::Mean mean{};
    for (const MapValue& child : children.subspan(k, 4)) {
      const CodeMeaning::Mean one = meaning.mean_of(child);
      for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += one[c] / 4;
    }
    values.push_back(meaning.code_of(mean));
  }
  return values;
}

/// The root of a mean of squares; none without texels.
std::optional<double> rmse(double squares, std::uint64_t texels, int channels) {
  if (texels == 0) return {};
  return std::sqrt(squares / (static_cast<double>(texels) * channels));
}

double values_per_texel(std::uint64_t triangles, std::uint64_t texels, MapKind kind, unsigned level) {
  return static_cast<double>(triangles) * static_cast<double>(values_of_map(kind, level)) /
         static_cast<double>(std::max<std::uint64_t>(texels, 1));
}

}  // namespace

std::vector<MapValue> mip_of_map(std::span<const MapValue> map, MapKind kind, unsigned of, unsigned level,
                                 const CodeMeaning& meaning) {
  std::vector<MapValue> values;
  if (kind == MapKind::faces) {
    values.assign(map.begin(), map.end());
    for (; of > level; --of) values = parents(values, meaning);
    return values;
  }
  for (std::uint32_t k = 0; k < values_of_map(kind, level); ++k)
    values.push_back(
        map[impl::attribute::vertex_mip_source(impl::attribute::VertexOrder::w_minor, k, level, of)]);
  return values;
}

void MipErrors::take(const AttributeAtlas& atlas) {
  std::vector<UvTriangle> uvs;
  const SetTriangles& triangles = atlas.faces.triangles;
  const ImageTriangles& of_image = atlas.compared.triangles;
  for (const std::size_t triangle : of_image.maps) uvs.push_back(triangles.all()[triangle].uvs);
  std::vector<std::uint32_t> charts = charts_of(uvs), of_texel;
  for (const std::uint32_t triangle : of_image.first)
    of_texel.push_back(triangle == no_triangle ? no_chart : charts[triangle]);
  const ColourImage& image = atlas.image;
  const std::vector<std::uint8_t> bands = bands_of(of_texel, image.width, image.height, steps_ - 1);
  SetSums& sums = sums_[triangles.set()];
  const Bands none(steps_ + 1);
  sums.triangles += of_image.maps.size();
  sums.texels.resize(none.size());
  sums.texture.resize(steps_, none);
  for (std::vector<Bands>& levels : sums.by_level) levels.resize(steps_, none);
  for (const std::uint8_t band : bands)
    if (band != no_band) ++sums.texels[band];
  std::vector<ShownMip> texture = mips_of(atlas), faces = maps_of(atlas, atlas.faces),
                        vertices = maps_of(atlas, atlas.vertices);
  for (unsigned k = 0; k < steps_; ++k) {
    add(atlas, bands, texture[k], sums.texture[k]);
    add(atlas, bands, faces[k], sums.by_level[static_cast<std::size_t>(MapKind::faces)][k]);
    add(atlas, bands, vertices[k], sums.by_level[static_cast<std::size_t>(MapKind::vertices)][k]);
  }
  if (!picture_ || !is_srgb(triangles.set())) return;
  const auto texels =
      bands.size() - static_cast<std::size_t>(std::count(bands.begin(), bands.end(), no_band));
  const auto place = [&](MapKind kind, unsigned mip) {
    return nearest_level(of_image.maps.size(), texels, kind, mip) - options_.first;
  };
  for (unsigned mip = 0; mip < steps_; ++mip)
    picture_({image, triangles.set(), mip, bands, texture[mip], faces[place(MapKind::faces, mip)],
              vertices[place(MapKind::vertices, mip)]});
}

std::vector<ShownMip> MipErrors::mips_of(const AttributeAtlas& atlas) const {
  const CodeMeaning& meaning = atlas.faces.triangles.meaning();
  const RgbTexels whole{atlas.image.width, atlas.image.height, atlas.compared.original};
  std::vector<ShownMip> mips{{whole.rgb, {}}};
  for (unsigned mip = 1; mip < steps_; ++mip) {
    if (options_.stop) options_.stop();
    const std::uint32_t side = std::uint32_t{1} << mip;
    mips.push_back({enlarged(reduced(whole, side, meaning), side, whole.width, whole.height, meaning), {}});
  }
  return mips;
}

std::vector<ShownMip> MipErrors::maps_of(const AttributeAtlas& atlas, const SetMaps& maps) const {
  const SetTriangles& triangles = maps.triangles;
  const ImageTriangles& of_image = atlas.compared.triangles;
  std::vector<ShownMip> levels(steps_, {atlas.compared.original, {}});
  oneapi::tbb::parallel_for(std::size_t{0}, of_image.maps.size(), [&](std::size_t k) {
    // A triangle without texels of its own paints none, such as one at the place of an earlier one.
    if (of_image.begin[k] == of_image.begin[k + 1]) return;
    if (options_.stop) options_.stop();
    std::vector<MapValue> space;
    const std::span<const MapValue> map = maps.maps.map(maps.number[of_image.maps[k]], space);
    std::vector<MapValue> values(map.begin(), map.end());
    for (unsigned level = options_.last, above = level;; above = level, --level) {
      values = mip_of_map(values, maps.kind, above, level, triangles.meaning());
      std::vector<std::uint8_t>& rgb = levels[level - options_.first].rgb;
      for_each_own_texel(of_image, k, [&](std::size_t texel, double u, double v) {
        paint(rgb, texel,
              maps.kind == MapKind::faces
                  ? values[face_index(level, u, v)]
                  : vertex_value(values, level, u, v, MapReading::interpolated, triangles.meaning()),
              triangles.channels());
      });
      if (level == options_.first) break;
    }
  });
  return levels;
}

void MipErrors::add(const AttributeAtlas& atlas, std::span<const std::uint8_t> bands, ShownMip& shown,
                    Bands& sums) const {
  if (options_.stop) options_.stop();
  const AttributeSet set = atlas.faces.triangles.set();
  const std::uint8_t channels = channels_of(set);
  const std::vector<std::uint8_t>& original = atlas.compared.original;
  for (std::size_t texel = 0; texel < bands.size(); ++texel)
    for (std::size_t c = 0; c < 3 && bands[texel] != no_band; ++c) {
      if ((channels >> c & 1) == 0) continue;
      const double difference = shown.rgb[3 * texel + c] - original[3 * texel + c];
      sums[bands[texel]].squares += difference * difference;
    }
  if (!is_srgb(set)) return;
  const ColourImage& image = atlas.image;
  shown.errors = flip::error_map({image.width, image.height, original},
                                 {image.width, image.height, shown.rgb}, {.threads = options_.threads});
  for (std::size_t texel = 0; texel < bands.size(); ++texel)
    if (bands[texel] != no_band) sums[bands[texel]].flip += shown.errors[texel];
}

MipError MipErrors::error_of(AttributeSet set, const SetSums& sums, const Bands& bands, unsigned mip) const {
  BandSums border, interior;
  std::uint64_t border_texels = 0, interior_texels = 0;
  for (unsigned band = 0; band < bands.size(); ++band) {
    BandSums& part = band <= mip ? border : interior;
    part.squares += bands[band].squares;
    part.flip += bands[band].flip;
    (band <= mip ? border_texels : interior_texels) += sums.texels[band];
  }
  const int channels = std::popcount(channels_of(set));
  const std::uint64_t texels = border_texels + interior_texels;
  MipError error;
  error.all.rmse = rmse(border.squares + interior.squares, texels, channels);
  if (is_srgb(set) && texels != 0)
    error.all.flip = (border.flip + interior.flip) / static_cast<double>(texels);
  error.border = rmse(border.squares, border_texels, channels);
  error.interior = rmse(interior.squares, interior_texels, channels);
  return error;
}

unsigned MipErrors::nearest_level(std::uint64_t triangles, std::uint64_t texels, MapKind kind,
                                  unsigned mip) const {
  const auto apart = [&](unsigned level) {
    return std::abs(std::log2(values_per_texel(triangles, texels, kind, level)) + 2.0 * mip);
  };
  unsigned nearest = options_.last;
  for (unsigned level = options_.first; level < options_.last && triangles != 0; ++level)
    if (apart(level) < apart(nearest)) nearest = level;
  return nearest;
}

MipOfMaps MipErrors::maps_beside(AttributeSet set, const SetSums& sums, MapKind kind, unsigned mip) const {
  const std::uint64_t texels = std::accumulate(sums.texels.begin(), sums.texels.end(), std::uint64_t{0});
  const unsigned level = nearest_level(sums.triangles, texels, kind, mip);
  const Bands& bands = sums.by_level[static_cast<std::size_t>(kind)][level - options_.first];
  return {level, values_per_texel(sums.triangles, texels, kind, level), error_of(set, sums, bands, mip)};
}

std::vector<MipStep> MipErrors::steps() const {
  std::vector<MipStep> steps;
  for (const auto& [set, sums] : sums_) {
    const auto all = std::accumulate(sums.texels.begin(), sums.texels.end(), std::uint64_t{0});
    for (unsigned mip = 0; mip < steps_ && all != 0; ++mip) {
      const auto near = std::accumulate(sums.texels.begin(), sums.texels.begin() + mip + 1, std::uint64_t{0});
      steps.push_back({set, mip, static_cast<double>(near) / static_cast<double>(all),
                       error_of(set, sums, sums.texture[mip], mip),
                       maps_beside(set, sums, MapKind::faces, mip),
                       maps_beside(set, sums, MapKind::vertices, mip)});
    }
  }
  return steps;
}

}  // namespace mmverify::scene
