// scene/attribute/: maps of a triangle, what they show, how many are left, and a scene's figures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <random>

#include "scene/attribute/atlas.hpp"
#include "scene/attribute/distinct_maps.hpp"
#include "scene/attribute/map_reading.hpp"
#include "scene/attribute/measure.hpp"
#include "scene/attribute/picture.hpp"

namespace {

using namespace mmverify::scene;

constexpr AttributeSet base_color = set_of(Attribute::base_color);

/// An image by code(x, y, channel).
template <class Code>
ColourImage drawn(std::uint32_t width, std::uint32_t height, Code code) {
  ColourImage image{"drawn", width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (std::uint32_t c = 0; c < 4; ++c)
        image.rgba.push_back(c == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(code(x, y, c)));
  return image;
}

Sampler wrapped_as(Wrap wrap) {
  Sampler sampler;
  sampler.wrap_u = sampler.wrap_v = wrap;
  return sampler;
}

std::vector<MapValue> baked(const ColourImage& image, AttributeSet set, MapKind kind, unsigned level,
                            const UvTriangle& uvs, Averaging averaging = Averaging::meaning,
                            Wrap wrap = Wrap::clamp_to_edge) {
  std::vector<MapValue> map(values_of_map(kind, level));
  MapBaker(image, {set, 0, wrapped_as(wrap)}, averaging).bake(uvs, kind, level, map);
  return map;
}

/// All of an image, as two triangles.
AttributeScene square_scene(ColourImage image, AttributeSet set = base_color) {
  AttributeScene scene;
  scene.file = "square";
  scene.images.push_back(std::move(image));
  scene.textures.push_back({set, 0, wrapped_as(Wrap::clamp_to_edge)});
  scene.primitives.push_back({0, 0, {{0, 1, 2}, {2, 1, 3}}, {{0, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}}}});
  scene.triangles = 2;
  return scene;
}

ColourImage random_image(std::uint32_t width, std::uint32_t height) {
  std::mt19937 engine(7);
  return drawn(width, height, [&](auto, auto, auto) { return engine() & 255; });
}

TEST(AttributeFootprint, IsThePapersFigure1) {
  // Table 2, the Shoe's maps of vertices at most: 14,669, 21,647 and 22,310; three textures of 2048^2, 4 bytes each.
  const std::uint64_t maps = 14669 + 21647 + 22310, textures = std::uint64_t{3} * 2048 * 2048 * 4;
  const auto per_cent = [&](unsigned level) {
    return 100 * static_cast<double>(bytes_of_maps(maps, MapKind::vertices, level)) /
           static_cast<double>(textures);
  };
  EXPECT_EQ(bytes_of_maps(maps, MapKind::vertices, 4), 35879112u);
  EXPECT_NEAR(per_cent(4), 71.29, 0.005);  // "71 %" of figure 1
  EXPECT_NEAR(per_cent(2), 6.99, 0.005);   // "7 %" of 6.3
  EXPECT_NEAR(per_cent(3), 20.97, 0.005);
  EXPECT_EQ(level_beyond(maps, MapKind::vertices, textures), 5u);
}

TEST(AttributeFootprint, OfTheQuadReachesItsTexturesAtLevel10) {
  // "can go beyond level 8 before it reaches parity" (6.1): two triangles, two textures of 1024^2.
  EXPECT_EQ(bytes_of_maps(2, MapKind::vertices, 8), 265224u);
  EXPECT_EQ(level_beyond(4, MapKind::vertices, std::uint64_t{2} * 1024 * 1024 * 4), 10u);
  EXPECT_EQ(level_beyond(0, MapKind::faces, 1), no_level);
}

TEST(AttributeFootprint, OfVerticesIsSmallerThanOfFacesFromLevel2On) {
  for (unsigned level = 0; level <= 10; ++level) {
    std::uint64_t vertices = 0;
    for (std::uint64_t row = 0; row <= std::uint64_t{1} << level; ++row) vertices += row + 1;
    EXPECT_EQ(values_of_map(MapKind::vertices, level), vertices);
    EXPECT_EQ(vertices < values_of_map(MapKind::faces, level), level >= 2);
  }
}

TEST(AttributeMaps, AFaceIsTheMeanOfWhatLiesUnderIt) {
  const ColourImage half = drawn(2, 1, [](auto x, auto, auto) { return 255 * x; });
  // Its height divides the triangle: as much of it is black as is white.
  const UvTriangle both{{{0, 0}, {1, 0}, {0.5f, 1}}};
  // Half of the light of white is code 187.52, half of its code 127.5, which goes up.
  EXPECT_THAT(baked(half, base_color, MapKind::faces, 0, both),
              testing::ElementsAre(MapValue{188, 188, 188, 0}));
  EXPECT_THAT(baked(half, base_color, MapKind::faces, 0, both, Averaging::codes),
              testing::ElementsAre(MapValue{128, 128, 128, 0}));
  // Left of the middle lies 1/2 - of the right-angled triangle below the diagonal, 3/4 are on the left.
  const UvTriangle corner{{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_THAT(baked(half, base_color, MapKind::faces, 0, corner, Averaging::codes),
              testing::ElementsAre(MapValue{64, 64, 64, 0}));
}

TEST(AttributeMaps, AFaceWithinATexelIsTheTexel) {
  const ColourImage image = random_image(4, 4);
  const UvTriangle corner{{{0, 0}, {1, 0}, {0, 1}}};
  const auto map = baked(image, base_color, MapKind::faces, 2, corner);
  for (const auto& [u, v] : {std::pair{0.05, 0.05}, {0.3, 0.05}, {0.05, 0.55}, {0.7, 0.2}, {0.2, 0.2}}) {
    const auto x = static_cast<std::size_t>(4 * u), y = static_cast<std::size_t>(4 * v);
    const std::uint8_t* const texel = image.rgba.data() + 4 * (x + 4 * y);
    EXPECT_EQ(map[face_index(2, u, v)], (MapValue{texel[0], texel[1], texel[2], 0})) << u << ", " << v;
  }
}

TEST(AttributeMaps, AVertexIsWhatTheSamplerGives) {
  const ColourImage half = drawn(2, 1, [](auto x, auto, auto) { return 255 * x; });
  // The first row of micro-vertices from u = 0 to 1: at 0 and 1 beyond the centres, in the middle between them.
  const UvTriangle line{{{0, 0.5f}, {1, 0.5f}, {0, 0.5f}}};
  const auto codes = [&](Wrap wrap, Averaging averaging) {
    const auto map = baked(half, base_color, MapKind::vertices, 1, line, averaging, wrap);
    return std::array{map[0][0], map[1][0], map[3][0]};  // (0,0) (1,0) (2,0)
  };
  EXPECT_EQ(codes(Wrap::clamp_to_edge, Averaging::codes), (std::array<std::uint8_t, 3>{0, 128, 255}));
  EXPECT_EQ(codes(Wrap::clamp_to_edge, Averaging::meaning), (std::array<std::uint8_t, 3>{0, 188, 255}));
  EXPECT_EQ(codes(Wrap::repeat, Averaging::codes), (std::array<std::uint8_t, 3>{128, 128, 128}));
  EXPECT_EQ(codes(Wrap::mirrored_repeat, Averaging::codes), (std::array<std::uint8_t, 3>{0, 128, 255}));
}

TEST(AttributeMaps, NormalsAreMadeOneUnitLongAgain) {
  // 2 218/255 - 1 = 0.7098, 2 37/255 - 1 = -0.7098: between them lies (0, 0.004, 0.71), which is (0, 0.006, 1).
  const ColourImage tilted = drawn(2, 1, [](auto x, auto, auto c) {
    return c == 0 ? (x == 0 ? 218 : 37) : c == 1 ? 128 : 218;
  });
  const UvTriangle both{{{0, 0}, {1, 0}, {0.5f, 1}}};
  EXPECT_THAT(baked(tilted, set_of(Attribute::normal), MapKind::faces, 0, both),
              testing::ElementsAre(MapValue{128, 128, 255, 0}));
  EXPECT_THAT(baked(tilted, set_of(Attribute::normal), MapKind::faces, 0, both, Averaging::codes),
              testing::ElementsAre(MapValue{128, 128, 218, 0}));
}

TEST(AttributeMaps, HoldTheChannelsInUseAlone) {
  const ColourImage image = drawn(1, 1, [](auto, auto, auto c) { return 10 * (c + 1); });
  const UvTriangle all{{{0, 0}, {1, 0}, {0, 1}}};
  const auto value = [&](AttributeSet set) { return baked(image, set, MapKind::faces, 0, all)[0]; };
  EXPECT_EQ(value(base_color), (MapValue{10, 20, 30, 0}));
  EXPECT_EQ(value(set_of(Attribute::metallic_roughness)), (MapValue{0, 20, 30, 0}));
  EXPECT_EQ(value(set_of(Attribute::occlusion)), (MapValue{10, 0, 0, 0}));
  EXPECT_EQ(value(set_of(Attribute::occlusion) | set_of(Attribute::metallic_roughness)),
            (MapValue{10, 20, 30, 0}));
}

TEST(AttributeMaps, AreRefusedWhereTheyCannotBe) {
  const ColourImage image = random_image(2, 2);
  const MapBaker baker(image, {base_color, 0, {}}, Averaging::meaning);
  std::vector<MapValue> map(4);
  EXPECT_THROW(baker.bake({{{0, 0}, {1, 0}, {0, 1}}}, MapKind::faces, 2, map), std::invalid_argument);
  EXPECT_THROW(baker.bake({{{0, 0}, {0x1p20f, 0}, {0, 1}}}, MapKind::faces, 1, map), std::invalid_argument);
  EXPECT_THROW(baker.bake({{{0, 0}, {NAN, 0}, {0, 1}}}, MapKind::faces, 1, map), std::invalid_argument);
}

TEST(AttributeReading, OfVerticesReproducesALinearFunction) {
  constexpr unsigned level = 2;
  const CodeMeaning codes(base_color, Averaging::codes);
  std::vector<MapValue> map(values_of_map(MapKind::vertices, level));
  for (std::uint32_t r = 0; r <= 4; ++r)
    for (std::uint32_t j = 0; j <= r; ++j)
      map[r * (r + 1) / 2 + j] = {static_cast<std::uint8_t>(20 * (r - j) + 12 * j + 8), 0, 0, 0};
  for (int i = 0; i <= 64; ++i)
    for (int j = 0; i + j <= 64; ++j) {
      const double u = i / 64., v = j / 64.;
      const MapValue value = vertex_value(map, level, u, v, MapReading::interpolated, codes);
      ASSERT_EQ(value[0], std::floor(80 * u + 48 * v + 8 + 0.5)) << u << ", " << v;
    }
}

TEST(AttributeReading, OfTheNearestVertexIsOneOfTheThree) {
  const CodeMeaning codes(base_color, Averaging::codes);
  const std::vector<MapValue> map{{1, 0, 0, 0}, {2, 0, 0, 0}, {3, 0, 0, 0}};  // w, u, v
  const auto at = [&](double u, double v) {
    return vertex_value(map, 0, u, v, MapReading::nearest, codes)[0];
  };
  EXPECT_EQ(at(0.1, 0.2), 1);
  EXPECT_EQ(at(0.8, 0.1), 2);
  EXPECT_EQ(at(0.1, 0.8), 3);
  EXPECT_EQ(at(1, 0), 2);
  EXPECT_EQ(at(0, 1), 3);
}

using Maps = std::vector<std::vector<MapValue>>;

DistinctMaps distinct(const Maps& maps, std::uint64_t most, std::size_t* made_again = nullptr,
                      DistinctMaps::Hash hash = hash_of) {
  return DistinctMaps(
      2, most,
      [&maps, made_again](std::size_t owner, std::vector<MapValue>& map) {
        if (made_again != nullptr) ++*made_again;
        map = maps[owner];
      },
      hash);
}

const Maps six{{{1, 2, 3, 0}, {4, 5, 6, 0}}, {{4, 5, 6, 0}, {1, 2, 3, 0}}, {{1, 2, 3, 0}, {4, 5, 6, 0}},
               {{7, 7, 7, 0}, {7, 7, 7, 0}}, {{7, 7, 7, 0}, {7, 7, 7, 0}}, {{8, 8, 8, 0}, {8, 8, 8, 0}}};

TEST(DistinctMaps, AreNumberedAsTheyAppear) {
  DistinctMaps maps = distinct(six, 100);
  EXPECT_EQ(maps.count(), 0u);
  // Owners come in two parts, not in their order.
  EXPECT_THAT(maps.add(std::vector<std::size_t>{1, 0, 2}), testing::ElementsAre(0, 1, 1));
  EXPECT_EQ(maps.constant(), 0u);
  EXPECT_THAT(maps.add(std::vector<std::size_t>{3, 4, 5, 0}), testing::ElementsAre(2, 2, 3, 1));
  EXPECT_EQ(maps.count(), 4u);
  EXPECT_EQ(maps.constant(), 2u);
  EXPECT_TRUE(maps.kept());
  EXPECT_THAT(maps.values(), testing::ElementsAre(six[1][0], six[1][1], six[0][0], six[0][1], six[3][0],
                                                  six[3][1], six[5][0], six[5][1]));
}

TEST(DistinctMaps, OfOneHashAreToldApart) {
  DistinctMaps maps = distinct(six, 100, nullptr, [](std::span<const MapValue>) { return std::uint64_t{1}; });
  EXPECT_THAT(maps.add(std::vector<std::size_t>{0, 1, 2, 3, 4, 5}), testing::ElementsAre(0, 1, 0, 2, 2, 3));
}

TEST(DistinctMaps, BeyondTheLimitAreMadeAgain) {
  std::size_t made = 0;
  DistinctMaps maps = distinct(six, 3, &made);
  EXPECT_THAT(maps.add(std::vector<std::size_t>{0, 1, 2, 3, 4, 5}), testing::ElementsAre(0, 1, 0, 2, 2, 3));
  EXPECT_FALSE(maps.kept());
  EXPECT_EQ(maps.values().size(), 2u);  // of the first map alone
  EXPECT_EQ(made, 7u);                  // map 3 again, beside its equal, map 4
  std::vector<MapValue> space;
  for (const auto& [number, owner] : {std::pair{0u, 0u}, {1u, 1u}, {2u, 3u}, {3u, 5u}})
    EXPECT_TRUE(std::ranges::equal(maps.map(number, space), six[owner])) << number;
}

TEST(DistinctMaps, AreManyAtOnce) {
  Maps many;
  for (std::uint32_t k = 0; k < 10000; ++k)
    many.push_back({{static_cast<std::uint8_t>(k % 100), static_cast<std::uint8_t>(k % 7), 0, 0}, {}});
  DistinctMaps maps = distinct(many, 1 << 20);
  std::vector<std::size_t> owners(many.size());
  std::iota(owners.begin(), owners.end(), std::size_t{0});
  std::vector<std::atomic<int>> made(many.size());
  const std::vector<std::uint32_t> numbers =
      maps.add(owners, [&](std::size_t k, std::span<const MapValue> map) {
        made[k] += std::ranges::equal(map, many[k]) ? 1 : 2;
      });
  EXPECT_EQ(maps.count(), 700u);
  for (std::size_t k = 0; k < many.size(); ++k) {
    EXPECT_EQ(made[k], 1);
    EXPECT_EQ(numbers[k], k < 700 ? k : numbers[k - 700]);
  }
}

TEST(AttributeAtlas, GivesEachTexelToTheFirstTriangleThatShowsIt) {
  const ColourImage image = random_image(4, 4);
  const std::vector<TexelTriangle> halves{{{{0, 0}, {4, 0}, {0, 4}}}, {{{0, 4}, {4, 0}, {4, 4}}}};
  const std::vector<Sampler> samplers(2, wrapped_as(Wrap::repeat));
  const auto first = first_triangles(image, samplers, halves);
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x)
      EXPECT_EQ(first[x + 4 * y], x + y <= 3 ? 0u : 1u);  // the diagonal's are the first's
  // One repeat further left and below: the same texels.
  const std::vector<TexelTriangle> shifted{{{{-4, 4}, {0, 4}, {-4, 8}}}};
  const auto again = first_triangles(image, samplers, shifted);
  for (std::size_t k = 0; k < again.size(); ++k) EXPECT_EQ(again[k], first[k] == 0 ? 0 : no_triangle);
  // The same place by another addressing: other texels.
  const std::vector<TexelTriangle> beyond(2, TexelTriangle{{{4, 0}, {8, 0}, {4, 4}}});
  const std::vector<Sampler> both{wrapped_as(Wrap::clamp_to_edge), wrapped_as(Wrap::repeat)};
  const auto shown = first_triangles(image, both, beyond);
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x)
      EXPECT_EQ(shown[x + 4 * y], x == 3 ? 0u : x + y <= 3 ? 1u : no_triangle) << x << ' ' << y;
  EXPECT_TRUE(within_reach({{{0, 0}, {4000, 0}, {0, 4000}}}));
  EXPECT_FALSE(within_reach({{{0, 0}, {4100, 0}, {0, 4100}}}));
  EXPECT_FALSE(within_reach({{{0, 0}, {33000, 0}, {0, 1}}}));
}

TEST(SameUvs, AreThoseOfEachCornerAndOfTheTexture) {
  const MapOfTriangle one{3, {{{0, 0.25f}, {0.5f, 0.75f}, {1, 0.125f}}}};
  std::vector<MapOfTriangle> all{one};
  for (std::size_t c = 0; c < 6; ++c) {
    all.push_back(one);
    all.back().uvs[c / 2][c % 2] += 2;
  }
  all.push_back(one);
  all.back().texture = 4;
  const std::size_t others = all.size();
  for (std::size_t k = 0; k < others; ++k) all.push_back(all[k]);
  const std::vector<std::size_t> first = first_of_same_uvs(all);
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(first[k], k % others) << k;
}

const MapsAtLevel& at(const AttributeFigures& figures, unsigned level, MapKind kind) {
  for (const MapsAtLevel& one : figures.sets.at(0).levels)
    if (one.level == level && one.kind == kind) return one;
  throw std::out_of_range("no such level");
}

TEST(AttributeMeasure, FacesThatLieWithinTexelsLoseNothing) {
  // 8 x 8 texels, each cut in two at level 3.
  const AttributeScene scene = square_scene(random_image(8, 8));
  const AttributeFigures figures = measure(scene, {.first = 0, .last = 3});
  EXPECT_EQ(figures.texture_bytes, 256u);
  EXPECT_EQ(figures.sets.at(0).shown, 64u);
  EXPECT_EQ(at(figures, 3, MapKind::faces).error.rmse, 0);
  EXPECT_EQ(at(figures, 3, MapKind::faces).error.flip, 0);
  EXPECT_EQ(at(figures, 3, MapKind::faces).bytes(), 2u * 64 * 4);
  // 36 of each triangle's 64 micro-triangles touch the centre of their texel. It lies on the edge of both halves, and
  // one of them has it.
  EXPECT_EQ(at(figures, 3, MapKind::faces).unseen, 28. / 64);
  for (unsigned level = 0; level < 3; ++level) EXPECT_GT(at(figures, level, MapKind::faces).error.flip, 0);
  // 2 maps of 64 faces take 512 bytes, of 16 128; of 45 vertices 360, of 15 120.
  EXPECT_EQ(figures.level_beyond_textures(MapKind::faces), 3u);
  EXPECT_EQ(figures.level_beyond_textures(MapKind::vertices), 3u);
  EXPECT_EQ(measure(scene, {.first = 0, .last = 1}).level_beyond_textures(MapKind::faces), 3u);
}

TEST(AttributeMeasure, TheErrorIsTheMeanOverTexels) {
  // Two texels, 0 and 100, under two faces, of which each has 3/4 of one and 1/4 of the other: 25 and 75.
  const AttributeFigures figures =
      measure(square_scene(drawn(2, 1, [](auto x, auto, auto) { return 100 * x; })),
              {.first = 0, .last = 0, .averaging = Averaging::codes});
  EXPECT_DOUBLE_EQ(at(figures, 0, MapKind::faces).error.rmse.value(), 25);
}

TEST(AttributeMeasure, OneColourIsOneMapAndNoError) {
  const AttributeFigures figures = measure(
      square_scene(drawn(5, 3, [](auto, auto, auto c) { return 40 * (c + 1); })), {.first = 0, .last = 2});
  for (unsigned level = 0; level <= 2; ++level)
    for (const MapKind kind : map_kinds) {
      EXPECT_EQ(at(figures, level, kind).distinct, 1u);
      EXPECT_EQ(at(figures, level, kind).constant, 1u);
      EXPECT_EQ(at(figures, level, kind).error.rmse, 0);
      EXPECT_EQ(at(figures, level, kind).error.flip, 0);
    }
}

TEST(AttributeMeasure, NormalsAreHeldAgainstNormalsOfUnitLength) {
  // (0.25, 0.25, 0.25) and a little about it, half as long as it should be: faces within texels have the direction.
  const AttributeScene scene = square_scene(
      drawn(2, 2, [](auto x, auto y, auto c) { return 160 + 8 * (x + y + c); }), set_of(Attribute::normal));
  EXPECT_EQ(at(measure(scene, {.first = 1, .last = 1}), 1, MapKind::faces).error.rmse, 0);
  EXPECT_EQ(at(measure(scene, {.first = 1, .last = 1, .averaging = Averaging::codes}), 1, MapKind::faces)
                .error.rmse,
            0);
}

TEST(AttributeMeasure, OfATriangleThatShowsNoTexelHasNoError) {
  // Within a texel, left of and below its centre.
  AttributeScene scene = square_scene(random_image(4, 4));
  scene.primitives.front() = {0, 0, {{0, 1, 2}}, {{0, {{0, 0}, {0.1f, 0}, {0, 0.1f}}}}};
  const AttributeFigures figures = measure(scene, {.first = 0, .last = 1});
  EXPECT_EQ(figures.sets.at(0).shown, 0u);
  for (const MapsAtLevel& one : figures.sets.at(0).levels) {
    EXPECT_EQ(one.distinct, 1u);
    EXPECT_EQ(one.error.rmse, std::nullopt);
    EXPECT_EQ(one.error.flip, std::nullopt);
    EXPECT_EQ(one.unseen, one.kind == MapKind::faces ? std::optional(1.0) : std::nullopt);
    EXPECT_EQ(one.nearest.value_or(MapError{}).rmse, std::nullopt);
  }
}

TEST(AttributeMeasure, IsTheSameForAnyNumberOfThreads) {
  const AttributeScene scene = square_scene(random_image(40, 24));
  const auto figures = [&](unsigned threads) {
    std::vector<double> all;
    const AttributeFigures measured = measure(scene, {.first = 0, .last = 3, .threads = threads});
    for (const MapsAtLevel& one : measured.sets.at(0).levels)
      for (const double x :
           {*one.error.rmse, *one.error.flip, static_cast<double>(one.distinct), one.unseen.value_or(-1)})
        all.push_back(x);
    return all;
  };
  EXPECT_EQ(figures(1), figures(3));
}

TEST(AttributeMeasure, CountsTrianglesOnOnePlaceAsIfEachWereMeasured) {
  const AttributeScene once = square_scene(random_image(12, 8));
  AttributeScene thrice = once;
  // The same places again, and one turned by a corner: another place, whose map differs.
  thrice.primitives[0].triangles = {{0, 1, 2}, {2, 1, 3}, {0, 1, 2}, {1, 2, 0}, {2, 1, 3}};
  std::vector<MapOfTriangle> all;
  for (const Triangle& t : thrice.primitives[0].triangles) {
    const std::vector<Uv>& uvs = thrice.primitives[0].uses[0].uvs;
    all.push_back({0, {uvs[t[0]], uvs[t[1]], uvs[t[2]]}});
  }
  EXPECT_THAT(first_of_same_uvs(all), testing::ElementsAre(0, 1, 0, 3, 1));
  all[4].texture = 1;
  EXPECT_EQ(first_of_same_uvs(all).back(), 4u);

  for (const unsigned level : {0u, 3u}) {
    const auto levels = [&](const AttributeScene& scene) {
      return measure(scene, {.first = level, .last = level, .packed = true}).sets.at(0).levels;
    };
    const std::vector<MapsAtLevel> one = levels(once), three = levels(thrice);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(three[k].error.rmse, one[k].error.rmse);
      EXPECT_EQ(three[k].error.flip, one[k].error.flip);
      const bool turned_differs = level > 0 || three[k].kind == MapKind::vertices;
      EXPECT_EQ(three[k].distinct, turned_differs ? 3u : 2u);
      EXPECT_EQ(three[k].packed->plain, 3 * three[k].distinct * values_of_map(three[k].kind, level));
    }
    // Faces without a texel are counted once a triangle: the first place has three triangles, the second two.
    const auto share = [&](const std::vector<MapsAtLevel>& of) {
      return of[0].kind == MapKind::faces ? *of[0].unseen : *of[1].unseen;
    };
    AttributeScene first = once, second = once;
    first.primitives[0].triangles = {{0, 1, 2}};
    second.primitives[0].triangles = {{2, 1, 3}};
    const double of_five = 3 * share(levels(first)) + 2 * share(levels(second));
    EXPECT_NEAR(share(three), of_five / 5, 1e-12);
  }
}

