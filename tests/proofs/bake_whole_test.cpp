// [release] States in whole numbers are those in rationals: on every case of the enumerated families, and on stiff samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "proofs/bake/domains/family.hpp"
#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/truth.hpp"
#include "proofs/bake/truth/whole_truth.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"
#include "spec/bake/whole/texture.hpp"

namespace bake_whole_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::bake;
using LawRun = Run;  // inside a test, Run is a member function of GoogleTest's
using States = std::vector<std::optional<State>>;

std::vector<std::uint32_t> all_of(Level n) {
  std::vector<std::uint32_t> all(std::size_t{1} << 2 * n);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// Whole numbers as a baker.  It declines a case with a state that they do not find.
BakeSubject baker() {
  Functions functions;
  functions.bake = [](const Case& one, Level n, Format format) -> std::optional<Baked> {
    Baked baked;
    for (const auto& state : whole_states(one, n, all_of(n))) {
      if (!state) return std::nullopt;
      baked.states.push_back(format == Format::two_state ? mmverify::spec::micromap::force2(*state) : *state);
    }
    return baked;
  };
  functions.centroid = true;
  functions.support.moving = true;
  return {"bake-whole", "states in whole numbers", functions};
}

Result judged(const std::string& law, Level n) { return run_level(*find_law(law), baker(), n, LawRun{}); }

// The families of bake.conservative, tight and unknown_side, of their _nearest and of their _blend.
TEST(BakeWhole, EveryCaseOfTheFamiliesHasTheSpecificationsStates) {
  for (const Families* families : {&bilinear_families(), &nearest_families(), &blend_families()})
    for (Level n = 0; n <= 2; ++n) {
      const std::vector<std::uint32_t> at = all_of(n);
      for (std::uint64_t k = 0; k < families->count(); ++k) {
        const std::vector<State> truth = families->truth(n, k);
        const States found = whole_states(families->at(k), n, at);
        ASSERT_TRUE(std::equal(found.begin(), found.end(), truth.begin(), truth.end()))
            << text_of(families->at(k)) << " level " << n;
      }
    }
}

TEST(BakeWhole, StiffSamplesHaveTheSpecificationsStates) {
  for (const char* rule : {"conservative", "tight", "unknown_side"})
    for (const char* on : {"on_samples", "on_features", "on_strata", "on_spans"})
      for (const Level n : {0u, 2u}) {
        const Result result = judged(std::string("bake.") + rule + "_" + on, n);
        EXPECT_NE(result.verdict, Verdict::refuted) << rule << ' ' << on << " level " << n;
        EXPECT_NE(result.verdict, Verdict::incomplete) << rule << ' ' << on << " level " << n;
      }
  for (const char* law : {"bake.conservative_on_sides", "bake.moving"})
    for (Level n = 0; n <= 1; ++n) EXPECT_EQ(judged(law, n).verdict, Verdict::checked) << law;
}

// ---- Samples of which each input is drawn on its own

/// A case, a level and a micro-triangle.
struct Sample {
  Case one;
  Level level;
  std::uint32_t index;
};

float any_number(Random& random) { return static_cast<float>(random.between(-4096, 4096)) / 1024; }

/// Texels over a few values, so that many are alike and many are at the cutoff.
void draw_texture(Random& random, Case& one) {
  one.width = static_cast<std::uint32_t>(random.below(4) == 0 ? 1 : random.between(2, 9));
  one.height = static_cast<std::uint32_t>(random.below(4) == 0 ? 1 : random.between(2, 9));
  if (random.below(16) == 0) one.width = static_cast<std::uint32_t>(random.between(60, 200));
  one.texel = static_cast<Texel>(random.below(3));
  one.mips = random.below(4) == 0 && (one.width > 1 || one.height > 1) ? 2 : 1;
  const auto stored = [&](std::uint64_t of_eight) -> std::uint32_t {
    if (one.texel == Texel::unorm8) return static_cast<std::uint32_t>(of_eight * 51 % 256);
    if (one.texel == Texel::unorm16) return static_cast<std::uint32_t>(of_eight * 13107 % 65536);
    return std::bit_cast<std::uint32_t>(static_cast<float>(of_eight) / 4 - 0.25f);
  };
  const std::uint64_t few = 2 + random.below(7);
  one.alpha.clear();
  for (std::uint64_t k = texels_of(one.width, one.height, one.mips); k-- > 0;)
    one.alpha.push_back(stored(random.below(few)));
  one.border = stored(random.below(8));
  one.filter = random.below(2) == 0 ? Filter::nearest : Filter::bilinear;
  one.wrap_u = static_cast<Wrap>(random.below(5));
  one.wrap_v = static_cast<Wrap>(random.below(5));
}

void draw_threshold(Random& random, Case& one) {
  one.blend = random.below(3) == 0;
  one.rules.above = random.below(4) == 0;
  const std::uint64_t kind = random.below(3);
  if (kind == 0) one.cutoff = {static_cast<std::uint32_t>(random.below(6)), 5};  // ties with texels
  if (kind == 1) one.cutoff = {static_cast<std::uint32_t>(random.below(256)), 255};
  if (kind == 2) one.cutoff = {0x12345678, 0xfedcba98};
  if (random.below(3) == 0) one.factor = random.below(2) == 0 ? 0.5f : 0.3f;
  if (random.below(3) == 0) one.vertex_factor = random.below(2) == 0 ? 0.25f : 0x1.234568p-3f;
  if (random.below(3) == 0) one.margin = random.below(2) == 0 ? 0.25f : 0x1.8p-9f;
  for (float& travel : one.travel)
    if (random.below(4) == 0) travel = random.below(2) == 0 ? 0.125f : 0x1.abcdp-7f;
}

/// Coordinates on lines of texels, an ulp beside them, far away, tiny; a triangle, a sliver, a segment or a point.
void draw_triangle(Random& random, Case& one) {
  constexpr float places[] = {0, 0, 0, -3, 1000, -0x1p18f};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const float place = places[random.below(6)],
                size = std::ldexp(1.0f, static_cast<int>(random.between(-8, 2)));
    const auto texels = static_cast<float>(axis == 0 ? one.width : one.height);
    for (std::size_t k = 0; k < 3; ++k) {
      float& x = one.uv[2 * k + axis];
      x = place + size * any_number(random);
      if (random.below(3) == 0) x = place + static_cast<float>(random.between(-8, 8)) / (2 * texels);
      if (random.below(8) == 0) x = std::nextafter(x, random.below(2) == 0 ? -1e9f : 1e9f);
      if (random.below(32) == 0) x = std::numeric_limits<float>::denorm_min();
    }
  }
  const std::uint64_t kind = random.below(8);
  if (kind == 0) one.uv[4] = one.uv[0], one.uv[5] = one.uv[1];
  if (kind == 1) one.uv[2] = one.uv[0], one.uv[3] = one.uv[1];
  if (kind == 2) one.uv[1] = one.uv[3] = one.uv[5];
  if (kind == 3) one.uv[0] = one.uv[2] = one.uv[4];
}

