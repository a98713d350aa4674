#include "scene/sample/quad.hpp"

#include "scene/sample/file.hpp"
#include "scene/sample/textures.hpp"

namespace mmverify::scene {

Bytes quad_scene() {
  using Json = nlohmann::json;
  constexpr int linear = 9729, clamp_to_edge = 33071;
  SampleFile file;
  const std::size_t sampler = file.add(
      "samplers",
      {{"magFilter", linear}, {"minFilter", linear}, {"wrapS", clamp_to_edge}, {"wrapT", clamp_to_edge}});
  const auto texture = [&](const Picture& picture) {
    const std::size_t image = file.add_image(picture.name, png(picture));
    return file.add("textures", {{"sampler", sampler}, {"source", image}});
  };
  const std::size_t colours = texture(rings()), normals = texture(waves());
  const std::size_t material =
      file.add("materials",
               {{"name", "quad"},
                {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", colours}}}, {"metallicFactor", 0}}},
                {"normalTexture", {{"index", normals}}}});
  SampleMesh square;
  square.add_quad({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}});
  const std::size_t mesh = file.add(
      "meshes", {{"name", "quad"}, {"primitives", Json::array({file.primitive(square, material, true)})}});
  file.place(mesh, "quad", {0, 0, 0});
  return file.finished();
}

}  // namespace mmverify::scene
