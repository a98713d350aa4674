#include "scene/plan/plan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mmverify::scene {
namespace {

bool same_texture(const std::optional<BaseColorTexture>& a, const std::optional<BaseColorTexture>& b) {
  if (!a || !b) return !a && !b;
  return a->image == b->image && a->uv_set == b->uv_set && a->sampler == b->sampler &&
         a->transform == b->transform;
}

bool same_alpha(const Material& a, const Material& b) {
  if (a.mode != b.mode) return false;
  if (a.mode == AlphaMode::opaque) return true;
  return (a.mode == AlphaMode::blend || a.cutoff == b.cutoff) && a.base_color_alpha == b.base_color_alpha &&
         a.specular_glossiness == b.specular_glossiness && same_texture(a.texture, b.texture);
}

bool varies(const Primitive& primitive) {
  return primitive.vertex_alpha && primitive.vertex_alpha->least != primitive.vertex_alpha->greatest;
}

bool any_placed(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                     [](const Mesh& mesh) { return mesh.uses != 0; });
}

/// Whether an animation moves a primitive's UVs, by known ranges, and changes nothing else, in any variant.
bool only_moves(const Scene& scene, const Primitive& primitive) {
  const Material& material = scene.material_of(primitive);
  return primitive.moving_uvs &&
         std::all_of(primitive.variants.begin(), primitive.variants.end(),
                     [&](const VariantMaterial& variant) {
                       return scene.materials[variant.material].moving == material.moving;
                     });
}

bool is_animated(const Scene& scene, const Primitive& primitive) {
  return !scene.material_of(primitive).animated.empty() ||
         std::any_of(primitive.variants.begin(), primitive.variants.end(),
                     [&](const VariantMaterial& variant) {
                       return !scene.materials[variant.material].animated.empty();
                     });
}

/// The reason why a primitive is left out; of several, the one that the scene's author would have to change
/// first.
std::optional<LeftOut> left_out(const Scene& scene, const Primitive& primitive, bool mesh_may_be_unplaced,
                                MovingTextures moving) {
  const Material& material = scene.material_of(primitive);
  if (primitive.triangles.empty()) return LeftOut::no_triangles;
  if (!mesh_may_be_unplaced && scene.meshes[primitive.mesh].uses == 0) return LeftOut::not_placed;
  for (const VariantMaterial& variant : primitive.variants)
    if (!same_alpha(scene.materials[variant.material], material)) return LeftOut::material_variants;
  // alphaMode is no target of animations: opaque stays opaque.
  if (material.mode == AlphaMode::opaque) return LeftOut::opaque;
  const bool moves = moving == MovingTextures::planned && only_moves(scene, primitive) && !varies(primitive);
  if (is_animated(scene, primitive) && !moves) return LeftOut::animated;
  if (material.specular_glossiness) return LeftOut::specular_glossiness;
  if (!material.texture) return LeftOut::no_texture;
  if (!material.texture->image) return LeftOut::no_image;
  if (primitive.uvs.empty()) return LeftOut::no_uvs;
  if (primitive.morphs_uvs) return LeftOut::morphed_uvs;
  if (primitive.vertex_alpha && (primitive.vertex_alpha->least < 0 || primitive.vertex_alpha->greatest > 1))
    return LeftOut::vertex_alpha;
  const Sampler& sampler = material.texture->sampler;
  if (sampler.magnification && sampler.minification && sampler.magnification != sampler.minification)
    return LeftOut::two_filters;
  const std::vector<Uv>& uvs = moves ? primitive.moving_uvs->middles : primitive.uvs;
  const auto far = [](float x) { return !(std::fabs(x) < 0x1p20f); };
  for (const Triangle& triangle : primitive.triangles)
    for (const std::uint32_t vertex : triangle)
      if (far(uvs[vertex][0]) || far(uvs[vertex][1])) return LeftOut::far_uvs;
  if (moves && (far(primitive.moving_uvs->travel[0]) || far(primitive.moving_uvs->travel[1])))
    return LeftOut::far_uvs;
  return {};
}

/// Domain: a primitive that is not left out.
Surface surface_of(const Scene& scene, const Primitive& primitive) {
  const Material& material = scene.material_of(primitive);
  Surface surface;
  surface.image = *material.texture->image;
  surface.sampler = material.texture->sampler;
  surface.mode = material.mode;
  if (material.mode == AlphaMode::mask) surface.cutoff = material.cutoff;
  surface.base_color_alpha = material.base_color_alpha;
  if (primitive.vertex_alpha && !varies(primitive)) surface.vertex_alpha = primitive.vertex_alpha->least;
  if (is_animated(scene, primitive)) surface.travel = primitive.moving_uvs->travel;
  return surface;
}

class Planner {
 public:
  Planner(const Scene& scene, unsigned level_limit, VaryingAlpha varying, MovingTextures moving)
      : scene_(scene), level_limit_(level_limit), varying_(varying), moving_(moving) {}

  Plan planned() {
    const bool all_unplaced = !any_placed(scene_);
    for (std::size_t k = 0; k < scene_.primitives.size(); ++k)
      if (const auto why = left_out(scene_, scene_.primitives[k], all_unplaced, moving_))
        plan_.left_out.push_back({k, *why});
      else if (varying_ == VaryingAlpha::left_out && varies(scene_.primitives[k]))
        plan_.left_out.push_back({k, LeftOut::varying_alpha});
      else
        add(k);
    return std::move(plan_);
  }

