// scene/: the sample scene is what its header says, and looks like it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "scene/plan/plan.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "scene/sample/textures.hpp"
#include "scene/validate/micromaps.hpp"

namespace {

using namespace mmverify::scene;
using testing::IsEmpty;

const Scene& sample() {
  static const Scene scene = load("sample.glb", sample_scene());
  return scene;
}

const Image& image(const std::string& name) {
  for (const Image& image : sample().images)
    if (image.name == name) return image;
  throw std::runtime_error("no image " + name);
}

double alpha(const std::string& name, double u, double v) {
  const Image& picture = image(name);
  const auto x = static_cast<std::size_t>(u * picture.width),
             y = static_cast<std::size_t>(v * picture.height);
  return std::get<0>(picture.alpha).at(x + picture.width * y) / 255.0;
}

TEST(SceneSample, IsTheSameEveryTime) {
  EXPECT_EQ(sample_scene(), sample_scene());
  EXPECT_LT(sample_scene().size(), 300'000u);
  EXPECT_THAT(validate_micromaps("sample.glb", sample_scene()), IsEmpty());
}

TEST(SceneSample, EveryReasonableReasonOnce) {
  std::map<LeftOut, int> reasons;
  for (const LeftOutPrimitive& left : plan(sample()).left_out) ++reasons[left.why];
  for (const LeftOut why : {LeftOut::no_triangles, LeftOut::not_placed, LeftOut::material_variants,
                            LeftOut::animated, LeftOut::no_texture})
    EXPECT_EQ(reasons[why], 1) << sentence(why);
  EXPECT_EQ(reasons[LeftOut::opaque], 3);       // stalk, post, bed
  EXPECT_EQ(reasons[LeftOut::morphed_uvs], 2);  // one moves its UVs, one its vertex colours
  // A MASK material without its picture, its UVs, with one of specular-glossiness, or a colour beyond 1: nobody means that.
  EXPECT_EQ(reasons.size(), 7u);
}

TEST(SceneSample, ThePlan) {
  const Plan planned = plan(sample());
  ASSERT_EQ(planned.primitives.size(), 5u);  // leaf cards, flower, grass, fence, pond
  std::map<std::string, std::pair<std::size_t, std::set<std::uint32_t>>> by_mesh;
  for (const PlannedPrimitive& primitive : planned.primitives) {
    auto& [triangles, distinct] =
        by_mesh[sample().meshes[sample().primitives[primitive.primitive].mesh].name];
    triangles = primitive.triangles.size();
    for (const TriangleUse& use : primitive.triangles) distinct.insert(use.triangle);
  }
  EXPECT_EQ(by_mesh["plant"].first, 48u);
  EXPECT_EQ(by_mesh["plant"].second.size(), 8u);  // two leaves, each cut along either diagonal
  EXPECT_EQ(by_mesh["fence panel"].first, 8u);
  EXPECT_EQ(by_mesh["fence panel"].second.size(), 2u);  // but for whole repeats of the texture
  EXPECT_EQ(by_mesh["flower"].first, 8u);
  EXPECT_EQ(by_mesh["grass"].first, 6u);
  EXPECT_EQ(by_mesh["pond"].first, 18u);
  std::set<std::array<std::uint8_t, 3>> orders;
  for (const PlannedPrimitive& primitive : planned.primitives)
    for (const TriangleUse& use : primitive.triangles) orders.insert(use.order);
  EXPECT_EQ(orders.size(), 6u);  // turned and mirrored, every way there is
  for (const PlannedTriangle& triangle : planned.triangles) {
    EXPECT_EQ(triangle.shape, UvShape::area);
    EXPECT_GE(triangle.level.level, 4u);
    EXPECT_LE(triangle.level.level, 9u);
  }
  EXPECT_EQ(count_triangles(sample()).placed, 3 * 58 + 2 * 8 + 30 * 6 + 3 * 8 + 4 * 10 + 2 + 18 + 5 * 2);
}

// Pairs whose maps are squares: two triangles that share an edge in position and UV.
TEST(SceneSample, QuadsOfCardsArePairs) {
  for (const Primitive& primitive : sample().primitives) {
    if (sample().meshes[primitive.mesh].name != "plant" || primitive.uvs.empty()) continue;
    for (std::size_t t = 0; t < primitive.triangles.size(); t += 2) {
      EXPECT_EQ(primitive.triangles[t][0], primitive.triangles[t + 1][0]);
      EXPECT_EQ(primitive.triangles[t][2], primitive.triangles[t + 1][1]);
    }
  }
}

// The picture's foot lies at the stalk, however a card is turned: its lower corners are nearer to the axis.
TEST(SceneSample, LeavesGrowOutwards) {
  for (const Primitive& primitive : sample().primitives) {
    if (sample().meshes[primitive.mesh].name != "plant" || primitive.uvs.empty()) continue;
    const auto from_axis = [&](std::size_t k) {
      return std::hypot(primitive.positions[k][0], primitive.positions[k][2]);
    };
    for (std::size_t card = 0; card < primitive.positions.size(); card += 4) {
      double foot = 0, tip = 9;
      for (std::size_t k = card; k < card + 4; ++k)
        if (primitive.uvs[k][1] == 1)
          foot = std::max(foot, double{from_axis(k)});
        else
          tip = std::min(tip, double{from_axis(k)});
      EXPECT_LT(foot, tip) << card / 4;
    }
  }
}

TEST(SceneSample, ThePicturesAreOfWhatTheyAreCalled) {
  EXPECT_EQ(alpha("leaves", 0.25, 0.5), 1);  // in the middle of the one leaf
  EXPECT_EQ(alpha("leaves", 0.75, 0.5), 1);  // on the stalk of the other
  for (const double u : {0.0, 0.499, 0.5, 0.999})
    for (double v = 0; v < 1; v += 0.01) EXPECT_EQ(alpha("leaves", u, v), 0) << u << " " << v;
  EXPECT_EQ(alpha("flower", 0.5, 0.5), 1);
  EXPECT_EQ(alpha("flower", 0.5, 0.2), 1);  // a petal
  EXPECT_EQ(alpha("flower", 0.5, 0.9), 0);  // between two
  EXPECT_EQ(alpha("pond", 0, 0), 0);
  // Uniform, with the texels that filtering reaches: the middle quad of 3 x 3; what is above the grass.
  for (double u = 0; u < 1; u += 0.01)
    for (double v = 0; v < 1; v += 0.01) {
      const bool water = std::max(std::abs(u - 0.5), std::abs(v - 0.5)) < 0.18;
      ASSERT_EQ(alpha("pond", u, v), water ? 1 : alpha("pond", u, v)) << u << " " << v;
      ASSERT_EQ(alpha("blades", u, v), v < 0.2 ? 0 : alpha("blades", u, v)) << u << " " << v;
    }
  // The fence's repeats without a seam: across it as in the middle, wires cross at both.
  const std::size_t side = image("wire").width;
  const auto& wire = std::get<0>(image("wire").alpha);
  const auto shifted = [&](std::size_t x) { return (x + side / 2) % side; };
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x)
      ASSERT_EQ(wire[x + side * y], wire[shifted(x) + side * shifted(y)]) << x << " " << y;
  // Every picture has texels inside, outside, and between.
  for (const char* name : {"leaves", "wire", "flower", "blades", "pond"}) {
    const auto& texels = std::get<0>(image(name).alpha);
    const auto share = [&](auto in) {
      return static_cast<double>(std::count_if(texels.begin(), texels.end(), in)) /
             static_cast<double>(texels.size());
    };
    EXPECT_GT(share([](int a) { return a == 0; }), 0.1) << name;
    EXPECT_GT(share([](int a) { return a == 255; }), 0.1) << name;
    EXPECT_GT(share([](int a) { return a != 0 && a != 255; }), 0.02) << name;
  }
}

}  // namespace
