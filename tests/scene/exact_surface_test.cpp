// [release] The exact states of a scene's triangles: those that whole numbers do not find take rationals, and are counted.
#include "proofs/scene/exact_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/made_scene.hpp"

namespace mmverify::tests {
namespace scene_exact_surface_test {

using spec::bake::State;

TEST(ExactSurfaces, ATriangleOverTooManyRowsTakesRationals) {
  mmverify::scene::Scene s = made_scene();
  // From the disc's middle, and from a transparent corner, over 2^18 repeats of 16 rows.
  s.primitives[0].uvs = {{0.4f, 0.5f}, {0x1p18f, 0.5f}, {0.4f, 0x1p18f}};
  s.primitives[0].positions.resize(3);
  s.primitives[0].triangles = {{0, 1, 2}};
  const auto plan = mmverify::scene::plan(s);
  ASSERT_EQ(plan.triangles.size(), 1u);
  const proofs::scene::ExactSurfaces exact(s, plan, 0);
  EXPECT_EQ(exact.state(0, 0, 0), State::C);
  EXPECT_EQ(exact.in_rationals(), 1u);
  EXPECT_TRUE(exact.state(0, 12, 0)) << "fewer rows";
  EXPECT_EQ(exact.in_rationals(), 1u);
}

TEST(ExactSurfaces, TheNumberIsASentence) {
  const Made made;
  proofs::scene::SceneLaws laws =
      proofs::scene::map_laws(made.data(), {}, "maps", "mmverify check maps maps");
  EXPECT_EQ(proofs::scene::rationals_text(laws), std::nullopt) << "none yet";
  EXPECT_EQ(proofs::scene::rationals_text({}), std::nullopt) << "no laws";
  laws.exact->state(0, 0, 0);
  EXPECT_EQ(proofs::scene::rationals_text(laws), std::nullopt) << "whole numbers suffice";
  mmverify::scene::Scene s = made_scene();
  s.primitives[0].uvs[2] = {0x1p19f, 0x1p19f};
  const Made far(0u, {}, s);
  proofs::scene::SceneLaws others =
      proofs::scene::map_laws(far.data(), {}, "maps", "mmverify check maps maps");
  others.exact->state(0, 0, 0);
  EXPECT_THAT(proofs::scene::rationals_text(others).value_or(""),
              testing::StartsWith("1 of the exact states took rationals: "));
}

}  // namespace scene_exact_surface_test
}  // namespace mmverify::tests
