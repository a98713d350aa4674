// Laws of meshes: texts are read back, each input varies alone, and what field reports tell of is refuted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "proofs/array/answers.hpp"
#include "proofs/bake/mesh/mesh_baker.hpp"
#include "proofs/bake/mesh/mesh_judges.hpp"
#include "proofs/bake/mesh/mesh_samples.hpp"

namespace mesh_laws_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::bake;

TEST(MeshCases, ComeBackFromTheirTexts) {
  for (const Level n : {0u, 3u})
    for (std::uint64_t k = 0; k < 200; ++k) {
      const MeshCase mesh = mesh_sample(1, n, k, true);
      const MeshCase back = mesh_from(text_of(mesh), n);
      EXPECT_EQ(text_of(back), text_of(mesh));
      EXPECT_EQ(back.vertices, mesh.vertices);
      EXPECT_EQ(back.triangles, mesh.triangles);
    }
}

TEST(MeshCases, OtherTextsAreNone) {
  const std::string surface = "texels=u8:1x1:00,wrap=repeat:repeat,cutoff=1/2,",
                    array = "api=khr,indices=u8,format=4,", mesh = "vertices=0:0:1:0:0:1,triangles=0:1:2";
  EXPECT_EQ(mesh_from(surface + array + mesh, 2).triangles.size(), 1u);
  for (const std::string& text :
       {surface + array + "vertices=0:0:1:0:0,triangles=0:1:2",
        surface + array + "vertices=0:0,triangles=0:0:1", surface + array + "vertices=0:nan,triangles=0:0:0",
        surface + array + "vertices=0:0:1:0:0:1", surface + "api=ext,indices=u8,format=4," + mesh,
        surface + "api=khr,indices=u8,format=3," + mesh, surface + array + mesh + ",levels=3",
        surface + array + mesh + ",levels=1:1", surface + array + mesh + "," + mesh,
        surface + array + mesh + ",uv=0:0:0:0:0:0", array + mesh})
    EXPECT_THROW(mesh_from(text, 2), BadCase) << text;
}

// The reflection keeps what is equal equal, and all is within.
TEST(MeshCases, AreFittedIntoTheCoordinatesThatAreDeclared) {
  Support support;
  support.uv_max = 1;
  for (std::uint64_t k = 0; k < 100; ++k) {
    const MeshCase mesh = mesh_sample(1, 2, k, false), fit = fitted(support, mesh, k);
    std::map<float, float> to;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const float x = fit.vertices[v][axis];
        EXPECT_TRUE(x >= 0 && x <= 1) << x;
        const float was = mesh.vertices[v][axis];
        const bool within = was >= 0 && was <= 1;
        EXPECT_EQ(x == was, within) << was;
        EXPECT_EQ(to.emplace(mesh.vertices[v][axis], x).first->second, x);
      }
  }
}

TEST(MeshSamples, HaveEveryChoiceOfTheArrayWithEveryOther) {
  std::set<std::string> seen;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const MeshCase mesh = mesh_sample(1, 2, k, true);
    seen.insert(fmt::format("{} {} {}", mmverify::spec::array::requirements(mesh.api).name,
                            mesh.levels.empty(), static_cast<int>(mesh.format)));
    seen.insert(array::name_of(mesh.encoding));
  }
  EXPECT_EQ(seen.size(), 6u * 2 * 2 + 5);
}

TEST(MeshSamples, HaveTrianglesOfEveryFate) {
  std::set<int> kinds;
  bool shared = false;
  for (std::uint64_t k = 0; k < 120; ++k) {
    const MeshCase mesh = mesh_sample(1, 3, k, false);
    const array::Answer answer = built_in("bake")->functions.bake_mesh(mesh).value();
    std::set<std::uint64_t> records;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const array::Target to = array::target_of(answer, build_case(mesh), t);
      const bool special = to.kind == array::Target::Kind::special;
      kinds.insert(special ? static_cast<int>(to.state) : 4);
      shared = shared || (!special && !records.insert(to.record).second);
    }
  }
  EXPECT_EQ(kinds, (std::set<int>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(shared);
}

/// A texture of 8x8 texels, opaque from column 4 on, clamped, and two triangles across the edge.  The second one's corners
/// lie 3/16 of a texel before along u.
MeshCase twins() {
  MeshCase mesh;
  mesh.level = 4;
  mesh.surface.width = mesh.surface.height = 8;
  mesh.surface.wrap_u = mesh.surface.wrap_v = Wrap::clamp_to_edge;
  mesh.surface.alpha.assign(64, 0);
  for (std::size_t k = 0; k < 64; ++k) mesh.surface.alpha[k] = k % 8 >= 4 ? 255 : 0;
  constexpr float apart = -3.0f / 16 / 8;
  mesh.vertices = {{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}};
  for (std::size_t v = 0; v < 3; ++v)
    mesh.vertices.push_back({mesh.vertices[v][0] + apart, mesh.vertices[v][1]});
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

/// A baker of meshes that bakes triangle `source(t)` in the place of triangle t.
BakeSubject baking(std::size_t (*source)(std::size_t)) {
  Functions functions = built_in("bake")->functions;
  functions.bake_mesh = [source, own = own_states(functions)](const MeshCase& mesh) {
    return mesh_array("array", mesh, [&](const MeshCase& of, std::size_t t) { return own(of, source(t)); });
  };
  return {"changed", "", functions};
}

TEST(MeshLaws, RefuteASharedMapThreeSixteenthsOfATexelAway) {
  const MeshCase mesh = twins();
  const BakeSubject right = baking([](std::size_t t) { return t; }),
                    wrong = baking([](std::size_t) { return std::size_t{0}; });
  EXPECT_TRUE(mesh_is_conservative(right, mesh).holds);
  EXPECT_TRUE(mesh_is_as_alone(right, mesh).holds);
  const Finding found = mesh_is_conservative(wrong, mesh);
  ASSERT_FALSE(found.holds);
  EXPECT_THAT(found.words().expected,
              testing::StartsWith("triangle 1 (0.2265625,0.25 0.7265625,0.25 0.2265625,0.75), record 0 of "
                                  "level 4, which triangle 0 has, too: "));
  EXPECT_FALSE(mesh_is_as_alone(wrong, mesh).holds);
  // Their records and counts are in order.
  EXPECT_TRUE(mesh_has_records(wrong, mesh).holds);
  EXPECT_TRUE(mesh_has_counts(wrong, mesh).holds);
}

TEST(MeshLaws, TakeASpecialIndexForTheWholeTriangle) {
  // The small triangle beside the edge is T throughout, the twins are not.
  MeshCase mesh = twins();
  mesh.vertices.insert(mesh.vertices.end(), {{0.25f, 0.25f}, {0.3f, 0.25f}, {0.25f, 0.3f}});
  mesh.triangles.push_back({6, 7, 8});
  const BakeSubject wrong = baking([](std::size_t) { return std::size_t{2}; });
  const Finding found = mesh_is_conservative(wrong, mesh);
  ASSERT_FALSE(found.holds);
  EXPECT_THAT(
      found.words().expected,
      testing::StartsWith("triangle 0 (0.25,0.25 0.75,0.25 0.25,0.75), special T: micro-triangle 0 "));
  EXPECT_EQ(found.words().got, "T");
}

}  // namespace mesh_laws_test
