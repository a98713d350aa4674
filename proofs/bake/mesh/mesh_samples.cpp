#include "proofs/bake/mesh/mesh_samples.hpp"

#include <algorithm>
#include <cmath>

#include "proofs/bake/domains/samples.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint64_t mesh_stream = 0x6d657368;
constexpr float texel_parts = 16;  ///< corners lie at multiples of 1/16 of a texel

/// A texture of 8 bits with large parts that are O or T: halves, a disc, noise, one texel.
Case plain_surface(Random& random) {
  Case one;
  one.width = static_cast<std::uint32_t>(2 + random.below(7));
  one.height = static_cast<std::uint32_t>(2 + random.below(7));
  one.alpha.clear();
  const std::uint64_t kind = random.below(4), lone = random.below(one.width * one.height);
  const std::uint32_t inside = random.below(2) != 0 ? 255 : 0;
  for (std::uint32_t k = 0; k < one.width * one.height; ++k) {
    const std::int64_t x = 2 * std::int64_t{k % one.width} + 1 - one.width,
                       y = 2 * std::int64_t{k / one.width} + 1 - one.height;
    const bool is_inside = kind == 0   ? x < 0
                           : kind == 1 ? x * x + y * y < 12
                           : kind == 2 ? random.below(2) != 0
                                       : k == lone;
    one.alpha.push_back(is_inside ? inside : 255 - inside);
  }
  one.filter = static_cast<Filter>(random.below(2));
  one.wrap_u = static_cast<Wrap>(random.below(5));
  one.wrap_v = static_cast<Wrap>(random.below(5));
  one.border = static_cast<std::uint32_t>(255 * random.below(2));
  const std::int64_t cutoff = random.between(1, 255);
  one.cutoff = random.below(2) != 0 ? Cutoff{static_cast<std::uint32_t>(cutoff), 255} : Cutoff{1, 2};
  return one;
}

/// Adds triangles to a mesh.
class MeshDraw {
 public:
  MeshDraw(Random& random, MeshCase& mesh) : random_(random), mesh_(mesh), first_places_(random.below(4)) {}

  using Relation = void (MeshDraw::*)();
  void first(const std::optional<std::array<float, 6>>& uv) {
    if (!uv) return anywhere();
    add({vertex({(*uv)[0], (*uv)[1]}), vertex({(*uv)[2], (*uv)[3]}), vertex({(*uv)[4], (*uv)[5]})});
  }