TEST(AttributeMeasure, LeavesOutWhatSpansTooMuch) {
  AttributeScene scene = square_scene(random_image(8, 8));
  scene.primitives[0].uses[0].uvs[3] = {2000, 2000};  // a box of 16000^2 texels
  const AttributeFigures figures = measure(scene, {.first = 0, .last = 0});
  EXPECT_EQ(figures.far, 1u);
  EXPECT_EQ(figures.sets.at(0).triangles, 1u);
  EXPECT_THROW(measure(scene, {.first = 2, .last = 1}), std::invalid_argument);
  EXPECT_THROW(measure(scene, {.first = 0, .last = finest_attribute_level + 1}), std::invalid_argument);
}

TEST(AttributeMeasure, TellsOfPicturesOfColoursAlone) {
  std::vector<unsigned> levels;
  AttributeOptions options{.first = 1, .last = 2};
  options.picture = [&](const AttributePicture& picture) {
    levels.push_back(picture.level);
    const RgbPicture all = side_by_side(picture, 4);
    // Three tiles of 4 x 2 beside each other, two above each other, 4 white pixels between.
    EXPECT_EQ(all.width, 3u * 4 + 2 * 4);
    EXPECT_EQ(all.height, 2u * 2 + 4);
    EXPECT_EQ(all.rgb.size(), std::size_t{3} * all.width * all.height);
  };
  measure(square_scene(random_image(8, 4)), options);
  EXPECT_THAT(levels, testing::ElementsAre(1, 2));
  measure(square_scene(random_image(8, 4), set_of(Attribute::normal)), options);
  EXPECT_EQ(levels.size(), 2u);
}

