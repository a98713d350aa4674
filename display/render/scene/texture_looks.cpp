#include "display/render/scene/texture_looks.hpp"

#include <algorithm>
#include <cmath>

#include "scene/attribute/atlas.hpp"
#include "scene/attribute/map_reading.hpp"
#include "scene/attribute/mip_errors.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::render {
namespace {

using Mean = scene::CodeMeaning::Mean;

Vector edge(const Point& from, const Point& to) {
  return {double{to[0]} - from[0], double{to[1]} - from[1], double{to[2]} - from[2]};
}

/// The texture at (u, v) as its sampler filters it, mip level 0, in the quantities that are averaged.
Mean sampled(const scene::ColourImage& image, const scene::Sampler& sampler,
             const scene::CodeMeaning& meaning, double u, double v) {
  const auto texel = [&](std::int64_t x, std::int64_t y) {
    const std::size_t at = 4 * scene::wrapped_texel(image, sampler, x, y);
    return meaning.mean_of({image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]});
  };
  const double x = u * image.width, y = v * image.height;
  if (scene::filter_of(sampler) == scene::Filter::nearest)
    return texel(static_cast<std::int64_t>(std::floor(x)), static_cast<std::int64_t>(std::floor(y)));
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), fx = x - 0.5 - left, fy = y - 0.5 - top;
  const auto i = static_cast<std::int64_t>(left), j = static_cast<std::int64_t>(top);
  const Mean a = texel(i, j), b = texel(i + 1, j), c = texel(i, j + 1), d = texel(i + 1, j + 1);
  Mean mean{};
  for (std::size_t k = 0; k < 3; ++k)
    mean[k] = (1 - fy) * ((1 - fx) * a[k] + fx * b[k]) + fy * ((1 - fx) * c[k] + fx * d[k]);
  return mean;
}

}  // namespace

TextureLooks::TextureLooks(const scene::Scene& scene, const SceneWorld& world,
                           const scene::AttributeScene& attributes,
                           const std::vector<scene::PrimitiveShading>& shading)
    : world_(world.world), attributes_(attributes), of_(world.world.geometries.size()) {
  for (const scene::AttributeTexture& texture : attributes.textures)
    bakers_.push_back(std::make_unique<scene::MapBaker>(attributes.images[texture.image], texture,
                                                        scene::Averaging::meaning));
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const std::uint32_t geometry = world.geometry_of[k];
    if (geometry == SceneWorld::none) continue;
    const auto its_own = [&](const auto& p) {
      return p.mesh == scene.primitives[k].mesh && p.number == scene.primitives[k].number;
    };
    const auto textures = std::find_if(attributes.primitives.begin(), attributes.primitives.end(), its_own);
    if (textures != attributes.primitives.end()) of_[geometry].attributes = &*textures;
    const auto its = std::find_if(shading.begin(), shading.end(), its_own);
    if (its != shading.end()) of_[geometry].shading = &*its;
  }
}