  void anywhere() { add({vertex(any_place()), vertex(any_place()), vertex(any_place())}); }
  /// Within a texel, so that most are O or T.
  void within_a_texel() {
    const auto [u, v] = any_place();
    const float x = in_texels(0, static_cast<float>(1 + random_.below(12)) / texel_parts),
                y = in_texels(1, static_cast<float>(1 + random_.below(12)) / texel_parts);
    add({vertex({u, v}), vertex({u + x, v}), vertex({u, v + y})});
  }
  void beside() {
    const auto corners = earlier();
    add({corners[1], corners[0], vertex(any_place())});
  }
  void again() { add(earlier()); }
  void turned() {
    auto corners = earlier();
    std::rotate(corners.begin(), corners.begin() + 1 + static_cast<std::ptrdiff_t>(random_.below(2)),
                corners.end());
    add(corners);
  }
  void rewound() {
    auto corners = earlier();
    std::swap(corners[0], corners[1 + random_.below(2)]);
    add(corners);
  }
  /// The same coordinates, in vertices of its own, in any order.
  void copied() {
    auto corners = copies(earlier());
    if (random_.below(2) != 0) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    if (random_.below(4) == 0) std::swap(corners[0], corners[1]);
    add(corners);
  }
  /// One vertex, or all, some sixteenths of a texel away along one axis.
  void near_it() { moved(static_cast<float>(random_.between(1, 3)) / texel_parts); }
  void half_a_texel_away() { moved(static_cast<float>(random_.between(4, 8)) / texel_parts); }
  /// Likewise by so little that rounding may hide it.
  void a_hair_away() { moved(std::ldexp(1.0f, -static_cast<int>(random_.between(6, 14)))); }
  void whole_repeats_away() {
    const auto corners = copies(earlier());
    const std::size_t axis = random_.below(2);
    const auto repeats = static_cast<float>(random_.between(1, 2)) * (random_.below(2) != 0 ? 1.0f : -1.0f);
    for (const std::uint32_t k : corners) mesh_.vertices[k][axis] += repeats;
    add(corners);
  }
  void mirrored_in_the_texture() {
    const auto corners = copies(earlier());
    const std::size_t axis = random_.below(2);
    for (const std::uint32_t k : corners) mesh_.vertices[k][axis] = 1 - mesh_.vertices[k][axis];
    add(corners);
  }
  void u_for_v() {
    const auto corners = copies(earlier());
    for (const std::uint32_t k : corners) std::swap(mesh_.vertices[k][0], mesh_.vertices[k][1]);
    add(corners);
  }
  void half_as_large() {
    const auto corners = copies(earlier());
    const auto first = mesh_.vertices[corners[0]];
    for (const std::uint32_t k : corners)
      for (std::size_t axis = 0; axis < 2; ++axis)
        mesh_.vertices[k][axis] = (mesh_.vertices[k][axis] + first[axis]) / 2;
    add(corners);
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;
  void add(const Corners& corners) { mesh_.triangles.push_back(corners); }
  std::uint32_t vertex(const std::array<float, 2>& uv) {
    mesh_.vertices.push_back(uv);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }
  Corners earlier() { return mesh_.triangles[random_.below(mesh_.triangles.size())]; }
  Corners copies(Corners corners) {
    for (std::uint32_t& k : corners) k = vertex(std::array<float, 2>(mesh_.vertices[k]));
    return corners;
  }
  float in_texels(std::size_t axis, float texels) const {
    return texels / static_cast<float>(axis == 0 ? mesh_.surface.width : mesh_.surface.height);
  }
  /// A place in or around the texture; some on lines between texels, or through their centres, where alpha changes, and some at
  /// quarters of texels, to which coordinates may be rounded.
  std::array<float, 2> any_place() {
    constexpr std::array<float, 4> all_parts{2, 4, texel_parts, texel_parts};
    const float parts = all_parts[mesh_.triangles.empty() ? first_places_ : random_.below(all_parts.size())];
    const auto along = [&](std::size_t axis) {
      const std::int64_t size =
          static_cast<std::int64_t>(parts) * (axis == 0 ? mesh_.surface.width : mesh_.surface.height);
      return in_texels(axis, static_cast<float>(random_.between(-size / 4, size + size / 4)) / parts);
    };
    const float u = along(0);
    return {u, along(1)};
  }
  void moved(float texels) {
    const auto corners = copies(earlier());
    if (random_.below(2) != 0) texels = -texels;
    const std::size_t axis = random_.below(2), alone = random_.below(6);
    for (std::size_t k = 0; k < 3; ++k)
      if (alone >= 3 || alone == k) mesh_.vertices[corners[k]][axis] += in_texels(axis, texels);
    add(corners);
  }

  Random& random_;
  MeshCase& mesh_;
  std::uint64_t first_places_;  ///< the kind of all corners of the first triangle
};

constexpr std::array<MeshDraw::Relation, 16> relations{
    &MeshDraw::near_it,        &MeshDraw::again,
    &MeshDraw::turned,         &MeshDraw::rewound,
    &MeshDraw::near_it,        &MeshDraw::copied,
    &MeshDraw::within_a_texel, &MeshDraw::half_a_texel_away,
    &MeshDraw::a_hair_away,    &MeshDraw::whole_repeats_away,
    &MeshDraw::near_it,        &MeshDraw::anywhere,
    &MeshDraw::u_for_v,        &MeshDraw::mirrored_in_the_texture,
    &MeshDraw::half_as_large,  &MeshDraw::beside};

void draw_array(Random& random, MeshCase& mesh, bool any_format) {
  do {
    mesh.api = spec::array::apis[random.below(spec::array::api_count)];
    mesh.encoding = spec::micromap::encodings[random.below(5)];
  } while (!spec::array::takes(mesh.api, mesh.encoding));
  if (any_format && random.below(3) == 0) mesh.format = spec::micromap::Format::two_state;
}

}  // namespace

std::uint64_t mesh_pairs() { return 3 * relations.size(); }

MeshCase mesh_sample(std::uint64_t seed, Level n, std::uint64_t k, bool any_format) {
  Random random(seed, mesh_stream + n, k);
  MeshCase mesh;
  mesh.level = n;
  std::optional<std::array<float, 6>> uv;
  if (k % 3 == 2) {
    constexpr std::uint64_t samples = 104;  // the kinds of featured_sample() follow each other
    mesh.surface = featured_sample(seed, samples * 50 * n + k / 3);
    if (random.below(2) != 0) uv = mesh.surface.uv;
  } else {
    mesh.surface = plain_surface(random);
  }
  mesh.surface.uv = {};
  MeshDraw draw(random, mesh);
  draw.first(uv);
  if (k < mesh_pairs()) {
    (draw.*relations[k % relations.size()])();
  } else {
    for (std::uint64_t left = 1 + random.below(8); left > 0; --left)
      (draw.*relations[random.below(relations.size())])();
  }
  draw_array(random, mesh, any_format);
  if (random.below(3) == 0)
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      mesh.levels.push_back(static_cast<Level>(random.below(n + 1)));
  return mesh;
}

const char* mesh_samples_text() {
  return "meshes of 2 to 9 triangles, most of them made of an earlier one: the same, turned, rewound, "
         "copied, up to 8/16 of "
         "a texel or a hair away, whole repeats away, mirrored, with u for v, halved, within a texel; "
         "textures of up to "
         "8x8 texels, a third of them with all features; every API and index type, one level or one a "
         "triangle";
}

}  // namespace mmverify::proofs::bake
