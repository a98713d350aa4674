// [release] Topic bake's subjects in the dock: what the enumerated truth rests on, what cases are, what is declined,
// what a counterexample shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "proofs/bake/domains/family.hpp"
#include "proofs/bake/domains/plateaus.hpp"
#include "proofs/bake/domains/samples.hpp"
#include "proofs/bake/domains/strata.hpp"
#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/offender.hpp"
#include "proofs/bake/truth/truth.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/points/narrow.hpp"
#include "proofs/registry/registry.hpp"
#include "tests/sanitized.hpp"

namespace bake_laws_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::bake;
using mmverify::spec::Integer;

using LawRun = Run;  // inside a test, Run is a member function of GoogleTest's

Result judged(const char* law, const Subject& subject, Level level) {
  return run_level(*find_law(law), subject, level, LawRun{});
}
Result judged(const char* law, const char* subject, Level level) {
  return judged(law, *find_subject(subject), level);
}

// A subject that is wrong about the third mip alone, or about 2-state maps' last bits.
TEST(BakeLaws, MipsArePartedAndMapsPadded) {
  Functions parts = built_in("bake")->functions;
  parts.bake = [real = parts.bake](const Case& one, Level n, Format format) {
    auto baked = real(one, n, format);
    if (baked && format == Format::two_state) baked->padded = n != 0;
    return baked;
  };
  EXPECT_EQ(judged("bake.force2", BakeSubject("padded", "with ones", parts), 0).verdict, Verdict::refuted);
  EXPECT_EQ(judged("bake.nested", "bake", 12).verdict, Verdict::not_applicable);
}

TEST(BakeLaws, ALawNeedsItsEntryPointAndItsLevel) {
  EXPECT_EQ(judged("bake.conservative", "vq", 0).verdict, Verdict::not_applicable);
  EXPECT_EQ(judged("bake.conservative", "bake", 13).verdict, Verdict::not_applicable);
  EXPECT_EQ(judged("bake.unknown_side", "centre-sample", 0).verdict, Verdict::not_applicable);
}

TEST(BakeLaws, CasesAddUpToTheirClosedForm) {
  const std::uint64_t all = 81 * 25 * 6 + 512 * 25 * 4;
  EXPECT_EQ(bilinear_families().count(), all);
  EXPECT_EQ(judged("bake.conservative", "bake", 0).cases_run(), all);
  std::set<std::string> texts;
  for (std::uint64_t k = 0; k < all; ++k) texts.insert(text_of(bilinear_families().at(k)));
  EXPECT_EQ(texts.size(), all) << "no case twice";
}

// The families' truth is put together from cells; the specification's own function says the same.
TEST(BakeFamily, ItsTruthIsTheSpecifications) {
  Random random(7, 1, 1);
  for (int round = 0; round < (sanitized ? 8 : 150); ++round) {
    const std::uint64_t k = random.below(bilinear_families().count());
    const auto n = static_cast<Level>(random.below(4));
    const std::vector<State> truth = bilinear_families().truth(n, k);
    const Case one = bilinear_families().at(k);
    ASSERT_EQ(truth.size(), std::size_t{1} << 2 * n);
    for (std::uint32_t index = 0; index < truth.size();
         index += 1 + static_cast<std::uint32_t>(random.below(3)))
      ASSERT_EQ(truth[index], true_state(one, n, index))
          << text_of(one) << " level " << n << " index " << index;
  }
}

TEST(BakeFamily, NearestAndBlendedToo) {
  const std::vector<std::pair<Wrap, Wrap>> wraps{{Wrap::repeat, Wrap::clamp_to_border},
                                                 {Wrap::mirror_once, Wrap::mirrored_repeat}};
  const std::vector<Triangle> triangles{{0, 0, 1, 0, 0, 1}, {-0.5f, 0.25f, 1.25f, 0.5f, 0.5f, 1.5f}};
  for (const Filter filter : {Filter::nearest, Filter::bilinear})
    for (const bool blended : {false, true}) {
      const Enumerated family(Family{2, {0, 255}, {1, 2}, filter, blended, wraps, triangles});
      EXPECT_EQ(family.count(), 64u);
      for (std::uint64_t k = 0; k < family.count(); k += sanitized ? 9 : 3) {
        const std::vector<State> truth = family.truth(2, k);
        for (std::uint32_t index = 0; index < 16; ++index)
          ASSERT_EQ(truth[index], true_state(family.at(k), 2, index))
              << text_of(family.at(k)) << " " << index;
      }
    }
}