TriangleLooks::TriangleLooks(const TextureLooks& looks, std::uint32_t geometry, std::uint32_t triangle,
                             ShownFrom from, unsigned level, bool with_mips)
    : from_(from), level_(level), first_level_(with_mips ? 0 : level), shading_(looks.of_[geometry].shading) {
  const Geometry& its = looks.world_.geometries[geometry];
  const auto& corners = its.triangles[triangle];
  const Vector e1 = edge(its.positions[corners[0]], its.positions[corners[1]]),
               e2 = edge(its.positions[corners[0]], its.positions[corners[2]]);
  of_triangle_.flat = {e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2],
                       e1[0] * e2[1] - e1[1] * e2[0]};
  if (shading_ != nullptr && !shading_->normals.empty()) {
    normals_.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
      const scene::Position& normal = shading_->normals[corners[k]];
      (*normals_)[k] = {normal[0], normal[1], normal[2]};
    }
  }
  if (looks.of_[geometry].attributes == nullptr) return;
  for (const scene::AttributeUse& use : looks.of_[geometry].attributes->uses) {
    const scene::AttributeTexture& texture = looks.attributes_.textures[use.texture];
    const scene::ColourImage& image = looks.attributes_.images[texture.image];
    const scene::UvTriangle uvs{use.uvs[corners[0]], use.uvs[corners[1]], use.uvs[corners[2]]};
    if (!scene::within_reach(uvs, image)) continue;
    uses_.push_back({&texture, &image, looks.bakers_[use.texture].get(), uvs, {}});
    Use& made = uses_.back();
    if (from != ShownFrom::textures) {
      const auto kind = from == ShownFrom::faces ? scene::MapKind::faces : scene::MapKind::vertices;
      std::vector<scene::MapValue> map(static_cast<std::size_t>(scene::values_of_map(kind, level)));
      made.baker->bake(uvs, kind, level, map);
      for (unsigned mip = first_level_; mip < level; ++mip)
        made.maps.push_back(scene::mip_of_map(map, kind, level, mip, made.baker->meaning()));
      made.maps.push_back(std::move(map));
    }
    if (!scene::has(texture.set, scene::Attribute::normal)) continue;
    const double u1 = double{uvs[1][0]} - uvs[0][0], v1 = double{uvs[1][1]} - uvs[0][1],
                 u2 = double{uvs[2][0]} - uvs[0][0], v2 = double{uvs[2][1]} - uvs[0][1];
    // Only the sign of the area counts, since directions may have any length.  v goes down the image, so `up`
    // is against it.
    const double area = u1 * v2 - u2 * v1, sign = area > 0 ? 1 : area < 0 ? -1 : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      of_triangle_.along[c] = sign * (v2 * e1[c] - v1 * e2[c]);
      of_triangle_.up[c] = -sign * (u1 * e2[c] - u2 * e1[c]);
    }
  }
}

Mean TriangleLooks::mean_at(const Use& use, const Barycentrics& point, unsigned level) const {
  const scene::CodeMeaning& meaning = use.baker->meaning();
  if (from_ != ShownFrom::textures) {
    const std::vector<scene::MapValue>& map = use.maps[level - first_level_];
    return from_ == ShownFrom::faces ? meaning.mean_of(map[scene::face_index(level, point.u, point.v)])
                                     : scene::vertex_mean(map, level, point.u, point.v, meaning);
  }
  const auto between = [&](std::size_t c) {
    return use.uvs[0][c] + point.u * (double{use.uvs[1][c]} - use.uvs[0][c]) +
           point.v * (double{use.uvs[2][c]} - use.uvs[0][c]);
  };
  return sampled(*use.image, use.texture->sampler, meaning, between(0), between(1));
}

Look TriangleLooks::at(const Barycentrics& point, const DetailLevel& detail) const {
  using scene::Attribute;
  Look look;
  look.colour = {1, 1, 1};
  look.metallic = look.roughness = 1;
  double normal_scale = 1, occlusion = 1;
  if (shading_ != nullptr) {
    look.colour = {shading_->colour[0], shading_->colour[1], shading_->colour[2]};
    look.metallic = shading_->metallic;
    look.roughness = shading_->roughness;
    normal_scale = shading_->normal_scale;
    occlusion = shading_->occlusion;
  }
  for (const Use& use : uses_) {
    Mean mean = mean_at(use, point, detail.level);
    if (detail.blend != 0) {
      const Mean finer = mean_at(use, point, detail.level + 1);
      for (std::size_t c = 0; c < mean.size(); ++c) mean[c] = std::lerp(mean[c], finer[c], detail.blend);
    }
    const scene::AttributeSet set = use.texture->set;
    if (scene::has(set, Attribute::base_color))
      for (std::size_t c = 0; c < 3; ++c) look.colour[c] *= mean[c];
    if (scene::has(set, Attribute::metallic_roughness)) {
      look.roughness *= mean[1];
      look.metallic *= mean[2];
    }
    if (scene::has(set, Attribute::occlusion)) look.occlusion = 1 + occlusion * (mean[0] - 1);
    if (scene::has(set, Attribute::normal))
      look.normal = {normal_scale * mean[0], normal_scale * mean[1], mean[2]};
  }
  return look;
}

TriangleLooks::Directions TriangleLooks::directions(const Barycentrics& point) const {
  Directions all = of_triangle_;
  all.normal = all.flat;
  if (normals_) {
    const double w = 1 - double{point.u} - point.v;
    for (std::size_t c = 0; c < 3; ++c)
      all.normal[c] = w * (*normals_)[0][c] + point.u * (*normals_)[1][c] + point.v * (*normals_)[2][c];
  }
  return all;
}

}  // namespace mmverify::render