Sample sample(std::uint64_t number) {
  Random random(11, 3, number);
  Sample s;
  draw_texture(random, s.one);
  draw_threshold(random, s.one);
  draw_triangle(random, s.one);
  s.level = static_cast<Level>(random.below(7));
  s.index = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 2 * s.level));
  return s;
}

std::optional<State> whole_state(const Sample& s, WholeWidth width = WholeWidth::narrowest) {
  return whole_states(s.one, s.level, {s.index}, width).front();
}

constexpr std::uint64_t samples = 12'000;

TEST(BakeWhole, EachInputDrawnOnItsOwn) {
  std::array<std::uint64_t, 4> count{};
  std::uint64_t none = 0;
  for (std::uint64_t k = 0; k < samples; ++k) {
    const Sample s = sample(k);
    const State truth = true_state(s.one, s.level, s.index);
    const auto found = whole_state(s);
    ++count[static_cast<std::size_t>(truth)];
    if (!found)
      ++none;
    else
      ASSERT_EQ(*found, truth) << k << ": " << text_of(s.one) << " level " << s.level << " index " << s.index;
  }
  for (const std::uint64_t of_state : count) EXPECT_GT(of_state, samples / 16);
  EXPECT_LT(none, samples / 64) << "over too many rows";
}

TEST(BakeWhole, AllWidthsThatFindAStateFindTheSame) {
  std::array<std::uint64_t, 4> found{};
  constexpr WholeWidth widths[] = {WholeWidth::narrowest, WholeWidth::bits128, WholeWidth::bits256,
                                   WholeWidth::bits512};
  for (std::uint64_t k = 0; k < samples / 4; ++k) {
    const Sample s = sample(k);
    const auto expected = whole_state(s);
    for (std::size_t w = 0; w < 4; ++w)
      if (const auto state = whole_state(s, widths[w])) {
        ++found[w];
        ASSERT_EQ(state, expected) << k << ": " << static_cast<int>(widths[w]) << " bits";
      }
  }
  EXPECT_GT(found[1], samples / 16) << "128 bits suffice for many";
  EXPECT_LT(found[1], found[2]) << "not for all";
  EXPECT_LT(found[2], found[3]);
  EXPECT_EQ(found[3], found[0]) << "the narrowest is one of them";
}