TEST(BakeCase, IsReadBack) {
  for (std::uint64_t k = 0; k < 64; ++k)
    for (Case one : {sample(3, k), large_sample(3, k)}) {
      one.filter = k % 2 == 0 ? Filter::nearest : Filter::bilinear;
      one.blend = k % 3 == 0;
      one.factor = k % 5 == 0 ? 0.3f : 1;
      one.margin = k % 7 == 0 ? 0.5f : 0;
      const std::string text = text_of(one);
      const Case again = case_from(text);
      EXPECT_EQ(text_of(again), text);
      EXPECT_EQ(again.alpha, one.alpha);
      EXPECT_EQ(again.uv, one.uv);
      EXPECT_EQ(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789=,:/.+-"), std::string::npos)
          << "one word of a shell: " << text;
    }
}

TEST(BakeCase, WithMipsWordsAndFloats) {
  const std::string words =
      "mips=2,texels=u16:2x3:0000ffff12345678abcd00010007,wrap=clamp:once,cutoff=1/"
      "3,uv=0x0p+0:0x1p+0:0x0p+0:0x0p+0:0x1.8p-1:0x1p-149";
  EXPECT_EQ(text_of(case_from(words)), words);
  EXPECT_EQ(case_from(words).alpha.back(), 7u);
  const std::string floats =
      "texels=f32:1x1:3f800000,wrap=border:repeat,border=bf800000,filter=nearest,factor=0x1p-1,cutoff=blend,"
      "margin=0x1p-2,uv=0x0p+0:0x1p+0:0x0p+0:0x0p+0:-0x1.8p-1:0x1p+0";
  EXPECT_EQ(text_of(case_from(floats)), floats);
}

TEST(BakeCase, WhatNoBakerCanBeAskedIsNotRead) {
  const std::string uv = ",uv=0x0p+0:0x0p+0:0x1p+0:0x0p+0:0x0p+0:0x1p+0",
                    rest = ",wrap=repeat:clamp,cutoff=1/2" + uv;
  EXPECT_NO_THROW(case_from("texels=u8:1x1:80" + rest));
  for (const std::string& bad :
       {std::string(), "texels=u8:1x1:8" + rest, "texels=u8:0x1:" + rest, "texels=u9:1x1:80" + rest,
        "texels=u8:16385x1:80" + rest, "texels=u8:1x1:8g" + rest, "texels=f32:1x1:7f800000" + rest,
        "texels=u8:1x1:80,texels=u8:1x1:80" + rest, "texels=u8:1x1:80,colour=red" + rest,
        "mips=0,texels=u8:1x1:80" + rest, "texels=u8:1x1:80,filter=cubic" + rest,
        "texels=u8:1x1:80,margin=-0x1p+0" + rest, "texels=u8:1x1:80,factor=inf" + rest,
        "texels=u8:1x1:80,wrap=repeat,cutoff=1/2" + uv, "texels=u8:1x1:80,wrap=repeat:round,cutoff=1/2" + uv,
        "texels=u8:1x1:80,wrap=repeat:clamp,cutoff=1/0" + uv, "texels=u8:1x1:80,wrap=repeat:clamp" + uv,
        std::string("texels=u8:1x1:80,wrap=repeat:clamp,cutoff=1/2,uv=0x0p+0"),
        "texels=u8:1x1:80,wrap=repeat:clamp,cutoff=1/2,uv=nan" + uv.substr(9)})
    EXPECT_THROW(case_from(bad), BadCase) << bad;
}

// The samples have the kinds that the laws' domains promise.
TEST(BakeSamples, AreOfTheirKinds) {
  std::size_t slivers = 0, beside = 0, far = 0, at_cutoff = 0, flat = 0, degenerate = 0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const Case one = sample(1, k);
    const auto& p = one.uv;
    const double area =
        (double{p[2]} - p[0]) * (double{p[5]} - p[1]) - (double{p[3]} - p[1]) * (double{p[4]} - p[0]);
    const double longest =
        std::max({std::hypot(p[2] - p[0], p[3] - p[1]), std::hypot(p[4] - p[0], p[5] - p[1]),
                  std::hypot(p[4] - p[2], p[5] - p[3])});
    slivers += area != 0 && std::fabs(area) < 1.1e-6 * longest * longest ? 1 : 0;
    degenerate += area == 0 ? 1 : 0;
    far += p[0] > 9e5f || p[0] < -9e5f ? 1 : 0;
    const bool same =
        std::all_of(one.alpha.begin(), one.alpha.end(), [&](auto a) { return a == one.alpha[0]; });
    flat += same && k % 104 < 64 && k % 8 == 4 ? 1 : 0;
    at_cutoff += same && one.cutoff.denominator == 255 && one.alpha[0] == one.cutoff.numerator ? 1 : 0;
    bool off = false;
    for (std::size_t c = 0; c < 6; ++c) {
      const double lines = 2.0 * p[c] * (c % 2 == 0 ? one.width : one.height),
                   to = lines - std::nearbyint(lines);
      off = off || (to != 0 && std::fabs(to) < 1e-5);
    }
    beside += off ? 1 : 0;
  }
  EXPECT_GT(slivers, 40u);
  EXPECT_GT(degenerate, 90u);
  EXPECT_EQ(far, 80u);  // of each 104 64 are of eight kinds: 9 x 8, and 8 of the last 64
  EXPECT_EQ(flat, 80u);
  EXPECT_GT(at_cutoff, 10u);
  EXPECT_GT(beside, 60u);
}