 private:
  /// A linear search is enough, since surfaces are as few as materials.
  std::uint32_t number_of(const Surface& surface) {
    const auto found = std::find(plan_.surfaces.begin(), plan_.surfaces.end(), surface);
    if (found == plan_.surfaces.end()) {
      plan_.surfaces.push_back(surface);
      return static_cast<std::uint32_t>(plan_.surfaces.size() - 1);
    }
    return static_cast<std::uint32_t>(found - plan_.surfaces.begin());
  }

  void add(std::size_t index) {
    const Primitive& primitive = scene_.primitives[index];
    const Surface surface = surface_of(scene_, primitive);
    const Image& image = scene_.images.at(surface.image);
    if (!image.decoded()) throw std::invalid_argument("plan: image " + image.name + " is not decoded");
    PlannedPrimitive planned{index, number_of(surface), {}};
    const std::vector<Uv>& all_uvs = planned_uvs(primitive, surface);
    planned.triangles.reserve(primitive.triangles.size());
    for (const Triangle& triangle : primitive.triangles) {
      const UvTriangle uvs{all_uvs[triangle[0]], all_uvs[triangle[1]], all_uvs[triangle[2]]};
      const CornerAlphas alphas = corner_alphas(primitive, triangle);
      const auto found = duplicates_.add(planned.surface, uvs, periods(surface.sampler), alphas);
      if (found.is_new) {
        impl::bake::BaseTriangle base;
        for (std::size_t k = 0; k < 3; ++k) base[k] = {uvs[k][0], uvs[k][1]};
        plan_.triangles.push_back({planned.surface, uvs, alphas, in_texels(uvs, image.width, image.height),
                                   uv_shape(uvs), useful_level(base, image.width, image.height, level_limit_),
                                   0, 0});
      }
      PlannedTriangle& distinct = plan_.triangles[found.number];
      distinct.unique += 1;
      distinct.placed += scene_.meshes[primitive.mesh].uses;
      planned.triangles.push_back({static_cast<std::uint32_t>(found.number), found.order});
    }
    plan_.primitives.push_back(std::move(planned));
  }

  const Scene& scene_;
  unsigned level_limit_;
  VaryingAlpha varying_;
  MovingTextures moving_;
  UvDuplicates duplicates_;
  Plan plan_;
};

}  // namespace

std::string_view sentence(LeftOut why) {
  switch (why) {
    case LeftOut::no_triangles: return "it draws no triangles: points, lines, or too few vertices";
    case LeftOut::not_placed: return "no node uses its mesh";
    case LeftOut::material_variants:
      return "KHR_materials_variants gives it a material of other alpha at run time: a stored micromap would "
             "be stale";
    case LeftOut::animated:
      return "KHR_animation_pointer changes its alpha or UVs at run time: a stored micromap would be stale";
    case LeftOut::specular_glossiness:
      return "KHR_materials_pbrSpecularGlossiness takes alpha from another texture, if the renderer knows it";
    case LeftOut::opaque: return "its material is opaque: no alpha is tested";
    case LeftOut::no_texture:
      return "its base colour has no texture: the constant alpha decides for all of it";
    case LeftOut::no_image: return "its base colour's texture names no image that is read";
    case LeftOut::no_uvs: return "it lacks the UV set that its base colour names";
    case LeftOut::morphed_uvs:
      return "a morph target moves its UVs or vertex colours at run time: a stored micromap would be stale";
    case LeftOut::vertex_alpha:
      return "vertex colours of an alpha beyond 0..1 multiply the texture's: renderers differ in what they "
             "make "
             "of it";
    case LeftOut::two_filters:
      return "its sampler magnifies by one filter and minifies by another: one map would be wrong for either";
    case LeftOut::far_uvs: return "UVs of 2^20 or more: float32 has no texels left there";
    case LeftOut::varying_alpha:
      return "vertex colours of varying alpha multiply the texture's: only bounds of alpha are known";
  }
  return "";
}

Filter filter_of(const Sampler& sampler) {
  return sampler.magnification.value_or(sampler.minification.value_or(Filter::linear));
}

CornerAlphas corner_alphas(const Primitive& primitive, const Triangle& triangle) {
  if (!varies(primitive)) return one_alpha;
  const std::vector<float>& of = primitive.vertex_alpha->of_vertices;
  return {of.at(triangle[0]), of.at(triangle[1]), of.at(triangle[2])};
}

const std::vector<Uv>& planned_uvs(const Primitive& primitive, const Surface& surface) {
  return surface.moves() ? primitive.moving_uvs->middles : primitive.uvs;
}

Plan plan(const Scene& scene, unsigned level_limit, VaryingAlpha varying, MovingTextures moving) {
  return Planner(scene, level_limit, varying, moving).planned();
}

std::uint64_t triangles_left_out(const Scene& scene, const Plan& plan, LeftOut why) {
  std::uint64_t count = 0;
  for (const LeftOutPrimitive& p : plan.left_out)
    count += p.why == why ? scene.primitives[p.primitive].triangles.size() : 0;
  return count;
}

PlanCounts counts(const Plan& plan) {
  PlanCounts c;
  for (const PlannedTriangle& t : plan.triangles) {
    c.unique += t.unique;
    c.placed += t.placed;
    c.lines += t.shape == UvShape::line;
    c.points += t.shape == UvShape::point;
    c.varying += t.varies() ? t.unique : 0;
    c.limited += t.level.limited;
    if (t.level.limited) c.limit = t.level.level;
  }
  for (const PlannedPrimitive& p : plan.primitives)
    for (const TriangleUse& use : p.triangles) c.reordered += use.order != VertexOrder{0, 1, 2};
  return c;
}

}  // namespace mmverify::scene
