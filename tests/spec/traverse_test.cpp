// [release] spec/traverse/ against rows that the specifications state, worked out by hand.
#include <gtest/gtest.h>

#include <array>

#include "spec/traverse/blend.hpp"
#include "spec/traverse/decision.hpp"

namespace spec_traverse_test {

using namespace mmverify::spec::traverse;
using enum Outcome;

constexpr State all_states[] = {State::T, State::O, State::UT, State::UO};
constexpr Instance no_instance_flags{}, force_opaque{.force_opaque = true},
    force_no_opaque{.force_no_opaque = true}, force_two_state{.force_two_state = true},
    disabled{.disable_micromaps = true};
constexpr Ray no_ray_flags{}, ray_opaque{.opaque = true}, ray_no_opaque{.no_opaque = true},
    cull_opaque{.cull_opaque = true}, cull_no_opaque{.cull_no_opaque = true},
    ray_two_state{.force_two_state = true};

Outcome of(State s, const Instance& instance, const Ray& ray, bool geometry_opaque = false) {
  return decide({Api::khr_pipeline, true, {Held::four_state, s, geometry_opaque}, instance, ray});
}

Outcome without(bool geometry_opaque, const Instance& instance, const Ray& ray) {
  return decide({Api::khr_pipeline, true, {Held::nothing, State::T, geometry_opaque}, instance, ray});
}

/// The outcomes of T, O, UT, UO.
using Row = std::array<Outcome, 4>;
Row row(const Instance& instance, const Ray& ray, bool geometry_opaque = false) {
  Row all{};
  for (std::size_t k = 0; k < 4; ++k) all[k] = of(all_states[k], instance, ray, geometry_opaque);
  return all;
}

// The eight rows of the table of Ray Opacity Micromap, Y and N of "2 State override".
TEST(SpecTraverse, TheTableOfVulkansChapter) {
  EXPECT_EQ(row(no_instance_flags, no_ray_flags), (Row{ignored, opaque, non_opaque, non_opaque}));
  EXPECT_EQ(row(force_two_state, no_ray_flags), (Row{ignored, opaque, ignored, opaque}));
  EXPECT_EQ(row(no_instance_flags, ray_two_state), (Row{ignored, opaque, ignored, opaque}));
  EXPECT_EQ(row(force_two_state, ray_two_state), (Row{ignored, opaque, ignored, opaque}));
}

// "the micromap is used to determine geometry opacity instead of the VK_GEOMETRY_OPAQUE_BIT_KHR flag"
TEST(SpecTraverse, TheMicromapStandsInThePlaceOfTheGeometrysFlag) {
  EXPECT_EQ(row(no_instance_flags, no_ray_flags, true), (Row{ignored, opaque, non_opaque, non_opaque}));
  EXPECT_EQ(row(disabled, no_ray_flags, true), (Row{opaque, opaque, opaque, opaque}));
  EXPECT_EQ(row(disabled, no_ray_flags, false), (Row{non_opaque, non_opaque, non_opaque, non_opaque}));
  // DXR: DISABLE_OMMS takes precedence over RAY_FLAG_FORCE_OMM_2_STATE.
  EXPECT_EQ(row(disabled, ray_two_state, false), (Row{non_opaque, non_opaque, non_opaque, non_opaque}));
  EXPECT_EQ(without(true, no_instance_flags, no_ray_flags), opaque);
  EXPECT_EQ(without(false, no_instance_flags, no_ray_flags), non_opaque);
}

// DXR: there is no way to turn a transparent micro-triangle's miss into a hit by force-opaque flags.
TEST(SpecTraverse, FlagsComeAfterTheLookup) {
  EXPECT_EQ(row(force_opaque, no_ray_flags), (Row{ignored, opaque, opaque, opaque}));
  EXPECT_EQ(row(force_no_opaque, no_ray_flags), (Row{ignored, non_opaque, non_opaque, non_opaque}));
  EXPECT_EQ(row(no_instance_flags, ray_opaque), (Row{ignored, opaque, opaque, opaque}));
  EXPECT_EQ(row(no_instance_flags, ray_no_opaque), (Row{ignored, non_opaque, non_opaque, non_opaque}));
  // With force-2-state UT is ignored as well, and NoOpaque calls the shader for what was read as opaque.
  EXPECT_EQ(row(force_two_state, ray_opaque), (Row{ignored, opaque, ignored, opaque}));
  EXPECT_EQ(row(force_two_state, ray_no_opaque), (Row{ignored, non_opaque, ignored, non_opaque}));
}

// FORCE_OPAQUE "can be overridden by the SPIR-V NoOpaqueKHR ray flag", FORCE_NO_OPAQUE by OpaqueKHR.
TEST(SpecTraverse, TheRayOverridesTheInstance) {
  EXPECT_EQ(row(force_opaque, ray_no_opaque), (Row{ignored, non_opaque, non_opaque, non_opaque}));
  EXPECT_EQ(row(force_no_opaque, ray_opaque), (Row{ignored, opaque, opaque, opaque}));
  EXPECT_EQ(without(true, force_no_opaque, no_ray_flags), non_opaque);
  EXPECT_EQ(without(false, force_no_opaque, ray_opaque), opaque);
  EXPECT_EQ(without(true, force_opaque, ray_no_opaque), non_opaque);
}

// "an intersection with a geometry that is considered opaque is dropped", after the overrides.
TEST(SpecTraverse, CullingLooksAtTheOpacityThatIsLeft) {
  EXPECT_EQ(row(no_instance_flags, cull_opaque), (Row{ignored, ignored, non_opaque, non_opaque}));
  EXPECT_EQ(row(no_instance_flags, cull_no_opaque), (Row{ignored, opaque, ignored, ignored}));
  EXPECT_EQ(row(force_opaque, cull_opaque), (Row{ignored, ignored, ignored, ignored}));
  EXPECT_EQ(row(force_opaque, cull_no_opaque), (Row{ignored, opaque, opaque, opaque}));
  EXPECT_EQ(row(force_no_opaque, cull_opaque), (Row{ignored, non_opaque, non_opaque, non_opaque}));
  EXPECT_EQ(row(force_two_state, cull_opaque), (Row{ignored, ignored, ignored, ignored}));
  EXPECT_EQ(row(force_two_state, cull_no_opaque), (Row{ignored, opaque, ignored, opaque}));
  EXPECT_EQ(without(true, no_instance_flags, cull_opaque), ignored);
  EXPECT_EQ(without(false, no_instance_flags, cull_opaque), non_opaque);
  EXPECT_EQ(without(false, force_opaque, cull_no_opaque), opaque);
}

TEST(SpecTraverse, RayFlagsExcludeEachOther) {
  Combination c{.api = Api::dxr_pipeline};
  for (const Ray& one : {no_ray_flags, ray_opaque, ray_no_opaque, cull_opaque, cull_no_opaque}) {
    c.ray = one;
    EXPECT_EQ(undefined(c), Undefined{});
    c.ray.force_two_state = true;  // goes with any
    EXPECT_EQ(undefined(c), Undefined{});
  }
  for (const Ray& two : {Ray{true, true}, Ray{true, false, true}, Ray{false, true, true},
                         Ray{true, false, false, true}, Ray{false, false, true, true}}) {
    c.ray = two;
    EXPECT_EQ(undefined(c), Undefined{.ray_flags = true});
  }
  c.ray = {};
  c.instance = {true, true};
  EXPECT_EQ(undefined(c), Undefined{.instance_flags = true});
}

// SPV_KHR_opacity_micromap: without the execution mode a ray query on micromaps is undefined; so are DXR's without
// their flags.  EXT has no switch for ray queries.
TEST(SpecTraverse, ATraceIsSetUpForMicromaps) {
  for (const Api api :
       {Api::ext_pipeline, Api::khr_pipeline, Api::khr_query, Api::dxr_pipeline, Api::dxr_query}) {
    Combination c{api, false, {Held::special, State::O, false}};
    EXPECT_TRUE(has_switch(api));
    EXPECT_EQ(undefined(c), Undefined{.not_enabled = true});
    c.instance = disabled;  // the triangle still has one
    EXPECT_EQ(undefined(c), Undefined{.not_enabled = true});
    c.candidate.held = Held::nothing;
    EXPECT_EQ(undefined(c), Undefined{});
    EXPECT_EQ(decide(c), non_opaque);
  }
  EXPECT_FALSE(has_switch(Api::ext_query));
}

TEST(SpecTraverse, ATwoStateMapHasNoUnknownStates) {
  for (const State s : all_states) {
    EXPECT_EQ(exists({Held::two_state, s, false}), s == State::T || s == State::O);
    EXPECT_TRUE(exists({Held::four_state, s, false}));
    EXPECT_TRUE(exists({Held::special, s, false}));
  }
}

// ---- Blending

TEST(SpecTraverse, OperationsOnCodes) {
  EXPECT_EQ(blend(Operation::max, 7, 200, 0), 200u);
  EXPECT_EQ(blend(Operation::min, 7, 200, 0), 7u);
  EXPECT_EQ(blend(Operation::add, 100, 155, 0), 255u);
  EXPECT_EQ(blend(Operation::add, 100, 156, 0), 255u);
  EXPECT_EQ(blend(Operation::add, 100, 1, 0), 101u);
  // 255 is 1.  128 * 128 / 255 = 64.25, 2 * 64 / 255 = 0.502, 2 * 63 / 255 = 0.494.
  EXPECT_EQ(blend(Operation::multiply, 255, 93, 0), 93u);
  EXPECT_EQ(blend(Operation::multiply, 128, 128, 0), 64u);
  EXPECT_EQ(blend(Operation::multiply, 2, 64, 0), 1u);
  EXPECT_EQ(blend(Operation::multiply, 2, 63, 0), 0u);
  // Opaque hides the payload, transparent leaves it; 200 * (255 - 51) / 255 = 160.
  EXPECT_EQ(blend(Operation::over, 200, 30, 255), 30u);
  EXPECT_EQ(blend(Operation::over, 200, 0, 0), 200u);
  EXPECT_EQ(blend(Operation::over, 200, 30, 51), 190u);
  EXPECT_EQ(blend(Operation::over, 255, 100, 0), 255u);
}

TEST(SpecTraverse, OverTakesTheValuesAlphaForEachChannel) {
  EXPECT_EQ(blend(Operation::over, Colour{200, 100, 0, 255}, Colour{30, 10, 51, 51}),
            (Colour{190, 90, 51, 255}));
  EXPECT_EQ(blend(Operation::max, Colour{200, 100, 0, 255}, Colour{30, 110, 51, 51}),
            (Colour{200, 110, 51, 255}));
}

// Products of codes and their quotients by 255: never halfway, since 255 is odd.
TEST(SpecTraverse, TheNearestCode) {
  for (std::uint32_t x = 0; x <= 255 * 255; ++x) {
    const std::uint32_t code = nearest(x);
    ASSERT_LT(2 * (code > x / 255 ? code * 255 - x : x - code * 255), 255u) << x;
  }
}

// The paper's figure 6 with an accepted hit in front: max of what lies behind it stays or not.
TEST(SpecTraverse, AnAcceptedHitDoesNotTakeBackWhatWasMetBefore) {
  const Hit wall{1, true, {}}, glass{2, false, {2, 2, 2, 2}};
  constexpr Colour nothing{0, 0, 0, 0}, two{2, 2, 2, 2};
  EXPECT_EQ(blended_as_met(Operation::max, nothing, std::array{wall, glass}), nothing);
  EXPECT_EQ(blended_as_met(Operation::max, nothing, std::array{glass, wall}), two);
  EXPECT_EQ(blended_before_closest(Operation::max, nothing, std::array{wall, glass}), nothing);
  EXPECT_EQ(blended_before_closest(Operation::max, nothing, std::array{glass, wall}), nothing);
  const Hit near{0, false, {1, 1, 1, 1}};
  for (const auto& hits :
       {std::array{near, wall, glass}, std::array{glass, wall, near}, std::array{wall, glass, near}})
    EXPECT_EQ(blended_before_closest(Operation::add, nothing, hits), (Colour{1, 1, 1, 1}));
}

}  // namespace spec_traverse_test
