#include <fmt/format.h>

#include <algorithm>

#include "proofs/scene/cause/changes.hpp"

namespace mmverify::proofs::scene {
namespace {

using mmverify::scene::AlphaMode;
using mmverify::scene::BaseColorTexture;
using mmverify::scene::Filter;
using mmverify::scene::Sampler;
using mmverify::scene::Surface;
using mmverify::scene::TextureTransform;
using mmverify::scene::Uv;
using mmverify::scene::Wrap;

class Changes {
 public:
  explicit Changes(const Judged& judged) : judged_(judged), inputs_(inputs_of(judged)) {}

  std::vector<InputChange> all() {
    coordinates();
    transforms();
    animations();
    factors();
    samplers();
    add_surfaces("mask_as_blend", "the baker took alphaMode MASK for BLEND", [](Surface& s) {
      s.mode = AlphaMode::blend;
      s.cutoff = 0.5f;
    });
    images();
    return std::move(all_);
  }

 private:
  /// A change of each surface, unless none changes.
  void add_surfaces(std::string code, std::string says, std::function<void(Surface&)> change) {
    Inputs changed = inputs_;
    for (Surface& surface : changed.surfaces) change(surface);
    if (changed.surfaces == inputs_.surfaces) return;
    all_.push_back({std::move(code), std::move(says), [change = std::move(change)](Inputs& inputs) {
                      for (Surface& surface : inputs.surfaces) change(surface);
                    }});
  }

  void add_uvs(std::string code, std::string says, std::function<Uv(const Uv&)> change) {
    all_.push_back({std::move(code), std::move(says), [change = std::move(change)](Inputs& inputs) {
                      for (auto& triangle : inputs.uvs)
                        for (Uv& uv : triangle) uv = change(uv);
                    }});
  }

  /// A change of the UVs that the texture is sampled at, and the same change before KHR_texture_transform.
  void add_flip(const char* code, const char* says, Uv (*change)(const Uv&)) {
    add_uvs(code, says, change);
    if (!judged_.uvs) return;
    bool transforms = false;
    std::vector<std::vector<Uv>> of_primitive(judged_.scene.primitives.size());
    for (std::size_t p = 0; p < of_primitive.size(); ++p) {
      const mmverify::scene::Primitive& primitive = judged_.scene.primitives[p];
      const auto& texture = judged_.scene.material_of(primitive).texture;
      if (!texture) continue;
      BaseColorTexture untransformed = *texture;
      untransformed.transform = TextureTransform();
      transforms = transforms || !(texture->transform == untransformed.transform);
      of_primitive[p] = judged_.uvs(primitive, untransformed);
      for (Uv& uv : of_primitive[p]) uv = transformed(texture->transform, change(uv));
    }
    if (transforms)
      add_primitives_uvs(code, std::string(says) + ", before KHR_texture_transform", of_primitive);
  }

  void coordinates() {
    add_flip("v_flipped", "the baker took 1 - v for v: its texture was upside down", [](const Uv& uv) {
      return Uv{uv[0], 1 - uv[1]};
    });
    add_flip("v_negated", "the baker took -v for v", [](const Uv& uv) { return Uv{uv[0], -uv[1]}; });
    add_flip("u_flipped", "the baker took 1 - u for u: its texture was mirrored", [](const Uv& uv) {
      return Uv{1 - uv[0], uv[1]};
    });
    add_flip("uv_exchanged", "the baker took u and v for each other", [](const Uv& uv) {
      return Uv{uv[1], uv[0]};
    });
    for (std::uint32_t set = 0; set < 4; ++set)
      add_texture("uv_set", fmt::format("the baker took TEXCOORD_{}", set),
                  [set](BaseColorTexture& texture) { texture.uv_set = set; });
  }

  void transforms() {
    const auto add = [this](const char* code, const char* says, void (*change)(TextureTransform&)) {
      add_texture(code, says, [change](BaseColorTexture& texture) { change(texture.transform); });
    };
    add("transform_left_out", "the baker left KHR_texture_transform out",
        [](TextureTransform& t) { t = TextureTransform(); });
    add("transform_offset_left_out", "the baker left the offset of KHR_texture_transform out",
        [](TextureTransform& t) {
          t.offset = {0, 0};
        });
    add("transform_scale_left_out", "the baker left the scale of KHR_texture_transform out",
        [](TextureTransform& t) {
          t.scale = {1, 1};
        });
    add("transform_rotation_left_out", "the baker left the rotation of KHR_texture_transform out",
        [](TextureTransform& t) { t.rotation = 0; });
    add("transform_rotation_reversed", "the baker turned KHR_texture_transform the other way",
        [](TextureTransform& t) { t.rotation = -t.rotation; });
  }

