#include "scene/read/moving_textures.hpp"

#include <algorithm>
#include <cmath>

#include "scene/read/accessor.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/extensions.hpp"

namespace mmverify::scene {
namespace {

/// One animated number of a transform.
using MovedNumber = float& (*)(TextureTransform&);

struct MovedProperty {
  std::string_view name;
  std::vector<MovedNumber> members;
};

const std::vector<MovedProperty>& moved_properties() {
  static const std::vector<MovedProperty> all{
      {"offset",
       {[](TextureTransform& t) -> float& { return t.offset[0]; },
        [](TextureTransform& t) -> float& { return t.offset[1]; }}},
      {"scale",
       {[](TextureTransform& t) -> float& { return t.scale[0]; },
        [](TextureTransform& t) -> float& { return t.scale[1]; }}},
      {"rotation", {[](TextureTransform& t) -> float& { return t.rotation; }}},
  };
  return all;
}

/// The property of a material's texture that a pointer moves; null for any other pointer.
const MovedProperty* property_of(std::string_view pointer, std::size_t material) {
  const std::string before = "/materials/" + std::to_string(material) +
                             "/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/";
  if (!pointer.starts_with(before)) return nullptr;
  pointer.remove_prefix(before.size());
  const auto found = std::find_if(moved_properties().begin(), moved_properties().end(),
                                  [pointer](const MovedProperty& p) { return p.name == pointer; });
  return found == moved_properties().end() ? nullptr : &*found;
}

class Sampled {
 public:
  Sampled(const Document& document, const Buffers& buffers, const nlohmann::json& sampler,
          const std::string& at, std::size_t components)
      : interpolation_(sampler.value("interpolation", "LINEAR")),
        components_(components),
        times_(read_floats(document, buffers, sampler.at("input").get<std::size_t>(), 1, Integers::none,
                           at + " input")),
        values_(read_floats(document, buffers, sampler.at("output").get<std::size_t>(),
                            static_cast<int>(components), Integers::any, at + " output")) {}

  bool fits() const {
    if (interpolation_ == "CUBICSPLINE")
      return times_.size() > 1 && values_.size() == 3 * times_.size() * components_;
    return (interpolation_ == "LINEAR" || interpolation_ == "STEP") &&
           values_.size() == times_.size() * components_;
  }

  /// Calls take(value) with numbers whose hull holds all values of a component.  Domain: fits().
  template <class Take>
  void hull(std::size_t component, Take take) const {
    if (interpolation_ != "CUBICSPLINE") {
      for (std::size_t k = 0; k < times_.size(); ++k) take(values_[k * components_ + component]);
      return;
    }
    // Each key has an in-tangent, a value and an out-tangent.
    const auto at = [&](std::size_t key, std::size_t part) {
      return double{values_[(3 * key + part) * components_ + component]};
    };
    for (std::size_t k = 0; k < times_.size(); ++k) {
      take(static_cast<float>(at(k, 1)));
      if (k + 1 == times_.size()) break;
      const double third = (double{times_[k + 1]} - double{times_[k]}) / 3;
      // A step of binary32 to either side holds what the rounding of these two takes off.
      for (const double point : {at(k, 1) + third * at(k, 2), at(k + 1, 1) - third * at(k + 1, 0)}) {
        const auto rounded = static_cast<float>(point);
        take(std::nextafter(rounded, -HUGE_VALF));
        take(std::nextafter(rounded, HUGE_VALF));
      }
    }
  }

 private:
  std::string interpolation_;
  std::size_t components_;
  std::vector<float> times_, values_;
};

/// Widens the range of a material by a channel's values; false if the channel moves anything else, or does not fit.
bool widen(const Document& document, const Buffers& buffers, const nlohmann::json& animation,
           const nlohmann::json& channel, const std::string& at, std::size_t material,
           TransformRange& range) {
  const nlohmann::json& pointer = extension(channel["target"], "KHR_animation_pointer");
  const MovedProperty* const property = property_of(pointer["pointer"].get<std::string>(), material);
  if (property == nullptr) return false;
  const auto sampler = channel.value("sampler", std::size_t{0});
  const nlohmann::json& samplers = member(animation, "samplers");
  if (sampler >= samplers.size()) return false;
  const Sampled sampled(document, buffers, samplers[sampler], at + " sampler " + std::to_string(sampler),
                        property->members.size());
  if (!sampled.fits()) return false;
  for (std::size_t k = 0; k < property->members.size(); ++k) {
    float &least = property->members[k](range.least), &greatest = property->members[k](range.greatest);
    sampled.hull(k, [&](float value) {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    });
  }
  return true;
}

}  // namespace

void read_moving_textures(const Document& document, const Buffers& buffers,
                          std::vector<Material>& materials) {
  const nlohmann::json& animations = member(document.json, "animations");
  for (std::size_t m = 0; m < materials.size(); ++m) {
    Material& material = materials[m];
    if (material.animated.empty() || !material.texture) continue;
    TransformRange range{material.texture->transform, material.texture->transform};
    std::size_t taken = 0;
    for (std::size_t a = 0; a < animations.size(); ++a)
      for (const nlohmann::json& channel : member(animations[a], "channels")) {
        const nlohmann::json& target = extension(channel["target"], "KHR_animation_pointer");
        if (!target.contains("pointer") || property_of(target["pointer"].get<std::string>(), m) == nullptr)
          continue;
        taken += widen(document, buffers, animations[a], channel, place("animation", a), m, range) ? 1 : 0;
      }
    if (taken == material.animated.size()) material.moving = range;
  }
}

MovingUvs moving_uvs(const TransformRange& range, const std::vector<Uv>& uvs) {
  MovingUvs moving;
  moving.middles.reserve(uvs.size());
  for (const Uv& uv : uvs) {
    const auto [least, greatest] = transformed(range, uv);
    Uv& middle = moving.middles.emplace_back();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double low = least[axis], high = greatest[axis];
      middle[axis] = static_cast<float>((low + high) / 2);
      const double reach = std::max(high - middle[axis], middle[axis] - low);
      float& travel = moving.travel[axis];
      if (reach > travel) travel = static_cast<float>(reach);
      if (reach > travel) travel = std::nextafter(travel, HUGE_VALF);
    }
  }
  return moving;
}

}  // namespace mmverify::scene