// The packed maps are the baked ones: the stored maps at level 2, unpacked, against maps baked one by one.
TEST(AttributeMeasure, PacksTheMapsAndSaysWhoseTheyAre) {
  const ColourImage image = random_image(8, 8);
  AttributeOptions options{.first = 2, .last = 2, .packed = true};
  options.peer = [](std::span<const std::uint8_t> bytes) { return bytes.size() + 1; };
  std::vector<StoredAttributes> stored;
  options.stored = [&](const StoredAttributes& one) { stored.push_back(one); };
  const AttributeFigures figures = measure(square_scene(image), options);
  for (const MapKind kind : map_kinds) {
    const PackedBytes& packed = at(figures, 2, kind).packed.value();
    EXPECT_EQ(packed.plain, 2 * 3 * values_of_map(kind, 2));
    EXPECT_EQ(packed.peer, packed.plain + 1);
    // Noise: no less than its entropy, and no more than 9/8 and the widths.
    EXPECT_LT(packed.packed, packed.plain * 9 / 8 + 12);
    EXPECT_GT(packed.entropy, 0u);
    EXPECT_EQ(packed.worst_error, 0);
    EXPECT_EQ(packed.rms_error, 0);
  }
  ASSERT_EQ(stored.size(), 2u);
  using namespace mmverify::impl::attribute;
  for (const StoredAttributes& one : stored) {
    const AttributeMaps maps = read_attributes(write_attributes(one.maps));
    EXPECT_EQ(maps.maps, 2u);
    EXPECT_EQ(maps.meaning, Meaning::srgb);
    EXPECT_THAT(maps.triangles, testing::ElementsAre(MapUse{0, 0}, MapUse{1, 0}));
    const bool faces = maps.at == MapAt::faces;
    const auto first =
        baked(image, base_color, faces ? MapKind::faces : MapKind::vertices, 2, {{{0, 0}, {1, 0}, {0, 1}}});
    for (std::uint32_t x = 0; x < first.size(); ++x) {
      const Vertex v = faces ? Vertex{} : w_minor_vertex(x);
      const std::size_t to = faces ? x : bird_index(v.i, v.j, 2);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(maps.codes[3 * to + c], first[x][c]) << x;
    }
  }
}

