// A small scene, and all that is made of it: plan, maps, arrays, pairs, square maps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "proofs/scene/laws.hpp"
#include "scene/bake/square_maps.hpp"
#include "scene/plan/levels.hpp"

namespace mmverify::tests {

/// A disc of alpha in 16 x 16 texels, soft at its rim, off the centre so that nothing is symmetric.
inline mmverify::scene::Image disc() {
  mmverify::scene::Image image{"disc", 16, 16, std::vector<std::uint8_t>(256)};
  auto& alpha = std::get<0>(image.alpha);
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t x = 0; x < 16; ++x) {
      const double r = std::hypot(static_cast<double>(x) - 6.3, static_cast<double>(y) - 8.9);
      alpha[x + 16 * y] = static_cast<std::uint8_t>(std::clamp(255 * (5.5 - r), 0.0, 255.0));
    }
  return image;
}

/// Two quads with the texture on: one as two triangles that share an edge, one whose triangles are the same
/// UVs with other orders of vertices, and an opaque corner of it, which is uniform.
inline mmverify::scene::Scene made_scene() {
  using namespace mmverify::scene;
  Scene s;
  s.file = "made.gltf";
  s.images.push_back(disc());
  Material material;
  material.mode = AlphaMode::mask;
  material.texture = BaseColorTexture{0, 0, {}, {}};
  s.materials.push_back(material);
  s.meshes.push_back({"quads", 2, {5, {}}});
  Primitive p;
  p.material = 0;
  p.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4f, 0.5f}, {0.45f, 0.5f}, {0.4f, 0.55f}};
  for (const Uv& uv : p.uvs) p.positions.push_back({uv[0], uv[1], 0});
  p.triangles = {{0, 1, 2}, {2, 3, 0}, {1, 2, 0}, {1, 0, 2}, {4, 5, 6}};
  s.primitives.push_back(p);
  return s;
}

/// State `at` of a packed map.
inline unsigned code(std::span<const std::uint8_t> map, std::uint32_t at, unsigned b = 2) {
  return map[at * b / 8] >> (at * b % 8) & ((1u << b) - 1);
}

/// A scene all the way.
struct Made {
  mmverify::scene::Scene s;
  mmverify::scene::Plan p = plan(s);
  mmverify::scene::Levels l;
  mmverify::scene::Baked b;
  mmverify::scene::SceneArrays a;
  mmverify::scene::Pairs q;
  mmverify::scene::SquareMaps m;
  proofs::scene::Codecs codecs = {};
  bool two_state = false;

  explicit Made(std::optional<unsigned> level = {}, const mmverify::scene::BakeOptions& options = {},
                mmverify::scene::Scene of = made_scene())
      : s(std::move(of)),
        l(levels(p, {level, 1 << 20})),
        b(bake(s, p, l.of, options)),
        a(arrays(p, b)),
        q(pairs(s, p)),
        m(square_maps(s, p, q)),
        two_state(options.two_state) {}
  proofs::scene::Data data() const { return {s, p, b, a, q, m, 0, two_state, codecs}; }
};

}  // namespace mmverify::tests