// ---- Strata

TEST(BakeStrata, HaveEveryPairOfValues) {
  const std::vector<Row>& rows = design();
  ASSERT_EQ(rows.size(), 484u);
  std::uint64_t fast = 0;
  for (Level n = 0; n <= 12; ++n) fast += fast_strata(n);
  EXPECT_EQ(fast, rows.size()) << "the fast tier's levels run through the design once";
  for (std::size_t d = 0; d < dimensions; ++d)
    for (std::size_t e = 0; e < d; ++e) {
      std::set<std::pair<int, int>> met;
      for (const Row& row : rows) met.emplace(row[d], row[e]);
      EXPECT_EQ(met.size(), std::size_t{values_of()[d]} * values_of()[e]) << d << ", " << e;
    }
  // Levels have every value of a side by themselves, where they have as many cases.
  for (std::uint64_t first = 0; first + 22 <= rows.size(); ++first) {
    std::set<int> widths;
    for (std::uint64_t k = 0; k < 22; ++k) widths.insert(rows[first + k][width_of]);
    EXPECT_EQ(widths.size(), 22u);
  }
}

// The texels of a plateau are named; the name brings back the case.  Most cases are plateaus, and all states occur.
TEST(BakePlateaus, AreWhatTheirTextSays) {
  std::array<std::size_t, 4> states{};
  std::size_t plateaus = 0;
  constexpr std::uint64_t count = 60;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Level n = static_cast<Level>(k % 4);
    const Case one = plateau_sample(1, n, k);
    const std::string text = text_of(one);
    EXPECT_LT(text.size(), 260u) << text;
    const Case again = case_from(text);
    EXPECT_EQ(again.alpha, one.alpha) << text;
    EXPECT_EQ(again.uv, one.uv) << text;
    EXPECT_EQ(text_of(again), text);
    std::map<std::uint32_t, std::size_t> times;
    for (const std::uint32_t texel : one.alpha) ++times[texel];
    const auto most = std::max_element(times.begin(), times.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    plateaus += 2 * most->second > one.alpha.size() ? 1 : 0;
    for (const State s : true_states(one, n).lower) ++states[static_cast<std::size_t>(s)];
  }
  EXPECT_GT(plateaus, count / 2);
  for (const std::size_t times : states) EXPECT_GT(times, 10u);
  EXPECT_THROW(case_from("texels=u8:12x12:plateau-1-2,wrap=clamp:clamp,cutoff=1/2,uv=0:0:0:1:1:0"), BadCase);
  EXPECT_THROW(case_from("texels=u8:12x12:plateau-1-02-3,wrap=clamp:clamp,cutoff=1/2,uv=0:0:0:1:1:0"),
               BadCase);
}