// With an error of 1 a code becomes the multiple of 3 beside it: 3k stays, 3k-1 and 3k+1 are off by one.
TEST(AttributeMeasure, SaysHowFarPackedMapsAreOff) {
  AttributeOptions options{.first = 2, .last = 2, .packed = true, .packed_error = 1};
  std::vector<std::vector<std::uint8_t>> stored;
  options.stored = [&](const StoredAttributes& one) { stored.push_back(one.maps.codes); };
  const AttributeFigures figures = measure(square_scene(random_image(8, 8)), options);
  ASSERT_EQ(stored.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const PackedBytes& packed = at(figures, 2, map_kinds[k]).packed.value();
    const auto off = static_cast<double>(
        std::count_if(stored[k].begin(), stored[k].end(), [](std::uint8_t code) { return code % 3 != 0; }));
    EXPECT_EQ(packed.worst_error, 1);
    EXPECT_DOUBLE_EQ(packed.rms_error, std::sqrt(off / static_cast<double>(stored[k].size())));
  }
}

// Images are measured by their numbers, and triangles come in the scene's order: here the other way round.
TEST(AttributeMeasure, NumbersStoredMapsByTheirTriangles) {
  AttributeScene scene = square_scene(drawn(4, 4, [](auto, auto, auto) { return 9; }));
  scene.images.push_back(drawn(4, 4, [](auto, auto, auto) { return 200; }));
  scene.textures.push_back({base_color, 1, wrapped_as(Wrap::clamp_to_edge)});
  scene.primitives.push_back(scene.primitives.front());
  scene.primitives.front().uses.front().texture = 1;
  std::vector<StoredAttributes> stored;
  AttributeOptions options{.first = 0, .last = 0};
  options.stored = [&](const StoredAttributes& one) { stored.push_back(one); };
  measure(scene, options);
  ASSERT_EQ(stored.size(), 2u);
  for (const StoredAttributes& one : stored) {
    using mmverify::impl::attribute::MapUse;
    EXPECT_THAT(one.maps.triangles,
                testing::ElementsAre(MapUse{0, 0}, MapUse{0, 0}, MapUse{1, 0}, MapUse{1, 0}));
    EXPECT_EQ(one.maps.codes.front(), 200);
    EXPECT_EQ(one.maps.codes.back(), 9);
  }
}

