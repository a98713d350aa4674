// [release] Declared support: what is drawn lies inside it, and states are judged by its rules.
#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <string>

#include "proofs/bake/cases/case.hpp"
#include "proofs/bake/domains/family.hpp"
#include "proofs/bake/domains/samples.hpp"
#include "proofs/bake/domains/strata.hpp"
#include "proofs/bake/support.hpp"
#include "proofs/bake/truth/truth.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::proofs::bake {
namespace bake_support_test {

Set only(auto... values) { return Set((0u | ... | (1u << static_cast<unsigned>(values)))); }

Support clamped_floats() {
  Support s;
  s.texels = only(Texel::unorm8);
  s.filters = only(Filter::bilinear);
  s.wraps = only(Wrap::clamp_to_edge);
  s.blend = s.factors = s.margins = false;
  s.max_mips = 1;
  s.float_cutoffs = true;
  s.above = true;
  s.uv_min = 0;
  s.uv_max = 1;
  return s;
}

Support two_powers() {
  Support s;
  s.texels = only(Texel::unorm16, Texel::float32);
  s.wraps = only(Wrap::repeat, Wrap::mirrored_repeat);
  s.same_wraps = s.powers_of_two = true;
  s.max_side = 256;
  s.max_mips = 3;
  s.fixed_cutoff = Cutoff{1, 2};
  s.uv_min = -2;
  s.uv_max = 2;
  return s;
}

bool inside(const Support& s, const Case& one) {
  const auto fits = [&](std::uint32_t side) {
    return side <= s.max_side && (!s.powers_of_two || std::has_single_bit(side));
  };
  if (!s.texels.has(one.texel) || !s.filters.has(one.filter) || !s.wraps.has(one.wrap_u) ||
      !s.wraps.has(one.wrap_v) || (s.same_wraps && one.wrap_u != one.wrap_v))
    return false;
  if (!fits(one.width) || !fits(one.height) || one.mips > s.max_mips) return false;
  if (one.alpha.size() != texels_of(one.width, one.height, one.mips)) return false;
  if (!s.factors && (one.factor != 1 || one.vertex_factor != 1)) return false;
  if (!s.margins && one.margin != 0) return false;
  if (one.blend ? !s.blend : !s.mask) return false;
  if (!one.blend && s.fixed_cutoff && one.cutoff != *s.fixed_cutoff) return false;
  if (!one.blend && s.float_cutoffs) {
    const double cutoff = static_cast<double>(one.cutoff.numerator) / one.cutoff.denominator;
    if (cutoff > 1 || static_cast<double>(static_cast<float>(cutoff)) != cutoff) return false;
  }
  for (const float x : one.uv)
    if (s.bounded() && !(x >= s.uv_min && x <= s.uv_max)) return false;
  return true;
}

std::vector<Case> drawn() {
  std::vector<Case> all;
  for (std::uint64_t k = 0; k < (sanitized ? 64 : 400); ++k) {
    all.push_back(sample(1, k));
    all.push_back(featured_sample(1, k));
    all.push_back(large_sample(1, k));
    if (k % 4 == 0) all.push_back(stratified(1, 3, k));
  }
  return all;
}

TEST(BakeSupport, NothingDeclaredChangesNothing) {
  EXPECT_TRUE(Support{}.whole());
  EXPECT_EQ(Support{}.text(), "");
  for (const Case& one : drawn()) ASSERT_EQ(text_of(fitted(Support{}, one, 5)), text_of(one));
  EXPECT_EQ(&fitted(bilinear_families(), Support{}), &bilinear_families());
}

TEST(BakeSupport, DrawnCasesLieInsideIt) {
  for (const Support& s : {clamped_floats(), two_powers()}) {
    EXPECT_FALSE(s.whole());
    std::uint64_t k = 0;
    bool outside = false;
    std::set<std::string> texts;
    for (const Case& one : drawn()) {
      outside = outside || !inside(s, one);
      const Case fit = fitted(s, one, ++k);
      ASSERT_TRUE(inside(s, fit)) << text_of(one) << "\n" << text_of(fit);
      ASSERT_TRUE(covers(s, fit)) << text_of(fit);
      ASSERT_EQ(covers(s, one), inside(s, one)) << text_of(one);
      texts.insert(text_of(fit));
    }
    EXPECT_TRUE(outside) << "nothing had to be changed";
    EXPECT_GT(texts.size(), k * 9 / 10) << "cases fell together";
  }
}

TEST(BakeSupport, WhatItHasIsLeftAsItIs) {
  Case one = sample(1, 0);
  one.wrap_u = one.wrap_v = Wrap::clamp_to_edge;
  one.uv = {0.25f, 0, 1, 0.125f, 0.5f, 0.75f};
  one.cutoff = {1, 2};
  Case fit = fitted(clamped_floats(), one, 3);
  EXPECT_TRUE(fit.rules.above);
  fit.rules = {};
  EXPECT_EQ(text_of(fit), text_of(one));
}

TEST(BakeSupport, TextsOfDrawnTexturesComeBack) {
  for (std::uint64_t k = 0; k < 40; ++k) {
    const Case fit = fitted(two_powers(), stratified(1, 2, k), k);
    const Case again = case_from(text_of(fit));
    ASSERT_EQ(again.alpha, fit.alpha) << text_of(fit);
    ASSERT_EQ(text_of(again), text_of(fit));
  }
}

TEST(BakeSupport, FloatCutoffsAreBinary32sNumbers) {
  EXPECT_EQ(float_cutoff({1, 2}), (Cutoff{1, 2}));
  EXPECT_EQ(float_cutoff({0, 7}), (Cutoff{0, 1}));
  EXPECT_EQ(float_cutoff({3, 2}), (Cutoff{1, 1}));
  // 128/255 = 0.50196..., of which binary32 keeps 24 bits: 8421505 / 2^24.
  EXPECT_EQ(float_cutoff({128, 255}), (Cutoff{8421505, 1u << 24}));
}

TEST(BakeSupport, ConvertedTexelsAreTheNearestOnes) {
  EXPECT_EQ(converted(Texel::unorm8, Texel::unorm16, 128), 128u * 257u);
  EXPECT_EQ(converted(Texel::unorm16, Texel::unorm8, 65535), 255u);
  EXPECT_EQ(converted(Texel::unorm16, Texel::unorm8, 128), 0u);
  EXPECT_EQ(converted(Texel::unorm16, Texel::unorm8, 129), 1u);
  EXPECT_EQ(converted(Texel::float32, Texel::unorm8, std::bit_cast<std::uint32_t>(-3.0f)), 0u);
  EXPECT_EQ(converted(Texel::unorm8, Texel::float32, 255), std::bit_cast<std::uint32_t>(1.0f));
}

// Fitting keeps the number of cases, and each case lies inside the support. Cases are distinct except where turning a
// triangle gives the same one. Their truth is the specification's.
TEST(BakeSupport, FamiliesAreFittedWhole) {
  for (const Support& s : {clamped_floats(), two_powers()}) {
    const Families& fit = fitted(bilinear_families(), s);
    ASSERT_EQ(fit.count(), bilinear_families().count());
    std::set<std::string> texts;
    for (std::uint64_t k = 0; k < fit.count(); ++k) {
      const Case one = fit.at(k);
      ASSERT_TRUE(inside(s, one)) << text_of(one);
      texts.insert(text_of(one));
    }
    EXPECT_GT(texts.size(), fit.count() * 3 / 4);
    for (std::uint64_t k = 5; k < fit.count(); k += sanitized ? 9'001 : 997) {
      const std::vector<State> truth = fit.truth(2, k);
      for (std::uint32_t index = 0; index < 16; ++index)
        ASSERT_EQ(truth[index], true_state(fit.at(k), 2, index)) << text_of(fit.at(k)) << " " << index;
    }
  }
}

// ---- Rules

Case uniform(std::uint32_t byte) {
  Case one;
  one.alpha = {byte};
  one.cutoff = {byte, 255};
  one.uv = {0, 0, 1, 0, 0, 1};
  return one;
}

TEST(BakeRules, AtTheCutoffOrAboveIt) {
  Case one = uniform(128);
  EXPECT_EQ(true_state(one, 0, 0), State::O);
  one.rules.above = true;
  EXPECT_EQ(true_state(one, 0, 0), State::T);
}

// Two columns, transparent and opaque, sampled nearest: the triangle meets the second along its edge alone.
TEST(BakeRules, AContactWithoutAnAreaCountsWhereMicroTrianglesAreClosed) {
  Case one;
  one.width = 2;
  one.alpha = {0, 255};
  one.filter = Filter::nearest;
  one.wrap_u = one.wrap_v = Wrap::clamp_to_edge;
  one.uv = {0, 0, 0.5f, 0, 0.5f, 1};
  EXPECT_EQ(true_state(one, 0, 0), State::UT);
  one.rules.contact = spec::bake::Contact::open;
  EXPECT_EQ(true_state(one, 0, 0), State::T);
  one.uv[0] = 0.75f;  // now on the other side
  EXPECT_EQ(true_state(one, 0, 0), State::O);
  one.uv[0] = 0.25f, one.uv[2] = 0.5078125f;
  EXPECT_EQ(true_state(one, 0, 0), State::UT) << "a sliver is an area";
}

// Alpha rises from 0 at u = 1/4 to 1 at u = 3/4: the cutoff is met on the edge u = 1/2.
TEST(BakeRules, TheCutoffMetOnAnEdgeIsNoArea) {
  Case one;
  one.width = 2;
  one.alpha = {0, 255};
  one.wrap_u = one.wrap_v = Wrap::clamp_to_edge;
  one.cutoff = {1, 2};
  one.uv = {0.25f, 0, 0.5f, 0, 0.5f, 1};
  EXPECT_EQ(true_state(one, 0, 0), State::UT);
  one.rules.contact = spec::bake::Contact::open;
  EXPECT_EQ(true_state(one, 0, 0), State::T);
  // All of it at the cutoff is an area.
  Case flat = uniform(51);
  flat.rules.contact = spec::bake::Contact::open;
  EXPECT_EQ(true_state(flat, 0, 0), State::O);
  flat.rules.above = true;
  EXPECT_EQ(true_state(flat, 0, 0), State::T);
  // A triangle without an area is taken as closed.
  one.uv = {0.5f, 0, 0.5f, 0, 0.5f, 1};
  EXPECT_EQ(true_state(one, 0, 0), State::O);
}

TEST(BakeRules, ASlackIsBothSidesOfTheCutoff) {
  Case one = uniform(128);
  one.cutoff = {129, 255};
  EXPECT_EQ(true_states(one, 0, {0}).lower.front(), State::T);
  one.rules.slack = 0x1p-7f;
  const Truth truth = true_states(one, 0, {0});
  EXPECT_EQ(truth.lower.front(), State::O) << "128/255 >= 129/255 - 1/128";
  EXPECT_EQ(truth.upper.front(), State::T);
  one.rules.slack = 0x1p-9f;
  EXPECT_EQ(true_states(one, 0, {0}).lower.front(), State::T);
}

TEST(BakeRules, FixedPointHasItsSlack) {
  Support s;
  s.weight_bits = 8;
  Case one;
  one.width = 2;
  one.alpha = {51, 153};  // a range of 2/5
  one.uv = {0, 0, 1, 0, 0, 1};
  // 2^-8 of it, rounded up to binary32.
  EXPECT_NEAR(fitted(s, one, 0).rules.slack, 0.4 / 256, 1e-9);
  EXPECT_GE(static_cast<double>(fitted(s, one, 0).rules.slack), 0.4 / 256);
  s.coordinate_bits = 8;
  EXPECT_NEAR(fitted(s, one, 0).rules.slack, 0.8 / 256, 1e-9);
  one.alpha = {51, 51};
  EXPECT_EQ(fitted(s, one, 0).rules.slack, 0);
}

TEST(BakeRules, StandInTheText) {
  Case one = uniform(128);
  one.rules = {true, spec::bake::Contact::open, 0x1p-8f};
  const std::string text = text_of(one);
  EXPECT_NE(text.find("opaque=above,contact=open,slack=0x1p-8"), std::string::npos) << text;
  EXPECT_EQ(case_from(text).rules, one.rules);
  EXPECT_THROW(case_from("texels=u8:1x1:80,wrap=clamp:clamp,cutoff=1/2,opaque=below,uv=0:0:1:0:0:1"),
               BadCase);
  EXPECT_THROW(case_from("texels=u8:1x1:80,wrap=clamp:clamp,cutoff=1/2,slack=-1,uv=0:0:1:0:0:1"), BadCase);
}

}  // namespace bake_support_test
}  // namespace mmverify::proofs::bake