// Each row of the design becomes a case: its sides, mips and texels; the cases' true states are not all alike.
TEST(BakeStrata, AreWhatTheirTextSays) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sizes;
  std::set<std::uint32_t> mips;
  std::array<std::size_t, 4> states{};
  std::size_t whole = 0, large = 0, said = 0, rounded = 0;
  for (std::uint64_t row = 0; row < design().size(); row += sanitized ? 31 : 1) {
    const Case one = stratified(1, 5, row);
    sizes.emplace(one.width, one.height);
    mips.insert(one.mips);
    const std::uint64_t texels = std::uint64_t{one.width} * one.height;
    EXPECT_LE(texels, large_row(row) ? large_texels : usual_texels);
    large += texels > usual_texels ? 1 : 0;
    EXPECT_EQ(one.alpha.size(), texels_of(one.width, one.height, one.mips));
    const std::string text = text_of(one);
    EXPECT_LT(text.size(), 9000u);
    said += text.find("drawn-1-5-") != std::string::npos ? 1 : 0;
    if (row % 8 == 0) {
      const Case again = case_from(text);
      EXPECT_EQ(again.alpha, one.alpha) << text;
      EXPECT_EQ(text_of(again), text);
    }
    const float product = one.factor * one.vertex_factor;
    rounded += double{product} != double{one.factor} * double{one.vertex_factor} ? 1 : 0;
    if (row % 16 != 1) continue;
    ++whole;
    for (const State s : true_states(one, 5).lower) ++states[static_cast<std::size_t>(s)];
  }
  EXPECT_THROW(case_from("mips=15,texels=u8:4x4:drawn-1-5-7,wrap=clamp:clamp,cutoff=1/2,uv=0:0:0:1:1:0"),
               BadCase);
  EXPECT_THROW(case_from("texels=u8:4x4:drawn-x,wrap=clamp:clamp,cutoff=1/2,uv=0:0:0:1:1:0"), BadCase);
  if (sanitized) return;
  // Every pair of sides with few enough texels.
  for (const std::uint32_t w : sides())
    for (const std::uint32_t h : sides())
      if (std::uint64_t{w} * h <= usual_texels) {
        EXPECT_TRUE(sizes.count({w, h}) == 1) << w << "x" << h;
      }
  for (std::uint32_t k = 1; k <= 15; ++k)
    if (k <= 3 || k == 5 || k == 15) {
      EXPECT_TRUE(mips.count(k) == 1) << k;
    }
  EXPECT_GT(large, 4u);
  EXPECT_GT(said, 200u);
  EXPECT_GT(rounded, 100u);
  for (const std::size_t count : states) EXPECT_GT(count, 24 * whole / 20) << "no state is rare";
}

// Every level has cases that a baker of 8 bits without factors, margins and mips does not decline.
TEST(BakeStrata, EveryFourthIsPlain) {
  for (Level n = 0; n <= 9; ++n) {
    std::size_t plain = 0;
    const std::uint64_t count = find_law("bake.tight_on_strata")->cases(n, LawRun{});
    for (std::uint64_t k = 0; k < count; ++k) {
      if (stratum(n, k) < plain_rows) continue;
      ++plain;
      const Case one = stratified(1, n, stratum(n, k));
      EXPECT_TRUE(one.texel == Texel::unorm8 && one.mips == 1 && one.factor == 1 && one.vertex_factor == 1 &&
                  one.margin == 0 && !one.blend && one.filter == Filter::bilinear)
          << text_of(one);
    }
    EXPECT_EQ(plain, count / 4);
    EXPECT_EQ(count - plain, fast_strata(n)) << "the rest of the fast tier's levels is the design";
  }
}

TEST(BakeStrata, ArePlainAboveLevel9) {
  for (std::uint64_t k = 0; k < 8; ++k) EXPECT_GE(stratum(10, k), plain_rows);
}

// A texel whose alpha is on one side of the cutoff exactly and on the other in rounded numbers.
TEST(BakeStrata, MeetCutoffsThatOnlyRoundedProductsPass) {
  std::size_t between = 0;
  for (std::uint64_t row = 0; row < design().size(); ++row) {
    if (design()[row][cutoff_of] != 3) continue;
    const Case one = stratified(1, 0, row);
    if (one.texel != Texel::unorm8) continue;
    bool found = false;
    for (std::uint32_t t = 1; t < 256 && !found; ++t) {
      const float x = static_cast<float>(t) / 255;
      const auto exact = [](float f) {
        return mmverify::spec::bake::number<Rational>(
            mmverify::spec::bake::Binary32{std::bit_cast<std::uint32_t>(f)});
      };
      const Rational alpha = Rational(t, 255) * exact(one.factor) * exact(one.vertex_factor),
                     cutoff(one.cutoff.numerator, one.cutoff.denominator);
      for (const float y : {x * one.factor * one.vertex_factor, x * (one.factor * one.vertex_factor)})
        found = found || (alpha >= cutoff) != (exact(y) >= cutoff);
    }
    between += found ? 1 : 0;
  }
  EXPECT_GT(between, 3u);
}

