#include "scene/record/bake_record.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <variant>

#include "scene/plan/plan.hpp"
#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

using RecordJson = nlohmann::ordered_json;

constexpr int record_version = 1;

/// FNV-1a, 64 bits: it tells an input from a changed one; it is no proof against forgers.
class RecordHash {
 public:
  void add(std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) {
      hash_ ^= word >> shift & 0xff;
      hash_ *= 0x100000001b3;
    }
  }
  void add(float number) { add(std::bit_cast<std::uint32_t>(number)); }
  std::string text() const {
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash_));
    return digits.data();
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

std::string texture_hash(const Image& image) {
  RecordHash hash;
  hash.add(image.width);
  hash.add(image.height);
  std::visit(
      [&hash](const auto& alpha) {
        for (const auto texel : alpha)
          if constexpr (std::is_same_v<decltype(texel), const float>)
            hash.add(texel);
          else
            hash.add(std::uint32_t{texel});
      },
      image.alpha);
  return hash.text();
}

/// The alphas of all vertices.
std::string alphas_hash(const std::vector<float>& alphas) {
  RecordHash hash;
  for (const float alpha : alphas) hash.add(alpha);
  return hash.text();
}

/// The UVs of the corners of the triangles, in order: a turned triangle, or another order, changes them.
std::string triangles_hash(const Primitive& primitive) {
  RecordHash hash;
  for (const Triangle& triangle : primitive.triangles)
    for (const std::uint32_t vertex : triangle)
      for (const float x : primitive.uvs.at(vertex)) hash.add(x == 0 ? 0.0f : x);
  return hash.text();
}

std::string sampler_text(const Sampler& sampler) {
  return std::string(name_of(sampler.wrap_u)) + ", " + name_of(sampler.wrap_v) +
         (filter_of(sampler) == Filter::nearest ? ", nearest" : ", linear");
}

/// A number as the shortest decimal of its binary32.  Nine digits are enough for every one.
RecordJson decimal(float number) {
  std::array<char, 32> text{};
  // Not std::to_chars: the C++ library of WebAssembly has it for whole numbers alone.  Five digits write 10 as 10, and not
  // as 1e+01.
  const bool is_plain = std::fabs(number) >= 1e-4f && std::fabs(number) < 1e5f;
  for (int digits = is_plain ? 5 : 1; digits <= 9; ++digits) {
    std::snprintf(text.data(), text.size(), "%.*g", digits, static_cast<double>(number));
    if (std::strtof(text.data(), nullptr) == number) break;
  }
  return RecordJson::parse(text.data());
}

/// The inputs that the scene has; `words`: each one's name in a sentence.
struct Input {
  const char* name;
  const char* words;
  RecordJson value;
  bool hashed = false;
};

std::vector<Input> inputs_now(const Scene& scene, const Primitive& primitive) {
  const Material& material = scene.material_of(primitive);
  const BaseColorTexture& texture = *material.texture;
  const TextureTransform& t = texture.transform;
  const float vertex_alpha = primitive.vertex_alpha ? primitive.vertex_alpha->least : 1;
  std::vector<Input> all{{"alphaMode", "alphaMode", material.mode == AlphaMode::mask ? "MASK" : "BLEND"}};
  if (material.mode == AlphaMode::mask) all.push_back({"alphaCutoff", "cutoff", decimal(material.cutoff)});
  all.push_back({"alpha", "the alpha of baseColorFactor", decimal(material.base_color_alpha)});
  all.push_back({"vertexAlpha", "the alpha of COLOR_0", decimal(vertex_alpha)});
  if (primitive.vertex_alpha && !primitive.vertex_alpha->of_vertices.empty())
    all.push_back(
        {"vertexAlphas", "the alphas of COLOR_0", alphas_hash(primitive.vertex_alpha->of_vertices), true});
  all.push_back({"sampler", "the sampler", sampler_text(texture.sampler)});
  all.push_back({"texCoord", "texCoord", texture.uv_set});
  all.push_back({"transform", "KHR_texture_transform",
                 RecordJson::array({decimal(t.offset[0]), decimal(t.offset[1]), decimal(t.scale[0]),
                                    decimal(t.scale[1]), decimal(t.rotation)})});
  if (material.moving) {
    const TextureTransform &least = material.moving->least, &greatest = material.moving->greatest;
    all.push_back(
        {"moving", "the range of KHR_texture_transform's animation",
         RecordJson::array({decimal(least.offset[0]), decimal(least.offset[1]), decimal(least.scale[0]),
                            decimal(least.scale[1]), decimal(least.rotation), decimal(greatest.offset[0]),
                            decimal(greatest.offset[1]), decimal(greatest.scale[0]),
                            decimal(greatest.scale[1]), decimal(greatest.rotation)})});
  }
  all.push_back({"texture", "the texture's alpha", texture_hash(scene.images.at(*texture.image)), true});
  all.push_back({"triangles", "the triangles and their UVs", triangles_hash(primitive), true});
  return all;
}

}  // namespace

std::string bake_record(const Scene& scene, const Primitive& primitive, const BakeSettings& settings) {
  RecordJson record{{"version", record_version}};
  for (Input& input : inputs_now(scene, primitive)) record[input.name] = std::move(input.value);
  record["margin"] = decimal(settings.margin);
  record["states"] = settings.two_state ? 2 : 4;
  return record.dump();
}

std::string why_unbakeable(const Scene& scene, const Primitive& primitive) {
  const Material& material = scene.material_of(primitive);
  if (material.mode == AlphaMode::opaque) return "alphaMode is OPAQUE now";
  if (!material.texture || !material.texture->image || primitive.uvs.empty() ||
      !scene.images.at(*material.texture->image).decoded())
    return "the alpha texture, or its UVs, are gone";
  return "";
}

std::vector<std::string> changes_since(std::string_view record, const Scene& scene,
                                       const Primitive& primitive) {
  const RecordJson then = RecordJson::parse(record, nullptr, false);
  if (!then.is_object()) throw std::invalid_argument("a record of a bake is a JSON object");
  if (then.value("version", RecordJson()) != record_version) return {};
  if (std::string why = why_unbakeable(scene, primitive); !why.empty()) return {std::move(why)};
  std::vector<std::string> changes;
  bool sampled_elsewhere = false;
  for (const Input& now : inputs_now(scene, primitive)) {
    const auto was = then.find(now.name);
    if (was == then.end() || *was == now.value) continue;
    // The UVs are hashed as they are sampled: another set or transform changes them all.
    if (now.hashed && sampled_elsewhere && std::string_view(now.name) == "triangles") continue;
    const std::string_view name = now.name;
    sampled_elsewhere = sampled_elsewhere || name == "texCoord" || name == "transform";
    changes.push_back(now.hashed ? std::string(now.words) + " changed"
                                 : std::string(now.words) + " was " + shown(was->dump()) + ", is " +
                                       now.value.dump());
  }
  return changes;
}

}  // namespace mmverify::scene
