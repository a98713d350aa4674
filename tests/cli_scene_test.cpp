// mmverify scene: from a file to a report, and what becomes of bad ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/command.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::tests;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json parsed_scene(const std::string& text) { return json::parse(text, nullptr, false); }

void write_scene(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

const std::vector<std::string> quick_scene{"scene", "--quiet", "--samples", "200", "--level", "4"};

std::vector<std::string> with_scene(std::vector<std::string> arguments,
                                    const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(CliScene, OfOurOwnPlansBakesAndJudges) {
  const Outcome r = program(with_scene(quick_scene, {"--json", "-"}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const json all = parsed_scene(r.out);
  EXPECT_EQ(all["schema"], "mmverify.result/1");
  std::set<std::string> laws;
  for (const json& one : all["results"]) {
    laws.insert(one["law"]);
    EXPECT_TRUE(one["verdict"] == "proved" || one["verdict"] == "checked") << one;
    EXPECT_EQ(one["cases_run"], one["cases_expected"]);
  }
  for (const char* law : {"bake.conservative", "bake.tight", "micromap.valid", "micromap.indirection",
                          "tree.round_trip", "vq2.conservative", "vq4.conservative", "vq.square_map"})
    EXPECT_TRUE(laws.contains(law)) << law;
  const json& scene = all["scene"];
  EXPECT_GT(scene["plan"]["left_out"].size(), 5u);
  EXPECT_EQ(scene["bake"]["micro_triangles"], scene["plan"]["distinct_triangles"].get<int>() * 256);
  std::uint64_t states = 0;
  for (const json& count : scene["bake"]["states"]) states += count.get<std::uint64_t>();
  EXPECT_EQ(states, scene["bake"]["micro_triangles"]);
  // For people.
  EXPECT_THAT(r.err, HasSubstr("a stored micromap would be stale"));
  EXPECT_THAT(r.err, HasSubstr("rotated or mirrored"));
}

TEST(CliScene, WritesAFileThatItReadsAgain) {
  Folder folder;
  const std::string glb = folder / "out.glb";
  Outcome r = program(with_scene(quick_scene, {"-o", glb}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("no rule of EXT_mesh_opacity_micromap broken"));
  EXPECT_EQ(folder.files().size(), 1u);
  const std::string first = text_of(glb);
  r = program({"scene", glb, "--quiet", "--samples", "200", "--level", "4", "-o", folder / "again.glb"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("42 distinct"));
}

TEST(CliScene, DrawsTheSizes) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Folder folder;
  const Outcome r = program(with_scene(quick_scene, {"--sizes", "1..3", "--plot", folder / "s.svg"}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(text_of(folder / "s.svg"), HasSubstr("How often smaller the tree is"));
  EXPECT_EQ(program(with_scene(quick_scene, {"--plot", folder / "t.svg"})).exit_code, 2);
  EXPECT_EQ(program(with_scene(quick_scene, {"--sizes", "1..13"})).exit_code, 2);
  EXPECT_EQ(folder.files().size(), 1u);
}

TEST(CliScene, ShowsACaseAgain) {
  Outcome r = program(with_scene(quick_scene, {"--replay", "bake.tight", "--case", "4@t0:i17"}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("holds bake.tight level 4 case t0:i17"));
  for (const char* at : {"4@t0:i256", "5@t0:i1", "t0:i1", "4@", "4@t0:i1 "})
    EXPECT_EQ(program(with_scene(quick_scene, {"--replay", "bake.tight", "--case", at})).exit_code, 2) << at;
  EXPECT_EQ(program(with_scene(quick_scene, {"--replay", "no.law", "--case", "4@t0:i17"})).exit_code, 2);
}

TEST(CliScene, RunsAllOfASmallScene) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome r = program({"scene", "--quiet", "--level", "2", "--exhaustive"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("proved     bake.conservative"));
  EXPECT_THAT(r.out, HasSubstr("proved     bake.tight"));
}

TEST(CliScene, AMarginLeavesMoreUnknown) {
  const auto unknown = [](const std::string& margin) {
    const Outcome r = program(with_scene(quick_scene, {"--margin", margin, "--json", "-"}));
    EXPECT_EQ(r.exit_code, 0) << r.err;
    const json states = parsed_scene(r.out)["scene"]["bake"]["states"];
    return states["UT"].get<int>() + states["UO"].get<int>();
  };
  const int none = unknown("0"), sampler = unknown("sampler"), two = unknown("2");
  EXPECT_LE(none, sampler);
  EXPECT_LT(sampler, two);
}

TEST(CliScene, OfABadFileIsOneLineAnd4) {
  Folder folder;
  write_scene(folder / "bad.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"meshes\": 7}");
  const Outcome r =
      program({"scene", folder / "bad.gltf", "--json", folder / "r.json", "-o", folder / "o.glb"});
  EXPECT_EQ(r.exit_code, 4);
  EXPECT_THAT(r.err, HasSubstr("bad.gltf: "));
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  EXPECT_EQ(folder.files().size(), 1u);
  EXPECT_EQ(program({"scene", folder / "none.gltf"}).exit_code, 4);
  EXPECT_EQ(program({"scene", "--level", "13"}).exit_code, 2);
  EXPECT_EQ(program({"scene", "--margin", "nan"}).exit_code, 2);
  EXPECT_EQ(program({"scene", "--memory", "3"}).exit_code, 2);
}

TEST(CliScene, ABenchSaysHowFastItsTrianglesAreBaked) {
  Folder folder;
  const std::string glb = folder / "out.glb";
  ASSERT_EQ(program(with_scene(quick_scene, {"-o", glb})).exit_code, 0);
  const Outcome r = program({"bench", "bake", "--scene", glb, "--levels", "1..2", "--quiet", "--json", "-"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const json bench = parsed_scene(r.out);
  EXPECT_EQ(bench["triangles"], 42);
  ASSERT_EQ(bench["rows"].size(), 2u);
  for (const json& row : bench["rows"]) {
    EXPECT_EQ(row["micro_triangles"], 42 << 2 * row["level"].get<int>());
    EXPECT_GE(row["rounds"], 5);
    EXPECT_GT(row["fastest_ns"], 0);
    EXPECT_GE(row["ns"], row["fastest_ns"]);
    EXPECT_GT(row["centre_ns"], 0);
  }
  expect_complaint(program({"bench", "bake", "--scene", folder / "none.glb", "--quiet"}), 4, "none.glb");
  expect_complaint(program({"bench", "tree", "--scene", glb}), 2, "--scene: for bench bake");
  expect_complaint(program({"bench", "bake", "--scene", glb, "--levels", "2..13"}), 2, "highest level");
  write_scene(folder / "bare.gltf", "{\"asset\": {\"version\": \"2.0\"}}");
  expect_complaint(program({"bench", "bake", "--scene", folder / "bare.gltf", "--quiet"}), 2,
                   "nothing to bake");
}

TEST(CliScene, InTwoStatesIsJudgedAsThat) {
  const Outcome r = program(with_scene(quick_scene, {"--states", "2"}));
  EXPECT_EQ(r.exit_code, 0) << r.out;
  EXPECT_THAT(r.out, HasSubstr("bake.force2"));
  EXPECT_THAT(r.out, Not(HasSubstr("bake.conservative")));
}

TEST(CliScene, RefusesWhatCannotGoTogether) {
  Folder folder;
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--json", folder / "a", "-o", folder / "a"},
           {"--case", "4@t0:i17"},
           {"--replay", "bake.tight"},
           {"--replay", "bake.tight", "--case", "4@t0:i17", "-o", folder / "o.glb"},
           {"--memory", "-1"},
           {"--level-limit", "3"},
           {"--margin", "65"}})
    EXPECT_EQ(program(with_scene(quick_scene, arguments)).exit_code, 2) << arguments[0];
  EXPECT_TRUE(folder.files().empty());
}

TEST(CliScene, WithNothingToBakeIs0) {
  Folder folder;
  write_scene(folder / "empty.gltf", R"({"asset": {"version": "2.0"}})");
  const Outcome r = program({"scene", folder / "empty.gltf", "--json", folder / "r.json"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("nothing to bake"));
  const json all = parsed_scene(text_of(folder / "r.json"));
  ASSERT_EQ(all["results"].size(), 1u);
  EXPECT_EQ(all["results"][0]["verdict"], "not_applicable");
}

TEST(CliScene, InterruptedIs3AndLeavesNoFile) {
  Folder folder;
  Process process(
      program_with({"scene", "--level", "12", "-o", folder / "o.glb", "--json", folder / "r.json"}));
  ASSERT_TRUE(process.says("bake"));
  process.send(SIGINT);
  const Outcome r = process.wait();
  EXPECT_EQ(r.exit_code, 3) << r.err;
  EXPECT_TRUE(folder.files().empty());
}

// On a machine with the real scenes.
TEST(CliScene, RealScenesRunToAReport) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::filesystem::path scenes = MMVERIFY_SCENES;
  if (!std::filesystem::is_directory(scenes)) GTEST_SKIP() << "no scenes at " << scenes;
  // Those that take a second or less.
  for (const char* file : {"avocado/Avocado.gltf", "materials_variants_shoe/MaterialsVariantsShoe.gltf",
                           "flight_helmet/FlightHelmet_noleather.gltf", "scatter_grove/scatter_grove.gltf"}) {
    const Outcome r = program({"scene", scenes / file, "--quiet", "--level", "2", "--samples", "8"});
    EXPECT_EQ(r.exit_code, 0) << file << r.err;
  }
  for (const char* file :
       {"flight_helmet/FlightHelmet.gltf", "littlest_tokyo/LittlestTokyo_original_draco.glb"}) {
    const Outcome r = program({"scene", scenes / file});
    EXPECT_EQ(r.exit_code, 4) << file;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  }
}

}  // namespace