TEST(BakeStrata, AreJudgedAtOtherPlacesEachAndAtTheEnds) {
  std::set<std::uint32_t> at;
  std::size_t first = 0, last = 0;
  for (std::uint64_t row = 0; row < 64; ++row)
    for (const std::uint32_t k : judged_at(stratified(1, 7, row), 7)) {
      ASSERT_LT(k, 1u << 14);
      at.insert(k);
      first += k == 0 ? 1 : 0;
      last += k == (1u << 14) - 1 ? 1 : 0;
    }
  EXPECT_GT(at.size(), 700u);
  EXPECT_GE(first, 64u);
  EXPECT_GE(last, 64u);
  EXPECT_LE(judged_at(stratified(1, 3, 7), 3).size(), 24u);
  EXPECT_EQ(judged_at(sample(1, 0), 3).size(), 64u);
  EXPECT_EQ(judged_at(sample(1, 0), 7).size(), 96u);
}

TEST(BakeNumbers, NarrowOnesAreBoostsOrThrow) {
  Random random(3, 1, 4);
  std::size_t thrown = 0;
  for (int round = 0; round < 20'000; ++round) {
    const auto any = [&](bool positive) {
      const auto size = static_cast<int>(random.below(62));
      const auto x = static_cast<std::int64_t>(random.next() >> (63 - size));
      return positive ? std::max<std::int64_t>(x, 1) : random.below(2) != 0 ? x : -x;
    };
    const std::int64_t a = any(false), b = any(true), c = any(false), d = any(true);
    const Rational p(a, b), q(c, d);
    const Rational64 s{Whole64(a), Whole64(b)}, t{Whole64(c), Whole64(d)};
    ASSERT_EQ(p < q, s < t);
    ASSERT_EQ(p == q, s == t);
    const auto same = [&](const Rational& wide, auto narrow) {
      const Integer limit = Integer(1) << 63;
      const bool fits = abs(wide.numerator()) < limit && wide.denominator() < limit;
      try {
        const Rational64 got = narrow();
        EXPECT_EQ(wide, Rational(static_cast<std::int64_t>(got.numerator()),
                                 static_cast<std::int64_t>(got.denominator())));
      } catch (const std::overflow_error&) {
        ++thrown;
        EXPECT_FALSE(fits) << wide;
      }
    };
    same(p + q, [&] { return s + t; });
    same(p - q, [&] { return s - t; });
    same(p * q, [&] { return s * t; });
    if (c != 0) same(p / q, [&] { return s / t; });
    same(-p, [&] { return -s; });
    const auto k = static_cast<std::uint32_t>(random.next());
    same(mmverify::spec::times(k, p), [&] { return mmverify::spec::times(k, s); });
    same(p - Rational(k), [&] { return s - Rational64(k); });
    if (p >= 0 && p < Rational(Integer(1) << 32))
      EXPECT_EQ(mmverify::spec::whole(p), whole(s));
    else
      EXPECT_THROW(whole(s), std::range_error);
  }
  EXPECT_GT(thrown, 1000u);
}