// ---- Faults: whole numbers that overlook one input, or mistake it

struct Fault {
  const char* name;
  void (*plant)(Case&);
};

constexpr Fault faults[] = {
    {"no margin", [](Case& one) { one.margin = 0; }},
    {"no travel along u", [](Case& one) { one.travel[0] = 0; }},
    {"no travel along v", [](Case& one) { one.travel[1] = 0; }},
    {"travel along u for v", [](Case& one) { one.travel[1] = one.travel[0]; }},
    {"no factor", [](Case& one) { one.factor = 1; }},
    {"no vertex alpha", [](Case& one) { one.vertex_factor = 1; }},
    {"a transparent border", [](Case& one) { one.border = 0; }},
    {"the wrap of u along v", [](Case& one) { one.wrap_v = one.wrap_u; }},
    {"mirrored once is mirrored",
     [](Case& one) { one.wrap_u = one.wrap_u == Wrap::mirror_once ? Wrap::mirrored_repeat : one.wrap_u; }},
    {"the first mip alone", [](Case& one) { one.mips = 1, one.alpha.resize(one.width * one.height); }},
    {"a tie is the other side's", [](Case& one) { one.rules.above = !one.rules.above; }},
    {"the other filter",
     [](Case& one) { one.filter = one.filter == Filter::nearest ? Filter::bilinear : Filter::nearest; }},
    {"a cutoff of 0 at blending",
     [](Case& one) {
       one.blend ? one.cutoff = {0, 1}, one.blend = false : false;
     }},
    {"a corner an ulp off", [](Case& one) { one.uv[0] = std::nextafter(one.uv[0], 1e9f); }},
    {"another corner an ulp off", [](Case& one) { one.uv[5] = std::nextafter(one.uv[5], -1e9f); }},
    {"u below 0 is 0", [](Case& one) { one.uv[2] = std::max(one.uv[2], 0.0f); }},
};

TEST(BakeWhole, EachFaultIsSeen) {
  for (const Fault& fault : faults) {
    std::uint64_t k = 0, differences = 0;
    for (; k < samples && differences == 0; ++k) {
      const Sample right = sample(k);
      Sample wrong = right;
      fault.plant(wrong.one);
      const auto found = whole_state(wrong);
      differences += found && found != true_state(right.one, right.level, right.index) ? 1 : 0;
    }
    EXPECT_NE(differences, 0u) << fault.name;
  }
}

