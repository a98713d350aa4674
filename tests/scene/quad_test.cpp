// The Quad: two triangles that show all of two textures.
#include "scene/sample/quad.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/plan/plan.hpp"
#include "scene/read/attributes.hpp"
#include "scene/read/load.hpp"

namespace mmverify::tests::quad_test {
namespace {

using namespace scene;

TEST(Quad, IsTwoTrianglesWithTwoTexturesOf1024) {
  const Bytes bytes = quad_scene();
  EXPECT_EQ(bytes, quad_scene());
  EXPECT_EQ(count_triangles(load("quad", bytes)).unique, 2u);
  EXPECT_TRUE(plan(load("quad", bytes)).triangles.empty()) << "nothing is tested";
  const AttributeScene read = load_attributes("quad", bytes);
  EXPECT_EQ(read.triangles, 2u);
  ASSERT_EQ(read.textures.size(), 2u);
  ASSERT_EQ(read.primitives.size(), 1u);
  for (const AttributeTexture& texture : read.textures) {
    EXPECT_EQ(read.images[texture.image].width, 1024u);
    EXPECT_EQ(read.images[texture.image].height, 1024u);
  }
  // The halves show all texels, each once: their UVs have the area of the square.
  double area = 0;
  for (const Triangle& t : read.primitives[0].triangles) {
    const auto& uvs = read.primitives[0].uses[0].uvs;
    const double x1 = uvs[t[1]][0] - uvs[t[0]][0], y1 = uvs[t[1]][1] - uvs[t[0]][1],
                 x2 = uvs[t[2]][0] - uvs[t[0]][0], y2 = uvs[t[2]][1] - uvs[t[0]][1];
    area += std::fabs(x1 * y2 - x2 * y1) / 2;
  }
  EXPECT_EQ(area, 1);
}

TEST(Quad, HasNormalsOfLengthOne) {
  const AttributeScene read = load_attributes("quad", quad_scene());
  for (const AttributeTexture& texture : read.textures) {
    if (!has(texture.set, Attribute::normal)) continue;
    const ColourImage& image = read.images[texture.image];
    for (std::size_t k = 0; k < std::size_t{1024} * 1024; k += 37) {
      double squares = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double n = 2 * image.rgba[4 * k + c] / 255.0 - 1;
        squares += n * n;
      }
      ASSERT_NEAR(std::sqrt(squares), 1, 0.01) << k;
    }
    return;
  }
  FAIL() << "no texture of normals";
}

}  // namespace
}  // namespace mmverify::tests::quad_test
