// [release] Vertex alpha that varies over a triangle: baked and judged by bounds, and never wrongly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "impl/index/index.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/scene/exact_surface.hpp"
#include "scene/bake/texel_ranges.hpp"
#include "scene/validate/stored_maps.hpp"
#include "tests/scene/made_scene.hpp"

namespace mmverify::tests {
namespace scene_varying_alpha_test {

using namespace mmverify::scene;
using spec::bake::State;

constexpr unsigned level = 4;

/// One texture, one material, and triangles whose corners have alphas of their own.
Scene random_scene(std::uint64_t seed) {
  proofs::Random random(seed, 0, 0);
  const auto share = [&] { return static_cast<float>(random.below(1025)) / 1024; };
  Scene s;
  s.file = "random.gltf";
  Image image{"texture", 5, 7, {}};
  constexpr std::size_t texels = 35;
  std::vector<float> alpha;
  for (std::size_t k = 0; k < texels; ++k)
    alpha.push_back(random.below(3) == 0 ? share() : random.below(4) != 0 ? 1.0f : 0.0f);
  const std::uint64_t kind = random.below(3);
  if (kind == 0) image.alpha = std::vector<std::uint8_t>(texels);
  if (kind == 1) image.alpha = std::vector<std::uint16_t>(texels);
  if (kind == 2) image.alpha = std::vector<float>(texels);
  std::visit(
      [&]<class Texel>(std::vector<Texel>& to) {
        constexpr float one = std::is_same_v<Texel, float> ? 1 : sizeof(Texel) == 1 ? 255 : 65535;
        for (std::size_t k = 0; k < texels; ++k) to[k] = static_cast<Texel>(alpha[k] * one);
      },
      image.alpha);
  s.images = {image};
  Material material;
  material.mode = random.below(4) == 0 ? AlphaMode::blend : AlphaMode::mask;
  material.cutoff = 0.25f + share() / 4;
  material.base_color_alpha = random.below(2) == 0 ? 1 : 0.5f + share() / 2;
  const auto wrap = [&] { return static_cast<Wrap>(random.below(3)); };
  material.texture =
      BaseColorTexture{0, 0, {wrap(), wrap(), static_cast<Filter>(random.below(2)), {}, {}}, {}};
  s.materials = {material};
  s.meshes = {{"triangles", 1, {1, {}}}};
  Primitive p;
  p.material = 0;
  VertexAlpha vertex{0, 1, {}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    for (int corner = 0; corner < 3; ++corner) {
      p.uvs.push_back({3 * share() - 1 + 0.001f, 3 * share() - 1 + 0.003f});
      vertex.of_vertices.push_back(random.below(3) == 0 ? share() : random.below(3) != 0 ? 1.0f : 0.25f);
    }
    p.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  vertex.of_vertices.front() = 0.75f;  // it varies
  p.vertex_alpha = vertex;
  p.positions.resize(p.uvs.size());
  s.primitives = {p};
  return s;
}

std::int64_t texel_index(Wrap wrap, std::int64_t k, std::int64_t n) {
  if (wrap == Wrap::clamp_to_edge) return std::clamp<std::int64_t>(k, 0, n - 1);
  if (wrap == Wrap::repeat) return ((k % n) + n) % n;
  const std::int64_t m = ((k % (2 * n)) + 2 * n) % (2 * n);
  return m < n ? m : 2 * n - 1 - m;
}

/// Alpha at a place of a triangle, in doubles: texture times factor times vertex alpha.
double alpha_at(const Scene& s, const PlannedTriangle& t, double u, double v) {
  const Image& image = s.images[0];
  const Material& material = s.materials[0];
  const Sampler& sampler = material.texture->sampler;
  const auto along = [&](auto at) { return at(0) + u * (at(1) - at(0)) + v * (at(2) - at(0)); };
  const double x = along([&](std::size_t k) { return double{t.uvs[k][0]}; }) * image.width,
               y = along([&](std::size_t k) { return double{t.uvs[k][1]}; }) * image.height;
  const auto texel = [&](double i, double j) {
    const auto at = static_cast<std::size_t>(
        texel_index(sampler.wrap_u, static_cast<std::int64_t>(i), image.width) +
        image.width * texel_index(sampler.wrap_v, static_cast<std::int64_t>(j), image.height));
    return std::visit(
        [at]<class Texel>(const std::vector<Texel>& alpha) {
          return static_cast<double>(alpha[at]) / (std::is_same_v<Texel, float> ? 1
                                                   : sizeof(Texel) == 1         ? 255
                                                                                : 65535);
        },
        image.alpha);
  };
  double sampled = texel(std::floor(x), std::floor(y));
  if (filter_of(sampler) == Filter::linear) {
    const double i = std::floor(x - 0.5), j = std::floor(y - 0.5), a = x - 0.5 - i, b = y - 0.5 - j;
    sampled = (texel(i, j) * (1 - a) + texel(i + 1, j) * a) * (1 - b) +
              (texel(i, j + 1) * (1 - a) + texel(i + 1, j + 1) * a) * b;
  }
  return sampled * material.base_color_alpha *
         along([&](std::size_t k) { return double{t.vertex_alpha[k]}; });
}

/// The least and greatest alpha at places within a micro-triangle.
std::pair<double, double> sampled_range(const Scene& s, const PlannedTriangle& t, unsigned n,
                                        std::uint32_t index) {
  const auto corners = impl::index::corners(index, n);
  double least = 2, most = -1;
  constexpr int steps = 6;
  for (int a = 0; a <= steps; ++a)
    for (int b = 0; a + b <= steps; ++b) {
      const double w[3] = {1.0 * a / steps, 1.0 * b / steps, 1.0 * (steps - a - b) / steps};
      double u = 0, v = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        u += w[k] * std::ldexp(corners[k].i, -static_cast<int>(n));
        v += w[k] * std::ldexp(corners[k].j, -static_cast<int>(n));
      }
      const double here = alpha_at(s, t, u, v);
      least = std::min(least, here);
      most = std::max(most, here);
    }
  return {least, most};
}

/// Whether places of a micro-triangle deny that it is O, or T.
struct Denied {
  bool opaque, transparent;
};
Denied denied(const Scene& s, const std::pair<double, double>& range) {
  constexpr double slack = 1e-9;  // of the doubles
  const bool is_blend = s.materials[0].mode == AlphaMode::blend;
  const double opaque = is_blend ? 1 : s.materials[0].cutoff,
               transparent = is_blend ? 0 : s.materials[0].cutoff;
  return {range.first<opaque - slack, range.second> transparent + slack};
}

// Neither the baker nor the judge ever names a state that a place of the micro-triangle denies.
TEST(VaryingAlpha, NoPlaceDeniesAState) {
  std::size_t known = 0, decided = 0, mixed = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    const Scene s = random_scene(seed);
    const Plan planned = plan(s, finest_level, VaryingAlpha::planned);
    ASSERT_EQ(planned.triangles.size(), 4u);
    const std::vector<unsigned> levels(4, level);
    const Baked baked = bake(s, planned, levels);
    const proofs::scene::ExactSurfaces exact(s, planned, 0);
    for (std::size_t t = 0; t < 4; ++t)
      for (std::uint32_t k = 0; k < 1u << 2 * level; ++k) {
        const Denied no = denied(s, sampled_range(s, planned.triangles[t], level, k));
        const unsigned state = proofs::scene::state_code(baked.triangles[t], k);
        const std::optional<State> truly = exact.state(t, level, k);
        ++all;
        known += state < 2 ? 1 : 0;
        decided += truly ? 1 : 0;
        mixed += truly == State::C ? 1 : 0;
        EXPECT_FALSE(state == 1 && no.opaque) << t << ' ' << k;
        EXPECT_FALSE(state == 0 && no.transparent) << t << ' ' << k;
        EXPECT_FALSE(truly == State::O && no.opaque) << t << ' ' << k;
        EXPECT_FALSE(truly == State::T && no.transparent) << t << ' ' << k;
        EXPECT_FALSE(truly != State::C && truly && no.opaque && no.transparent) << t << ' ' << k;
        // Bounds that tell the baker tell the judge.
        EXPECT_FALSE(state == 0 && truly && truly != State::T) << t << ' ' << k;
        EXPECT_FALSE(state == 1 && truly && truly != State::O) << t << ' ' << k;
      }
  }
  EXPECT_GT(3 * known, all) << "bounds tell something";
  EXPECT_GT(mixed, all / 8);
  EXPECT_GT(decided, all - all / 50) << "few states are undecided";
}

/// A scene of one triangle on a texture of one alpha.
Scene even_scene(std::uint8_t alpha, const std::vector<float>& of_vertices) {
  Scene s = random_scene(1);
  s.images = {{"even", 1, 1, std::vector<std::uint8_t>{alpha}}};
  s.materials[0].mode = AlphaMode::mask;
  s.materials[0].cutoff = 0.5f;
  s.materials[0].base_color_alpha = 1;
  s.primitives[0].triangles.resize(1);
  s.primitives[0].vertex_alpha->of_vertices = of_vertices;
  return s;
}

TEST(VaryingAlpha, BoundsThatTouchTheCutoffAreExact) {
  const Scene s = even_scene(255, {1, 0.5f, 0.5f});
  const Plan planned = plan(s, finest_level, VaryingAlpha::planned);
  const std::vector<unsigned> levels{3};
  EXPECT_EQ(bake(s, planned, levels).triangles[0].uniform, impl::micromap::State::O)
      << "alpha >= 1/2 on all of it";
  const Scene below = even_scene(254, {1, 0.5f, 0.5f});
  EXPECT_GT(bake(below, planned, levels).triangles[0].states[3], 0u);
}

/// A product of a texture that rises and a vertex alpha that falls.
Scene ramp_scene() {
  Scene s = even_scene(255, {1, 0.5f, 0.5f});
  s.images = {{"ramp", 2, 1, std::vector<float>{0.5f, 1}}};
  s.materials[0].texture->sampler = {Wrap::clamp_to_edge, Wrap::clamp_to_edge, Filter::linear, {}, {}};
  // Alpha is (1/2 + x/2) (1 - x/2) = 1/2 + x/4 - x^2/4 for x from 0 to 1: at least 1/2, which two corners touch.
  s.primitives[0].uvs = {{0.25f, 0.5f}, {0.75f, 0.5f}, {0.75f, 0.25f}};
  return s;
}

TEST(VaryingAlpha, WhatIsUndecidedHasNoState) {
  Scene s = ramp_scene();
  const Plan planned = plan(s, finest_level, VaryingAlpha::planned);
  const proofs::scene::ExactSurfaces exact(s, planned, 0);
  EXPECT_EQ(exact.state(0, 0, 0), std::nullopt);
  s.materials[0].cutoff = 0.51f;
  const Plan above = plan(s, finest_level, VaryingAlpha::planned);
  EXPECT_EQ(proofs::scene::ExactSurfaces(s, above, 0).state(0, 0, 0), State::C);
  s.materials[0].cutoff = 0.45f;
  const Plan under = plan(s, finest_level, VaryingAlpha::planned);
  EXPECT_EQ(proofs::scene::ExactSurfaces(s, under, 0).state(0, 0, 0), State::O);
}

TEST(VaryingAlpha, CornersOfOtherAlphasAreOtherTriangles) {
  Scene s = even_scene(255, {1, 0.5f, 0.5f, 1, 0.5f, 0.25f, 0.5f, 1, 0.5f});
  Primitive& p = s.primitives[0];
  p.uvs.resize(3);
  for (std::size_t k = 0; k < 6; ++k) p.uvs.push_back(p.uvs[k == 3 ? 1 : k == 4 ? 0 : k % 3]);
  p.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  const Plan planned = plan(s, finest_level, VaryingAlpha::planned);
  EXPECT_EQ(planned.triangles.size(), 2u);
  EXPECT_EQ(counts(planned).varying, 3u);
  EXPECT_EQ(planned.primitives[0].triangles[2].order, (VertexOrder{1, 0, 2}));
  EXPECT_EQ(plan(s).left_out.at(0).why, LeftOut::varying_alpha);
}

proofs::Verdict verdict(const Scene& s, const Plan& p, const Baked& b, const char* law,
                        std::string* text = nullptr) {
  const SceneArrays no_arrays;
  const Pairs no_pairs;
  const SquareMaps no_squares;
  const proofs::scene::Data data{s, p, b, no_arrays, no_pairs, no_squares};
  proofs::scene::SceneLaws laws = proofs::scene::map_laws(data, {}, "maps", "mmverify check maps maps");
  std::erase_if(laws.jobs, [&](const proofs::Job& job) { return job.law->id != law; });
  proofs::RunOptions run;
  run.show_progress = false;
  run.mutants = false;
  const proofs::Report report = proofs::run_jobs(laws.jobs, run, [](const proofs::Result&) {});
  if (report.results.empty()) return proofs::Verdict::not_applicable;
  if (text != nullptr)
    *text = report.results[0].counterexamples.empty() ? report.results[0].reason
                                                      : report.results[0].counterexamples[0].expected;
  return report.results[0].verdict;
}

TEST(VaryingAlpha, TheLawsRefuteOnlyWhatAPlaceDenies) {
  const Scene s = even_scene(255, {1, 0.25f, 0.5f});
  const Plan planned = plan(s, finest_level, VaryingAlpha::planned);
  const Baked right = bake(s, planned, std::vector<unsigned>{level});
  EXPECT_NE(verdict(s, planned, right, "bake.conservative"), proofs::Verdict::refuted);
  Baked wrong = right;
  BakedTriangle* const map = &wrong.triangles[0];
  ASSERT_TRUE(map->states[1] > 100 && map->states[0] > 20 && map->states[3] > 0);
  impl::micromap::Bytes bytes(map->map.begin(), map->map.end());
  std::uint32_t k = 0;
  while (proofs::scene::state_code(*map, k) != 1) ++k;
  bytes[k / 4] = static_cast<std::uint8_t>(bytes[k / 4] ^ 1u << 2 * (k % 4));  // an O is T
  map->map = std::move(bytes);
  --map->states[1], ++map->states[0];
  std::string text;
  EXPECT_EQ(verdict(s, planned, wrong, "bake.conservative", &text), proofs::Verdict::refuted);
  EXPECT_THAT(text, testing::HasSubstr("times a vertex alpha of "));
}

TEST(VaryingAlpha, NeedlessUnknownStatesAreNotJudged) {
  Scene s = ramp_scene();
  s.materials[0].cutoff = 0.45f;
  const Plan planned = plan(s, finest_level, VaryingAlpha::planned);
  const Baked baked = bake(s, planned, std::vector<unsigned>{0});
  EXPECT_EQ(baked.triangles[0].uniform, impl::micromap::State::UO) << "half of 1/2 is below the cutoff";
  EXPECT_EQ(proofs::scene::ExactSurfaces(s, planned, 0).state(0, 0, 0), State::O);
  EXPECT_EQ(verdict(s, planned, baked, "bake.tight"), proofs::Verdict::not_applicable);
}

TEST(VaryingAlpha, AKnownStateThatBoundsDoNotDecideIsNotApplicable) {
  const Scene s = ramp_scene();
  const Plan planned = plan(s, finest_level, VaryingAlpha::planned);
  Baked baked = bake(s, planned, std::vector<unsigned>{0});
  baked.triangles[0].uniform = impl::micromap::State::O;
  baked.triangles[0].states = {0, 1, 0, 0};
  std::string text;
  EXPECT_EQ(verdict(s, planned, baked, "bake.conservative", &text), proofs::Verdict::not_applicable);
  EXPECT_EQ(text, "1 of 1 cases are those whose vertex alpha varies, and bounds do not decide");
  baked.triangles[0].uniform = impl::micromap::State::T;
  baked.triangles[0].states = {1, 0, 0, 0};
  EXPECT_EQ(verdict(s, planned, baked, "bake.conservative"), proofs::Verdict::refuted)
      << "alpha is nowhere below";
}

TEST(VaryingAlpha, RangesOfTexelsHoldAllThatAnIndexMeans) {
  proofs::Random random(5, 0, 0);
  Image image{"texels", 37, 23, std::vector<std::uint8_t>(37 * 23)};
  for (auto& texel : std::get<0>(image.alpha)) texel = static_cast<std::uint8_t>(random.below(256));
  const TexelRanges ranges(image);
  std::size_t exact = 0;
  for (int round = 0; round < 600; ++round) {
    const auto wrap = [&] { return static_cast<Wrap>(random.below(3)); };
    const Sampler sampler{wrap(), wrap(), {}, {}, {}};
    const auto some = [&](std::uint64_t most) {
      const auto first = static_cast<std::int64_t>(random.below(200)) - 100;
      return IndexRange{first, first + static_cast<std::int64_t>(random.below(most))};
    };
    const bool are_few = round % 2 == 0;
    const IndexRange columns = some(are_few ? 4 : 60), rows = some(are_few ? 4 : 60);
    float least = 256, most = -1;
    for (std::int64_t y = rows.first; y <= rows.last; ++y)
      for (std::int64_t x = columns.first; x <= columns.last; ++x) {
        const float here =
            ranges.texel(texel_index(sampler.wrap_u, x, 37), texel_index(sampler.wrap_v, y, 23));
        least = std::min(least, here);
        most = std::max(most, here);
      }
    const TexelRange found = ranges.of(columns, rows, sampler);
    EXPECT_LE(found.least, least);
    EXPECT_GE(found.greatest, most);
    exact += found.least == least && found.greatest == most ? 1 : 0;
  }
  EXPECT_GE(exact, 300u) << "few texels have no other range";
}

}  // namespace scene_varying_alpha_test
}  // namespace mmverify::tests
