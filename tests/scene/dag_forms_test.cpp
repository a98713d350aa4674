// bench/scene/dag*: which maps are compared, what each form takes by formulas and by other code, what is decoded again.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "bench/scene/compressors.hpp"
#include "bench/scene/dag.hpp"
#include "bench/scene/state_entropy.hpp"
#include "impl/dag/dag.hpp"
#include "scene/bake/footprint.hpp"
#include "scene/bake/vq_footprint.hpp"
#include "scene/read/load.hpp"
#include "tests/scene/made_scene.hpp"

namespace scene_dag_forms_test {

using namespace mmverify::bench;
using mmverify::impl::micromap::Format;
using mmverify::tests::Made;
using mmverify::tests::made_scene;
using Map = std::vector<std::uint8_t>;

constexpr Format both[] = {Format::two_state, Format::four_state};

SceneDagOptions few_lookups() {
  SceneDagOptions options;
  options.lookups = 2000;
  return options;
}

Map of_array(const mmverify::impl::micromap::Array& array, const mmverify::impl::micromap::Record& record) {
  const auto format = static_cast<Format>(record.format);
  const std::uint64_t count = mmverify::impl::micromap::micro_triangles(record.level);
  const auto bytes =
      std::span(array.data).subspan(record.offset, mmverify::impl::micromap::packed_bytes(count, format));
  if (format == Format::four_state) return Map(bytes.begin(), bytes.end());
  Map wide(mmverify::impl::micromap::packed_bytes(count, Format::four_state));
  mmverify::impl::micromap::widen(bytes, count, wide);
  return wide;
}

// The array of the pipeline is built by other code, its 2-state records made 4-state again.
void expect_maps_of_the_array(const mmverify::scene::Scene& scene, unsigned level) {
  const Made made(level, {}, scene);
  std::set<Map> records, maps;
  for (const auto& record : made.a.array.records) records.insert(of_array(made.a.array, record));
  const SceneMaps of_scene(made.s, made.p);
  const MapsAtLevel in =
      of_scene.in_format(level, Format::four_state, of_scene.baked(level, of_scene.uses().size()));
  maps.insert(in.maps.begin(), in.maps.end());
  EXPECT_EQ(maps, records);
  EXPECT_EQ(in.taken, in.uniform + in.maps.size());
  std::uint64_t triangles = 0, coded = 0;
  for (const std::uint64_t n : in.triangles) triangles += n;
  for (const auto& primitive : made.p.primitives) coded += primitive.triangles.size();
  EXPECT_EQ(triangles, coded - made.a.special);
}

TEST(SceneDagForms, TheMapsAreTheRecordsOfTheArray) {
  for (const unsigned level : {1u, 3u, 4u, 6u}) expect_maps_of_the_array(made_scene(), level);
}

TEST(SceneDagForms, TheMapsOfARealSceneAreTheRecordsOfItsArray) {
  const std::string file = MMVERIFY_SCENES "/scatter_grove/scatter_grove.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  expect_maps_of_the_array(mmverify::scene::load(file), 5);
}

// Five triangles: one twice with other orders of its vertices, so four maps, and one opaque.  The disc is not symmetric.
TEST(SceneDagForms, SizesAreThoseOfTheFormulas) {
  const Made made;
  const SceneMaps maps(made.s, made.p);
  ASSERT_EQ(maps.uses().size(), 5u);
  for (const std::uint32_t level : {4u, 5u, 7u})
    for (const Format format : both) {
      const MapsAtLevel in = maps.in_format(level, format, maps.baked(level, 5));
      const SceneDagFigures f = scene_dag_figures(in, few_lookups());
      EXPECT_EQ(f.taken, 5u);
      EXPECT_EQ(f.uniform, 1u);
      EXPECT_EQ(f.maps, 4u);
      EXPECT_EQ(f.distinct, 4u);
      const std::uint64_t map = (in.bits << (2 * level)) / 8;
      EXPECT_EQ(f.form(SceneForm::flat).bytes, 4 * (map + 8));
      EXPECT_EQ(f.form(SceneForm::once).bytes, 4 * (map + 8));
      // The graph's bound, docs/DAG.md.
      EXPECT_LE(f.form(SceneForm::dag).bytes, f.form(SceneForm::once).bytes);
      EXPECT_FALSE(f.form(SceneForm::flat).ns || f.form(SceneForm::zstd).ns);
      for (const SceneForm form : {SceneForm::once, SceneForm::paper, SceneForm::ranked, SceneForm::dag})
        EXPECT_TRUE(f.form(form).ns && *f.form(form).ns > 0) << to_string(form);
    }
}

TEST(SceneDagForms, EachTriangleOfAMeshCountsInFlatAndEachMapOnceInTheOthers) {
  const Made made;
  const SceneMaps maps(made.s, made.p);
  MapsAtLevel in = maps.in_format(4, Format::four_state, maps.baked(4, 5));
  const std::uint64_t paper = scene_dag_figures(in, few_lookups()).form(SceneForm::paper).bytes;
  in.triangles = {10, 1, 1, 1};
  in.maps.push_back(in.maps[0]);  // as another texture's can be
  in.triangles.push_back(100);
  const SceneDagFigures f = scene_dag_figures(in, few_lookups());
  EXPECT_EQ(f.maps, 5u);
  EXPECT_EQ(f.distinct, 4u);
  EXPECT_EQ(f.form(SceneForm::flat).bytes, 113 * (64 + 8));
  EXPECT_EQ(f.form(SceneForm::once).bytes, 4 * 64 + 5 * 8);
  EXPECT_EQ(f.form(SceneForm::paper).bytes, paper + 8);
}

TEST(SceneDagForms, TheGraphDecodesToTheMapsAndTakesWhatIsSaid) {
  const Made made;
  const SceneMaps maps(made.s, made.p);
  for (const Format format : both) {
    const MapsAtLevel in = maps.in_format(6, format, maps.baked(6, 5));
    mmverify::impl::dag::Dag dag(mmverify::impl::dag::Format{in.bits});
    for (const Map& map : in.maps) dag.add(6, map);
    for (std::uint32_t k = 0; k < dag.maps(); ++k) {
      Map again(in.maps[k].size());
      dag.decode(k, again);
      EXPECT_EQ(again, in.maps[k]);
    }
    EXPECT_EQ(scene_dag_figures(in, few_lookups()).form(SceneForm::dag).bytes, dag.bits() / 8);
  }
}

void expect_common_subtrees_of(const SceneMaps& maps, std::uint32_t first, std::uint32_t last) {
  MergedLevels merged;
  std::uint64_t apart = 0;
  for (std::uint32_t level = first; level <= last; ++level)
    for (const Format format : both) {
      const MapsAtLevel in = maps.in_format(level, format, maps.baked(level, maps.uses().size()));
      CommonSubtrees csm(true);
      for (const Map& map : in.maps) csm.add(level, in.bits, map);
      for (std::uint32_t k = 0; k < csm.maps(); ++k) {
        Map again(in.maps[k].size());
        csm.decode(k, again);
        EXPECT_EQ(again, in.maps[k]);
        for (std::uint32_t at = 0; at < 1u << 2 * level; ++at)
          ASSERT_EQ(csm.at(k, at), mmverify::tests::code(in.maps[k], at, in.bits));
      }
      const SceneDagFigures f = scene_dag_figures(in, few_lookups());
      EXPECT_EQ(f.csm.csm_bytes, csm.bits() / 8);
      EXPECT_EQ(f.csm.dag_bytes, f.form(SceneForm::dag).bytes);
      EXPECT_EQ(f.csm.once_bytes, f.form(SceneForm::once).bytes);
      EXPECT_EQ(f.csm.flat_bytes, f.form(SceneForm::flat).bytes);
      apart += csm.bits() / 8;
      merged.add(level, in.bits, in.maps);
    }
  EXPECT_LT(merged.bytes().csm, apart);
}

TEST(SceneDagForms, CommonSubtreesGiveEachStateAgain) {
  const Made made;
  expect_common_subtrees_of(SceneMaps(made.s, made.p), 3, 7);
}

TEST(SceneDagForms, CommonSubtreesGiveEachStateOfARealSceneAgain) {
  const std::string file = MMVERIFY_SCENES "/scatter_grove/scatter_grove.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const mmverify::scene::Scene scene = mmverify::scene::load(file);
  const mmverify::scene::Plan plan = mmverify::scene::plan(scene);
  expect_common_subtrees_of(SceneMaps(scene, plan), 5, 6);
}

// `scene` prints the footprint of the same maps: the array's records, widened or forced, in the same order. The array
// holds equal maps once, so the graph may have fewer records.
TEST(SceneDagForms, TheGraphOfTheFootprintIsThatOfTheComparison) {
  for (const unsigned level : {2u, 4u, 6u}) {
    const Made made(level);
    const SceneMaps maps(made.s, made.p);
    const auto footprint = mmverify::scene::footprint(made.s, made.p, made.a, 1);
    for (const Format format : both) {
      const MapsAtLevel in = maps.in_format(level, format, maps.baked(level, 5));
      const auto& mode = footprint.mode[in.bits - 1];
      const SceneDagFigures f = scene_dag_figures(in, few_lookups());
      EXPECT_EQ(mode.records, f.distinct);
      EXPECT_EQ(mode.graph - 8 * mode.records, f.form(SceneForm::dag).bytes - 8 * f.maps);
      EXPECT_LE(mode.graph, mode.data + 8 * mode.records);
    }
  }
}

TEST(SceneDagForms, CompressedSizesAreOfAllMapsAndTheyDecompress) {
  const Made made;
  const SceneMaps maps(made.s, made.p);
  const MapsAtLevel in = maps.in_format(6, Format::four_state, maps.baked(6, 5));
  Map all;
  for (const Map& map : in.maps) all.insert(all.end(), map.begin(), map.end());
  const SceneDagFigures f = scene_dag_figures(in, few_lookups());
  for (const auto& [form, how] :
       {std::pair{SceneForm::lz4, Compressor::lz4}, {SceneForm::zstd, Compressor::zstd}}) {
    const Map packed = compressed(how, all);
    EXPECT_EQ(decompressed(how, packed, all.size()), all);
    EXPECT_EQ(f.form(form).bytes, packed.size());
  }
}

TEST(Compressors, GiveTheVeryBytesAgain) {
  std::mt19937_64 random(1);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{200'000}})
    for (const bool noise : {false, true}) {
      Map bytes(size);
      for (auto& byte : bytes) byte = noise ? static_cast<std::uint8_t>(random()) : 7;
      for (const Compressor how : {Compressor::lz4, Compressor::zstd})
        EXPECT_EQ(decompressed(how, compressed(how, bytes), size), bytes) << size << ' ' << noise;
    }
}

// 64 KiB is as far as LZ4 looks back; zstd here sees all.
TEST(Compressors, NoiseThatRepeatsFarAwayIsFoundByZstdAlone) {
  std::mt19937_64 random(1);
  Map bytes(1 << 20);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  for (int k = 0; k < 15; ++k) bytes.insert(bytes.end(), bytes.begin(), bytes.begin() + (1 << 20));
  EXPECT_LT(compressed(Compressor::zstd, bytes).size(), 9u << 17);
  EXPECT_GT(compressed(Compressor::lz4, bytes).size(), 15u << 20);
}

TEST(Compressors, RefuseWhatIsNotTheirs) {
  const Map bytes(1000, 7);
  for (const Compressor how : {Compressor::lz4, Compressor::zstd}) {
    const Map packed = compressed(how, bytes);
    EXPECT_THROW(decompressed(how, packed, 999), std::runtime_error);
    EXPECT_THROW(decompressed(how, packed, 1001), std::runtime_error);
    EXPECT_THROW(decompressed(how, std::span(packed).first(packed.size() - 1), 1000), std::runtime_error);
  }
}

TEST(SceneDagForms, ASampleLiesEvenlyAmongTheMaps) {
  const Made made;
  const SceneMaps maps(made.s, made.p);
  // A level-4 map takes 64 bytes.
  EXPECT_EQ(maps.fitting(4, 63), 1u);
  EXPECT_EQ(maps.fitting(4, 128), 2u);
  EXPECT_EQ(maps.fitting(4, 1 << 20), 5u);
  const auto all = maps.baked(4, 5), two = maps.baked(4, 2);
  EXPECT_EQ(two, (std::vector<Map>{all[0], all[2]}));
}

TEST(SceneDagForms, StopIsAskedBeforeEachMap) {
  const Made made;
  const SceneMaps maps(made.s, made.p);
  int asked = 0;
  EXPECT_THROW(maps.baked(4, 5,
                          [&] {
                            if (++asked == 3) throw std::out_of_range("asked");
                          }),
               std::out_of_range);
  EXPECT_EQ(asked, 3);
}

/// Level 10, of states by number.
template <class State>
StateEntropy entropy_of(std::uint32_t bits, State state) {
  constexpr std::uint64_t count = 1 << 20;
  Map map(count * bits / 8);
  for (std::uint64_t k = 0; k < count; ++k)
    map[k * bits / 8] = static_cast<std::uint8_t>(map[k * bits / 8] | state(k) << (k * bits % 8));
  StateEntropy entropy(bits);
  entropy.add(map, count);
  return entropy;
}

TEST(StateEntropy, IsWhatPaperAndPencilSay) {
  constexpr double n = 1 << 20;
  // O T O T ...: half each; what follows 16 bits is one state always.
  const StateEntropy turns = entropy_of(1, [](std::uint64_t k) { return 1 - k % 2; });
  EXPECT_DOUBLE_EQ(turns.order_0_bytes(), n / 8);
  EXPECT_DOUBLE_EQ(turns.context_bytes().value(), 0);
  // T O T O ...: T and O both follow 16 times T once, at the beginning: a bit each.
  const StateEntropy begins = entropy_of(1, [](std::uint64_t k) { return k % 2; });
  EXPECT_DOUBLE_EQ(begins.context_bytes().value(), 2.0 / 8);
  // Four states as often, in turns: two bits a state; each follows from the one before.
  const StateEntropy four = entropy_of(2, [](std::uint64_t k) { return (k + 1) % 4; });
  EXPECT_DOUBLE_EQ(four.order_0_bytes(), 2 * n / 8);
  EXPECT_DOUBLE_EQ(four.context_bytes().value(), 0);
  // A quarter O: H = 2 - 3/4 log2(3) bits.
  const StateEntropy quarter = entropy_of(1, [](std::uint64_t k) { return std::uint64_t{k % 4 == 0}; });
  EXPECT_NEAR(quarter.order_0_bytes(), n / 8 * (2 - 0.75 * std::log2(3)), 1e-6);
}

TEST(StateEntropy, OfNoiseIsNearlyAllOfItAndOfFewStatesIsNotSaid) {
  std::mt19937_64 random(1);
  const StateEntropy noise = entropy_of(1, [&](std::uint64_t) { return random() >> 63; });
  EXPECT_NEAR(noise.order_0_bytes() * 8 / (1 << 20), 1, 1e-3);
  // 16 states a context put the frequencies off by about 1 / (2 ln 2) bits a context.
  EXPECT_NEAR(noise.context_bytes().value() * 8 / (1 << 20), 1 - 0.72 / 16, 0.01);
  StateEntropy few(1);
  few.add(Map(1 << 16, 0x55), 1 << 19);
  EXPECT_FALSE(few.context_bytes());
}

TEST(SceneGrowth, NamesTheAreaAndTheOutline) {
  std::vector<SceneDagFigures> rows;
  for (std::uint32_t level = 3; level <= 9; ++level) {
    SceneDagFigures row;
    row.level = level;
    row.bits = 1;
    row.maps = level;  // bytes are taken by the map
    const auto put = [&](SceneForm form, std::uint64_t bytes) {
      row.forms[static_cast<std::size_t>(form)].bytes = level * bytes;
    };
    put(SceneForm::flat, std::uint64_t{1} << (2 * level));
    // The first two levels are not looked at.
    put(SceneForm::dag, level < 5 ? 1 : std::uint64_t{1} << level);
    put(SceneForm::zstd, 1000);
    put(SceneForm::lz4,
        level % 2 == 0 ? std::uint64_t{3} << (3 * level / 2) : std::uint64_t{17} << (3 * level / 2 - 2));
    rows.push_back(row);
  }
  std::map<SceneForm, SceneGrowth> growth;
  for (const SceneGrowth& g : scene_growth(rows)) {
    EXPECT_EQ(g.bits, 1u);
    growth[g.form] = g;
  }
  ASSERT_EQ(growth.size(), scene_forms);
  const auto law = [&](SceneForm form) { return area_or_outline(growth[form].growth); };
  EXPECT_EQ(law(SceneForm::flat), "4^n, the area");
  EXPECT_EQ(law(SceneForm::dag), "2^n, the outline");
  EXPECT_EQ(law(SceneForm::zstd), "flat");
  // 2^1.5 is 2.83.
  EXPECT_EQ(law(SceneForm::lz4).substr(0, 4), "x2.8");
  EXPECT_EQ(law(SceneForm::paper), "none found");
  EXPECT_EQ(growth[SceneForm::dag].growth.levels, 5u);
}

TEST(SceneSquares, AreThoseOfTheFootprintBesideTheMapsOfBothTriangles) {
  const Made made;
  const auto figures = square_figures(made.s, made.p, 3, 6, 100, 1);
  ASSERT_EQ(figures.size(), 2u);
  const auto vq2 = mmverify::scene::vq2_footprint(made.m), vq4 = mmverify::scene::vq4_footprint(made.m);
  const std::uint64_t blocks = vq2.maps - vq2.uniform;
  ASSERT_GT(blocks, 0u);
  EXPECT_EQ(figures[0].form, "vq2");
  EXPECT_EQ(figures[0].bytes, vq2.bytes + 8 * blocks);
  EXPECT_EQ(figures[0].flat_bytes, blocks * 2 * (64 + 8));
  EXPECT_EQ(figures[0].substitutions, vq2.substitutions);
  EXPECT_EQ(figures[1].bytes, vq4.bytes + 8 * blocks);
  EXPECT_EQ(figures[1].flat_bytes, blocks * 2 * (256 + 8));
  EXPECT_EQ(figures[1].substitutions, vq4.substitutions);
  EXPECT_TRUE(square_figures(made.s, made.p, 6, 7, 100, 1).empty());
  EXPECT_EQ(square_figures(made.s, made.p, 5, 7, 100, 1).size(), 1u);
}

}  // namespace scene_dag_forms_test