TEST(AttributeMeasure, PacksEqualMapsOnce) {
  AttributeOptions options{.first = 1, .last = 1, .packed = true};
  std::vector<std::uint32_t> maps;
  options.stored = [&](const StoredAttributes& one) { maps.push_back(one.maps.maps); };
  const AttributeFigures figures =
      measure(square_scene(drawn(4, 4, [](auto, auto, auto) { return 9; })), options);
  EXPECT_THAT(maps, testing::ElementsAre(1, 1));
  EXPECT_EQ(at(figures, 1, MapKind::faces).packed.value().entropy, 0u);
  // 3 roots, a start, 3 widths of 0 bits.
  EXPECT_EQ(at(figures, 1, MapKind::faces).packed.value().packed, 3u + 4 + 2);
}

TEST(AttributePictures, ErrorsGoFromBlackToWhite) {
  EXPECT_EQ(colour_of_error(0), (std::array<std::uint8_t, 3>{0, 0, 0}));
  EXPECT_EQ(colour_of_error(1), (std::array<std::uint8_t, 3>{255, 255, 255}));
  for (int k = 1; k <= 100; ++k) {
    const auto luminance = [](const std::array<std::uint8_t, 3>& c) { return 2 * c[0] + 7 * c[1] + c[2]; };
    EXPECT_GT(luminance(colour_of_error(static_cast<float>(k) / 100)),
              luminance(colour_of_error(static_cast<float>(k - 1) / 100)));
  }
}

}  // namespace