  /// Other UVs of all primitives whose texture changes; none if a primitive lacks them.
  void add_texture(std::string code, std::string says, const std::function<void(BaseColorTexture&)>& change) {
    if (!judged_.uvs) return;
    std::vector<std::vector<Uv>> of_primitive(judged_.scene.primitives.size());
    for (std::size_t p = 0; p < of_primitive.size(); ++p) {
      const mmverify::scene::Primitive& primitive = judged_.scene.primitives[p];
      const auto& before = judged_.scene.material_of(primitive).texture;
      if (!before) continue;
      BaseColorTexture texture = *before;
      change(texture);
      if (texture.uv_set != before->uv_set || !(texture.transform == before->transform))
        of_primitive[p] = judged_.uvs(primitive, texture);
    }
    add_primitives_uvs(std::move(code), std::move(says), of_primitive);
  }

  /// A change to these UVs of primitives, by vertex; those of a primitive without any stay.
  void add_primitives_uvs(std::string code, std::string says, const std::vector<std::vector<Uv>>& of) {
    const std::vector<mmverify::scene::UvTriangle> uvs = with_primitives_uvs(of);
    if (uvs == inputs_.uvs) return;
    all_.push_back({std::move(code), std::move(says), [uvs](Inputs& inputs) { inputs.uvs = uvs; }});
  }

  std::vector<mmverify::scene::UvTriangle> with_primitives_uvs(const std::vector<std::vector<Uv>>& of) const {
    std::vector<mmverify::scene::UvTriangle> uvs = inputs_.uvs;
    for (std::size_t k = 0; k < uvs.size(); ++k) {
      const mmverify::scene::MapLink& link = judged_.maps.link(k);
      if (of[link.primitive].empty()) continue;
      const auto& vertices = judged_.scene.primitives[link.primitive].triangles[link.triangle];
      for (std::size_t vertex = 0; vertex < 3; ++vertex)
        uvs[k][vertex] = of[link.primitive][vertices[vertex]];
    }
    return uvs;
  }

  void animations() {
    if (std::none_of(inputs_.surfaces.begin(), inputs_.surfaces.end(),
                     [](const Surface& s) { return s.moves(); }))
      return;
    std::vector<std::vector<Uv>> at_rest(judged_.scene.primitives.size());
    for (std::size_t p = 0; p < at_rest.size(); ++p)
      if (judged_.scene.primitives[p].moving_uvs) at_rest[p] = judged_.scene.primitives[p].uvs;
    all_.push_back(
        {"animation_left_out",
         "the baker left KHR_animation_pointer out: the maps hold only while no animation moves the UVs",
         [uvs = with_primitives_uvs(at_rest)](Inputs& inputs) {
           inputs.uvs = uvs;
           for (Surface& surface : inputs.surfaces) surface.travel = {};
         }});
  }

  void factors() {
    add_surfaces("factor_left_out", "the baker left the alpha of baseColorFactor out",
                 [](Surface& s) { s.base_color_alpha = 1; });
    add_surfaces("vertex_alpha_left_out", "the baker left the alpha of COLOR_0 out",
                 [](Surface& s) { s.vertex_alpha = 1; });
    const bool both = std::any_of(inputs_.surfaces.begin(), inputs_.surfaces.end(), [](const Surface& s) {
      return s.base_color_alpha != 1 && s.vertex_alpha != 1;
    });
    if (both)
      add_surfaces("factors_left_out", "the baker left the alphas of baseColorFactor and of COLOR_0 out",
                   [](Surface& s) { s.base_color_alpha = s.vertex_alpha = 1; });
  }

  void samplers() {
    add_surfaces("filter", "the baker sampled by the other filter", [](Surface& s) {
      s.sampler.magnification = s.sampler.minification =
          filter_of(s.sampler) == Filter::linear ? Filter::nearest : Filter::linear;
    });
    constexpr Wrap wraps[] = {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat};
    for (const Wrap u : wraps)
      for (const Wrap v : wraps)
        add_surfaces("wrap",
                     u == v ? fmt::format("the baker wrapped by {}", name_of(u))
                            : fmt::format("the baker wrapped u by {} and v by {}", name_of(u), name_of(v)),
                     [u, v](Surface& s) {
                       s.sampler.wrap_u = u;
                       s.sampler.wrap_v = v;
                     });
    add_surfaces("sampler", "the baker took the default sampler, REPEAT and linear", [](Surface& s) {
      s.sampler.wrap_u = s.sampler.wrap_v = Wrap::repeat;
      s.sampler.magnification = s.sampler.minification = Filter::linear;
    });
  }

  void images() {
    for (std::size_t image = 0; image < judged_.scene.images.size(); ++image)
      if (judged_.scene.images[image].decoded())
        add_surfaces("texture",
                     fmt::format("the baker took image {}{}", image,
                                 judged_.scene.images[image].name.empty()
                                     ? ""
                                     : " (" + judged_.scene.images[image].name + ")"),
                     [image](Surface& s) { s.image = image; });
  }

  const Judged& judged_;
  const Inputs inputs_;
  std::vector<InputChange> all_;
};

}  // namespace

std::vector<InputChange> input_changes(const Judged& judged) { return Changes(judged).all(); }

}  // namespace mmverify::proofs::scene
