// [release alone, driver] mmverify bench shaders on a Vulkan device, as the built program runs it on few hits: each kernel has its
// rows, its answers are compared, and one wrong answer is an error. Skipped where no device is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/command.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;

/// Level 4 and 2^12 hits: seconds on lavapipe.
Outcome bench(const std::string& program, const std::string& json, const std::string& settings = "") {
  return shell(settings + " MMVERIFY_VULKAN_VALIDATION=1 " + program +
               " bench shaders --levels 4 --hits 5000 --quiet --json " + json);
}

class ShaderBench : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome o = shell(std::string(MMVERIFY_PROGRAM) +
                            " prove index.in_range --levels 0 --quiet --no-mutants --subject " MMVERIFY_ROOT
                            "/subjects/shaders/subjects/index.glsl");
    if (o.exit_code != 0) GTEST_SKIP() << "no Vulkan device: " << o.out << o.err;
  }
  /// The program with shaders of its own beside it, of which `text` in `file` is replaced by `by`.
  std::string program_with(const std::string& file, const std::string& text, const std::string& by) const {
    fs::create_directories(folder_ / "bin");
    fs::create_directories(folder_ / "share/mmverify");
    fs::copy(MMVERIFY_ROOT "/subjects/shaders", folder_ / "share/mmverify/shaders",
             fs::copy_options::recursive);
    fs::copy_file(MMVERIFY_PROGRAM, folder_ / "bin/mmverify");
    const fs::path changed = folder_ / "share/mmverify/shaders" / file;
    std::string source = text_of(changed);
    const auto at = source.find(text);
    EXPECT_NE(at, std::string::npos) << changed << " has no " << text;
    if (at != std::string::npos) std::ofstream(changed) << source.replace(at, text.size(), by);
    return "MMVERIFY_SHADER_LIBRARY=" + fs::path(MMVERIFY_PROGRAM).parent_path().string() +
           "/mmverify-shaders.so " + (folder_ / "bin/mmverify").string();
  }
  Folder folder_;
  const std::string json_ = (folder_ / "out.json").string();
};

TEST_F(ShaderBench, times_each_kernel_in_both_orders_beside_a_copy_of_the_same_bytes) {
  const Outcome o = bench(MMVERIFY_PROGRAM, json_);
  ASSERT_EQ(o.exit_code, 0) << o.out << o.err;
  const Outcome schema = shell(std::string(MMVERIFY_SCRIPTS) + "/check-schema " + json_);
  EXPECT_EQ(schema.exit_code, 0) << schema.out << schema.err;
  const auto result = nlohmann::json::parse(text_of(json_));
  EXPECT_EQ(result["tool"]["hits"], 4096);  // 5000, rounded down to a power of two
  EXPECT_EQ(o.out.find("no GPU here: ") != std::string::npos, result["kind"] == "processor") << o.out;
  EXPECT_THAT(o.out, HasSubstr("of copy"));
  std::map<std::string, int> coherent, shuffled;
  int copies = 0;
  for (const auto& row : result["rows"]) {
    EXPECT_GT(row["lookups_per_second"], 0) << row;
    EXPECT_EQ(row["hits"], 4096) << row;
    const std::string kernel = row["kernel"];
    if (kernel == "vkCmdCopyBuffer") continue;
    EXPECT_EQ(row["checked"], 4096) << row;
    if (!row.contains("order")) {
      ++copies;
      continue;
    }
    ++(row["order"] == "coherent" ? coherent : shuffled)[kernel];
    // Both are of as many hits, so the share is the quotient of the rates.
    double copied = 0;
    for (const auto& copy : result["rows"])
      if (copy["kernel"] == "copy kernel" && copy["bytes_in"] == row["bytes_in"] &&
          copy["bytes_out"] == row["bytes_out"])
        copied = copy["bytes_per_second"];
    EXPECT_DOUBLE_EQ(row["share_of_copy"].get<double>(), row["bytes_per_second"].get<double>() / copied)
        << row;
  }
  EXPECT_EQ(copies, 4);
  EXPECT_EQ(coherent, shuffled);
  for (const char* kernel :
       {"index, exact", "index, rows", "flat map", "tree, ranked", "tree, bit by bit", "graph", "VQ2", "VQ4",
        "triplet, W-minor", "triplet, U-major", "triplet, Bird", "weights"})
    EXPECT_GE(coherent[kernel], 1) << kernel;
}

TEST_F(ShaderBench, a_kernel_with_one_wrong_answer_is_an_error_and_leaves_no_file) {
  const std::string program =
      program_with("subjects/tree_ranked.glsl", "return mm_ranked_lookup(index);",
                   "return index == 77u ? 3u - mm_ranked_lookup(index) : mm_ranked_lookup(index);");
  const Outcome o = bench(program, json_);
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.err,
              HasSubstr("tree, ranked at level 4: hit 1232 of 4096, inputs 0x4d: the device answers "));
  EXPECT_EQ(o.out, "");
  EXPECT_FALSE(fs::exists(json_));
}

TEST_F(ShaderBench, hits_that_are_not_shuffled_are_an_error) {
  const Outcome o =
      bench(program_with("kernels/inputs.glsl", "if (shuffled == 0u) return k;", "return k;"), json_);
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.err, HasSubstr("index, exact at level 4: hit "));
  EXPECT_THAT(o.err, HasSubstr("the device made inputs "));
}

TEST_F(ShaderBench, a_map_of_other_states_is_an_error) {
  const Outcome o =
      bench(program_with("kernels/inputs.glsl", "words[k] = hashed(k);", "words[k] = 0u;"), json_);
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.err, HasSubstr("flat map at level 4: hit "));
}

TEST_F(ShaderBench, without_a_driver_or_a_device_says_so) {
  const Outcome none = bench(MMVERIFY_PROGRAM, json_, "VK_ICD_FILENAMES=/no/such/driver.json");
  EXPECT_EQ(none.exit_code, 4) << none.out << none.err;
  EXPECT_THAT(none.err, HasSubstr("bench shaders: no Vulkan d"));
  EXPECT_FALSE(fs::exists(json_));
  const Outcome far = shell(std::string(MMVERIFY_PROGRAM) + " bench shaders --quiet --device 99");
  EXPECT_EQ(far.exit_code, 4) << far.out << far.err;
  EXPECT_THAT(far.err, HasSubstr("bench shaders: no Vulkan device 99: there "));
}

}  // namespace
}  // namespace mmverify::tests
