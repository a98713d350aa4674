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

/// The numbers of the keys of one sampler, or a fault.
struct Sampled {
  std::string interpolation;
  std::size_t components = 0;
  std::vector<float> times, values;
  std::string fault;  ///< why there are none; empty: there are

  /// Calls take(value) with numbers whose hull holds all values of a component.  Domain: no fault.
  template <class Take>
  void hull(std::size_t component, Take take) const {
    if (interpolation != "CUBICSPLINE") {
      for (std::size_t k = 0; k < times.size(); ++k) take(values[k * components + component]);
      return;
    }
    // Each key has an in-tangent, a value and an out-tangent.
    const auto at = [&](std::size_t key, std::size_t part) {
      return double{values[(3 * key + part) * components + component]};
    };
    for (std::size_t k = 0; k < times.size(); ++k) {
      take(static_cast<float>(at(k, 1)));
      if (k + 1 == times.size()) break;
      const double third = (double{times[k + 1]} - double{times[k]}) / 3;
      // A step of binary32 to either side holds what the rounding of these two takes off.
      for (const double point : {at(k, 1) + third * at(k, 2), at(k + 1, 1) - third * at(k + 1, 0)}) {
        const auto rounded = static_cast<float>(point);
        take(std::nextafter(rounded, -HUGE_VALF));
        take(std::nextafter(rounded, HUGE_VALF));
      }
    }
  }
};

/// Reads samplers, each number of the file only so often that all together stay few.
class SamplerReader {
 public:
  SamplerReader(const Document& document, const Buffers& buffers) : document_(document), buffers_(buffers) {}

  Sampled sampled(const nlohmann::json& sampler, const std::string& at, std::size_t components) {
    Sampled s;
    s.components = components;
    if (!sampler.is_object()) return faulty(at + " is no object");
    const auto interpolation = sampler.find("interpolation");
    if (interpolation != sampler.end() && !interpolation->is_string())
      return faulty(at + ": its interpolation is no string");
    s.interpolation = interpolation == sampler.end() ? "LINEAR" : interpolation->get<std::string>();
    s.fault = read(sampler, "input", 1, Integers::none, at, s.times);
    if (s.fault.empty()) s.fault = read(sampler, "output", components, Integers::any, at, s.values);
    if (!s.fault.empty()) return s;
    const bool cubic = s.interpolation == "CUBICSPLINE";
    if (!cubic && s.interpolation != "LINEAR" && s.interpolation != "STEP")
      return faulty(at + ": its interpolation is none of glTF's");
    if (s.values.size() != s.times.size() * components * (cubic ? 3 : 1) || (cubic && s.times.size() < 2))
      return faulty(at + ": its values do not fit its " + std::to_string(s.times.size()) + " keys");
    return s;
  }

 private:
  static Sampled faulty(std::string fault) {
    Sampled s;
    s.fault = std::move(fault);
    return s;
  }

  /// The fault, if the numbers of an accessor cannot be read.
  std::string read(const nlohmann::json& sampler, const char* end, std::size_t components, Integers integers,
                   const std::string& at, std::vector<float>& to) {
    const auto index = sampler.find(end);
    const std::string what = at + " " + end;
    if (index == sampler.end() || !index->is_number_unsigned() ||
        index->get<std::size_t>() >= document_.model.accessors.size())
      return what + " is no index of an accessor";
    const tinygltf::Accessor& accessor = document_.model.accessors[index->get<std::size_t>()];
    if (accessor.bufferView < 0) return what + " has no bufferView";
    if (accessor.count > left_ / components) return what + ": more than 2^24 numbers of animations";
    left_ -= accessor.count * components;
    try {
      to = read_floats(document_, buffers_, index->get<std::size_t>(), static_cast<int>(components), integers,
                       what);
    } catch (const BadScene& bad) {
      return bad.what();
    }
    return {};
  }

  const Document& document_;
  const Buffers& buffers_;
  std::size_t left_ = std::size_t{1} << 24;
};

/// Widens the range of a material by a channel's values.  The fault, if they cannot be read.
std::string widen(SamplerReader& reader, const nlohmann::json& animation, const nlohmann::json& channel,
                  const std::string& at, const MovedProperty& property, TransformRange& range) {
  const nlohmann::json& samplers = member(animation, "samplers");
  const auto index = channel.find("sampler");
  if (!samplers.is_array() || index == channel.end() || !index->is_number_unsigned() ||
      index->get<std::size_t>() >= samplers.size())
    return at + ": a channel without a sampler";
  const auto number = index->get<std::size_t>();
  const Sampled sampled =
      reader.sampled(samplers[number], at + " sampler " + std::to_string(number), property.members.size());
  if (!sampled.fault.empty()) return sampled.fault;
  for (std::size_t k = 0; k < property.members.size(); ++k) {
    float &least = property.members[k](range.least), &greatest = property.members[k](range.greatest);
    sampled.hull(k, [&](float value) {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    });
  }
  return {};
}

}  // namespace

void read_moving_textures(const Document& document, const Buffers& buffers,
                          std::vector<Material>& materials) {
  SamplerReader reader(document, buffers);
  const nlohmann::json& animations = member(document.json, "animations");
  for (std::size_t m = 0; m < materials.size(); ++m) {
    Material& material = materials[m];
    if (material.animated.empty() || !material.texture) continue;
    TransformRange range{material.texture->transform, material.texture->transform};
    std::size_t taken = 0;
    for (std::size_t a = 0; a < animations.size() && material.unmoved.empty(); ++a)
      for (const nlohmann::json& channel : member(animations[a], "channels")) {
        const nlohmann::json& target = extension(channel["target"], "KHR_animation_pointer");
        if (!target.contains("pointer")) continue;
        const MovedProperty* const property = property_of(target["pointer"].get<std::string>(), m);
        if (property == nullptr || !material.unmoved.empty()) continue;
        material.unmoved = widen(reader, animations[a], channel, place("animation", a), *property, range);
        ++taken;
      }
    if (!material.unmoved.empty()) continue;
    if (taken == material.animated.size())
      material.moving = range;
    else
      material.unmoved = "an animation changes more of it than the transform of its texture";
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