TEST(BakeWhole, RowsOfBitsAreSingleBits) {
  Random random(12, 3, 0);
  for (std::uint32_t width = 1; width <= 200; width += 1 + width / 8) {
    mmverify::spec::bake::whole::BitRows rows(width, 2);
    std::vector<bool> bits(width);
    for (int k = 0; k < 2; ++k) {
      const auto i = static_cast<std::uint32_t>(random.below(width));
      bits[i] = true;
      rows.set(i, 1);
    }
    for (std::uint32_t first = 0; first < width; ++first)
      for (std::uint32_t last = first; last < width; ++last) {
        ASSERT_EQ(rows.any(1, first, last),
                  std::any_of(bits.begin() + first, bits.begin() + last + 1, [](bool bit) { return bit; }))
            << first << ".." << last << " of " << width;
        ASSERT_FALSE(rows.any(0, first, last));
      }
  }
}

TEST(BakeWhole, NumbersOfBinary32AreTheRationals) {
  Random random(13, 3, 0);
  for (std::uint32_t exponent = 0; exponent < 255; ++exponent)
    for (const std::uint32_t fraction :
         {0u, 1u, 0x400000u, 0x7fffffu, static_cast<std::uint32_t>(random.below(1u << 23))})
      for (const std::uint32_t sign : {0u, 1u}) {
        const mmverify::spec::bake::Binary32 x{sign << 31 | exponent << 23 | fraction};
        const auto found = mmverify::spec::bake::whole::dyadic(x);
        ASSERT_EQ(mmverify::spec::scaled(found.m, found.e), mmverify::spec::bake::number<Rational>(x))
            << x.bits;
      }
}

// ---- What whole numbers leave to the rationals

TEST(BakeWhole, WhatTheyDoNotHoldHasNoState) {
  Case one;
  one.width = one.height = 2;
  one.alpha = {0, 255, 255, 0};
  one.uv = {0.25f, 0.25f, 0.75f, 0.25f, 0.25f, 0.75f};
  EXPECT_EQ(whole_states(one, 0, {0}).front(), true_state(one, 0, 0));
  Case wide = one;
  wide.uv = {0.25f, 0.25f, 0x1p20f, 0.25f, 0.25f, 0x1p20f};
  EXPECT_EQ(whole_states(wide, 0, {0}).front(), std::nullopt) << "over 2^22 rows";
  EXPECT_TRUE(whole_states(wide, 12, {0}).front()) << "a part of it is not";
  Case spread = one;
  spread.texel = Texel::float32;
  for (std::uint32_t& texel : spread.alpha) texel = std::bit_cast<std::uint32_t>(1.0f);
  spread.alpha[0] = std::bit_cast<std::uint32_t>(0x1p-100f);
  EXPECT_EQ(whole_states(spread, 0, {0}).front(), std::nullopt) << "texels of 101 bits";
  Case open = one;
  open.rules.contact = mmverify::spec::bake::Contact::open;
  EXPECT_EQ(whole_states(open, 0, {0}).front(), std::nullopt);
  EXPECT_EQ(whole_states(one, 0, {0}, WholeWidth::bits128).front(), true_state(one, 0, 0));
  one.uv[0] = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(whole_states(one, 0, {0}, WholeWidth::bits128).front(), std::nullopt)
      << "150 bits below the point";
  EXPECT_EQ(whole_states(one, 0, {0}).front(), true_state(one, 0, 0));
}

TEST(BakeWhole, BadNumbersAreErrors) {
  Case one;
  one.alpha = {7};
  one.margin = -1;
  EXPECT_THROW(whole_states(one, 0, {0}), std::invalid_argument);
  one.margin = 0;
  one.uv[3] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(whole_states(one, 0, {0}), std::invalid_argument);
}

}  // namespace bake_whole_test