TEST(BakeNumbers, NarrowOnesTakeNoWholeNumberBeyondTheirs) {
  const Integer most = (Integer(1) << 63) - 1, least = -most - 1;
  EXPECT_EQ(static_cast<std::int64_t>(Whole64(most)), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(static_cast<std::int64_t>(Whole64(least)), std::numeric_limits<std::int64_t>::min());
  for (const Integer& beyond :
       {Integer(most + 1), Integer(least - 1), Integer(most * most), Integer(-most * most)})
    EXPECT_THROW(Whole64{beyond}, std::overflow_error) << beyond;
}

// ---- Counterexamples

using spec_place = TexturePoint;

/// Whether p lies on the closed triangle, of either orientation.
bool inside(const mmverify::spec::bake::Polygon<Rational>& t, const spec_place& p) {
  bool left = true, right = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = t[k], &b = t[(k + 1) % 3];
    const Rational side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right;
}

TEST(BakeOffender, ThePointLiesInTheMicroTriangleAndContradictsItsState) {
  std::size_t found = 0;
  for (std::uint64_t k = 0; k < (sanitized ? 4 : 24); ++k) {
    Case one = sample(5, k);
    if (k % 3 == 0) one.filter = Filter::nearest;
    const std::vector<State> truth = true_states(one, 2).lower;
    std::vector<State> got = truth;
    for (State& s : got) s = mmverify::spec::micromap::force2(s);  // settles what is unknown
    const auto o = worst(one, 2, got, judged_at(one, 2), truth);
    if (!o) continue;
    ++found;
    const Extreme& e = contradiction(*o);
    EXPECT_TRUE(inside(corners_of(one, 2, o->index), e.at)) << text_of(one);
    const Rational cutoff(one.cutoff.numerator, one.cutoff.denominator);
    EXPECT_EQ(o->said == State::O, e.alpha < cutoff);
    const mmverify::spec::bake::Texture t{one.width,
                                          one.height,
                                          {one.alpha.begin(), one.alpha.end()},
                                          one.wrap_u,
                                          one.wrap_v,
                                          static_cast<std::uint8_t>(one.border),
                                          mmverify::spec::bake::one,
                                          one.filter};
    EXPECT_EQ(mmverify::spec::bake::alpha(t, e.at), e.alpha) << text_of(one);
  }
  EXPECT_GT(found, sanitized ? 0u : 8u);
}

TEST(BakeLaws, BakersThatSampleAreRefutedWithAPicture) {
  for (const char* name : {"centre-sample", "corner-samples"}) {
    const Result r = judged("bake.conservative", name, 0);
    ASSERT_EQ(r.verdict, Verdict::refuted) << name;
    const Counterexample& c = r.counterexamples.front();
    const Replayed again = find_law("bake.conservative")->replay(*find_subject(name), 0, c.at);
    EXPECT_FALSE(again.holds);
    EXPECT_EQ(again.expected, c.expected);
    EXPECT_NE(again.picture.find("<svg"), std::string::npos);
    EXPECT_NE(again.picture.find("the contradiction"), std::string::npos);
    EXPECT_TRUE(find_law("bake.conservative")->replay(*find_subject("bake"), 0, c.at).holds);
  }
}

// ---- Cases that are declined

BakeSubject declining(bool (*declined)(const Case&)) {
  Functions parts = built_in("bake")->functions;
  parts.bake = [=, real = parts.bake](const Case& one, Level n, Format format) {
    return declined(one) ? std::nullopt : real(one, n, format);
  };
  return {"declining", "a baker that does not know everything", parts};
}

TEST(BakeLaws, WhatIsDeclinedIsCountedAndNeverProved) {
  const BakeSubject some = declining([](const Case& one) { return one.wrap_u == Wrap::mirror_once; });
  const Result checked = judged("bake.tight", some, 0);
  EXPECT_EQ(checked.verdict, Verdict::checked);
  EXPECT_EQ(checked.cases_run(), checked.cases_expected);
  EXPECT_EQ(checked.declined(), 5u * 81 * 6 + 5u * 512 * 4);
  const BakeSubject all = declining([](const Case&) { return true; });
  for (const char* law : {"bake.conservative", "bake.tight_on_samples", "bake.order", "bake.nested"}) {
    const Result none = judged(law, all, 0);
    EXPECT_EQ(none.verdict, Verdict::not_applicable) << law;
    EXPECT_FALSE(none.reason.empty());
    EXPECT_EQ(none.declined(), none.cases_run());
  }
  const BakeSubject wrong_too = declining([](const Case& one) { return one.alpha[0] != 0; });
  Functions parts = wrong_too.functions;
  parts.bake = [real = parts.bake](const Case& one, Level n, Format format) {
    auto baked = real(one, n, format);
    if (baked) baked->states[0] = State::O;
    return baked;
  };
  EXPECT_EQ(judged("bake.conservative", BakeSubject("wrong", "wrong", parts), 0).verdict, Verdict::refuted);
}

}  // namespace bake_laws_test
