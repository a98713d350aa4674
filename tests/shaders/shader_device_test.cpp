// [driver] Shaders on a Vulkan device, judged by the built program: ours are right, and what is wrong is refuted.  Skipped where no
// device is.  The validation layer listens: its first message ends a call, and so a law.
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string ours(const std::string& name) { return std::string(MMVERIFY_SHADER_SUBJECTS) + "/" + name; }

Outcome judge(const std::string& subject, const std::string& what, const std::string& more = "") {
  return shell("MMVERIFY_VULKAN_VALIDATION=1 mmverify prove " + what +
               " --details --quiet --no-mutants --subject " + subject + " " + more);
}

class ShaderOnDevice : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Outcome o = judge(ours("index.glsl"), "index.in_range --levels 0");
    if (o.exit_code == 2 && o.out.find("n/a") != std::string::npos) why_not_ = o.out;
    if (o.exit_code == 4) why_not_ = o.err;
  }
  void SetUp() override {
    if (!why_not_.empty()) GTEST_SKIP() << "no Vulkan device: " << why_not_;
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  Folder folder_;

 private:
  static inline std::string why_not_;
};

TEST_F(ShaderOnDevice, our_index_is_proved_and_says_where) {
  const std::string json = (folder_ / "out.json").string();
  const Outcome o = judge(ours("index.glsl"),
                          "index.equals_reference index.in_range index.bijective index.nested index.corners "
                          "index.inverse index.row_order index.row_corners --levels 0..5 --no-companions",
                          "--json " + json);
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_EQ(o.err, "");
  for (const char* law :
       {"equals_reference", "in_range", "bijective", "nested", "corners", "inverse", "row_corners"})
    EXPECT_THAT(o.out, HasSubstr(std::string("proved     index.") + law));
  for (const char* words : {": device: ", ": driver version: ", ": Vulkan: 1.", ": binary32 denormals: ",
                            ": validation layer: on", ": index_f32: SPIR-V 1.3, ", " sha256 "})
    EXPECT_THAT(o.out, HasSubstr(words));
  EXPECT_THAT(o.out, Not(HasSubstr("warning")));
  const Outcome schema = shell(std::string(MMVERIFY_SCRIPTS) + "/check-schema " + json);
  EXPECT_EQ(schema.exit_code, 0) << schema.out << schema.err;
  const std::string text = text_of(json);
  EXPECT_THAT(text, HasSubstr("\"runs_on\": ["));
  EXPECT_THAT(text, HasSubstr("\"driver version\": "));
}

TEST_F(ShaderOnDevice, our_index_is_exact_on_stiff_floats) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o =
      judge(ours("index.glsl"), "index.exact_on_floats index.row_exact_on_floats --levels 3..4");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("checked    index.exact_on_floats"));
  EXPECT_THAT(o.out, HasSubstr("checked    index.row_exact_on_floats"));
}

TEST_F(ShaderOnDevice, the_published_code_is_that_and_no_more) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome same = judge(ours("index_published.glsl"), "index.equals_published --levels 1");
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  // docs/ERRATA.md: fu + fv rounds up to 1.
  const Outcome exact = judge(ours("index_published.glsl"), "index.exact_on_floats --levels 1");
  expect_refuted_and_replayed(exact, "index.exact_on_floats");
  EXPECT_THAT(exact.out, HasSubstr("(0x1.fffffep-2,0x1p-26) expected 0 got 1"));
}

TEST_F(ShaderOnDevice, without_precise_is_warned_about) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge(ours("index_plain.glsl"), "index.in_range --levels 0..1");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("warning: "));
  EXPECT_THAT(o.out, HasSubstr("have no NoContraction (`precise`), in "));
}

TEST_F(ShaderOnDevice, a_wrong_snippet_is_refuted_with_its_simplest_case) {
  const std::string file = write("wrong.glsl", R"(#include "shaders/index.glsl"
uint index(uint level, float u, float v) {
  uint k = mm_index_exact(level, u, v);
  return level == 2u && u == 0.25 && v == 0.25 ? k ^ 1u : k;
}
)");
  const Outcome o = judge(file, "index.equals_reference --levels 0..3 --no-companions");
  expect_refuted_and_replayed(o, "index.equals_reference");
  EXPECT_THAT(o.out, HasSubstr("level 2 case v:u=1/4,v=1/4"));
}

TEST_F(ShaderOnDevice, that_leaves_an_answer_unwritten_is_broken) {
  const std::string file = write("unwritten.comp", R"(#version 450
layout(local_size_x = 32) in;
void main() {}
)");
  const Outcome o = judge(file, "index.in_range --levels 1");
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("left its output unwritten"));
}

TEST_F(ShaderOnDevice, that_hangs_costs_its_time_and_no_more) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  if (judge(ours("index.glsl"), "index.corners --levels 0").out.find("llvmpipe") != std::string::npos)
    GTEST_SKIP() << "llvmpipe leaves a loop after 2^16 turns";
  const std::string file = write("hang.glsl", R"(uint index(uint level, float u, float v) {
  uint k = mmverify_word(0);
  while (k != 77u) k = (k * 5u + 2u) & ~1u;
  return k;
}
)");
  const Outcome o = judge(file, "index.in_range --levels 1", "--timeout 1 --threads 1");
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("hung: no answer within 1 s"));
}

TEST_F(ShaderOnDevice, a_whole_shader_and_its_spirv_answer_alike) {
  const std::string file = write("whole.comp", R"(#version 450
#extension GL_GOOGLE_include_directive : require
layout(std430, set = 0, binding = 0) readonly buffer In { uint index[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Out { uint answer[]; };
layout(push_constant) uniform Asked { uint count, level, first, second, bytes; };
#include "shaders/index.glsl"
layout(local_size_x = 128) in;
void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  uvec2 a, b, c;
  mm_corners(mm_curve_face(index[k]), a, b, c);
  answer[6 * k] = a.x, answer[6 * k + 1] = a.y, answer[6 * k + 2] = b.x;
  answer[6 * k + 3] = b.y, answer[6 * k + 4] = c.x, answer[6 * k + 5] = c.y;
}
)");
  const std::string spirv = (folder_ / "whole.spv").string();
  const Outcome made = shell("glslangValidator -I" MMVERIFY_ROOT "/subjects -V --target-env vulkan1.1 -o " +
                             spirv + " " + file);
  ASSERT_EQ(made.exit_code, 0) << made.out << made.err;
  for (const std::string& subject : {file, spirv}) {
    const Outcome o = judge(subject, "index.corners --levels 0..4", "--entry corners");
    EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
    EXPECT_THAT(o.out, HasSubstr("proved     index.corners"));
    EXPECT_THAT(o.out, HasSubstr("workgroup 128"));
  }
}

TEST_F(ShaderOnDevice, hlsl_is_judged_by_way_of_glslang) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string file = write("index.hlsl", R"(uint apart(uint x) {
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}
uint index(uint level, float u, float v) {
  uint side = 1u << level, last = side - 1u;
  precise float x = saturate(u) * float(side), y = saturate(v) * float(side);
  uint iu = uint(x), iv = uint(y);
  precise float fu = x - float(iu), fv = y - float(iv);
  precise float rest = 1.0 - max(fu, fv);
  uint row = min(iu + iv + (min(fu, fv) >= rest ? 1u : 0u), last);
  iv = min(iv, last);
  iu = min(iu, last - iv);
  uint b0 = iu ^ row, t = (iu ^ iv) & b0, f = t;
  f ^= f >> 1; f ^= f >> 2; f ^= f >> 4; f ^= f >> 8;
  return apart(b0) | apart(((f ^ iu) & ~b0) | t) << 1;
}
)");
  const Outcome o = judge(file, "index.equals_reference --levels 0..4 --no-companions");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("proved     index.equals_reference"));
}

TEST_F(ShaderOnDevice, our_trees_give_the_maps_states) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome paper = judge(ours("tree.glsl"), "tree.lookup_is_decode tree.point_is_index --levels 0..1");
  EXPECT_EQ(paper.exit_code, 0) << paper.out << paper.err;
  EXPECT_THAT(paper.out, HasSubstr("proved     tree.lookup_is_decode"));
  const Outcome ranked =
      judge(ours("tree_ranked.glsl"), "tree.lookup_is_decode tree.round_trip --levels 0..1");
  EXPECT_EQ(ranked.exit_code, 0) << ranked.out << ranked.err;
  EXPECT_THAT(ranked.out, HasSubstr("proved     tree."));
}

TEST_F(ShaderOnDevice, our_graph_gives_the_states_of_a_scene) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome small = judge(ours("dag.glsl"), "dag.lookup_is_decode --levels 3");
  EXPECT_EQ(small.exit_code, 0) << small.out << small.err;
  EXPECT_THAT(small.out, HasSubstr("proved     dag.lookup_is_decode"));
  const Outcome fine = judge(ours("dag.glsl"), "dag.point_is_index dag.on_samples --levels 3..8");
  EXPECT_EQ(fine.exit_code, 0) << fine.out << fine.err;
  EXPECT_THAT(fine.out, HasSubstr("12 results: 12 checked"));
}

TEST_F(ShaderOnDevice, a_graph_whose_wide_nodes_are_read_as_narrow_ones_is_refuted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string file = write("narrow.glsl", R"(#define MM_DAG_WORD(k) mmverify_word(k)
#include "shaders/dag.glsl"
uint dag_lookup(uint format, uint map, uint index) {
  MmDag dag = mm_dag_open();
  uint at = mm_dag_header + 2u * map, record = MM_DAG_WORD(at);
  if ((record >> 8 & 0xffu) != 3u) return mm_dag_lookup(dag, map, index);
  return mm_dag_below(dag, MM_DAG_WORD(at + 1u) & ~1u, record & 0xffu, index);
}
)");
  const Outcome o = judge(file, "dag.on_samples --levels 6");
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("refuted    dag.on_samples"));
}

TEST_F(ShaderOnDevice, our_attribute_lookups_keep_their_laws) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge(ours("attribute.glsl"),
                          "attribute.order_bijective attribute.order_inverse attribute.face_orders "
                          "attribute.triangle_vertices attribute.bird_prefix attribute.holds_point "
                          "attribute.weights_on_floats attribute.decimation_watertight --levels 0..3");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  for (const char* law : {"order_bijective", "order_inverse", "face_orders", "triangle_vertices",
                          "bird_prefix", "decimation_watertight"})
    EXPECT_THAT(o.out, HasSubstr(std::string("proved     attribute.") + law));
}

/// Minutes of processor time on lavapipe: `./run test --every` runs these.
#define LONG_TIER()                             \
  if (getenv("MMVERIFY_LONG_TESTS") == nullptr) \
  GTEST_SKIP() << "takes long; MMVERIFY_LONG_TESTS=1, and ./run test --every, runs it"

TEST_F(ShaderOnDevice, our_attribute_lookups_keep_their_laws_up_to_level_8) {
  LONG_TIER();
  const Outcome o = judge(
      ours("attribute.glsl"),
      "attribute.order_bijective attribute.order_inverse attribute.face_orders attribute.triangle_vertices "
      "attribute.bird_prefix attribute.order_is_walk attribute.order_prefix_nested "
      "attribute.umajor_is_reversed_rows attribute.decimation_watertight --levels 5..8 --no-companions");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("36 results: 36 proved"));
}

TEST_F(ShaderOnDevice, our_trees_give_the_states_of_finer_maps) {
  LONG_TIER();
  const Outcome ranked = judge(ours("tree_ranked.glsl"), "tree.on_samples --levels 3..9");
  EXPECT_EQ(ranked.exit_code, 0) << ranked.out << ranked.err;
  EXPECT_THAT(ranked.out, HasSubstr("7 results: 7 checked"));
  const Outcome paper = judge(ours("tree.glsl"), "tree.on_samples --levels 3..6 --no-companions");
  EXPECT_EQ(paper.exit_code, 0) << paper.out << paper.err;
  EXPECT_THAT(paper.out, HasSubstr("4 results: 4 checked"));
}

TEST_F(ShaderOnDevice, our_decision_is_that_of_the_apis) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge(ours("traverse.glsl"), "traverse.decision traverse.blend_duplicates");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("proved     traverse.decision"));
  EXPECT_THAT(o.out, HasSubstr("proved     traverse.blend_duplicates"));
}

TEST_F(ShaderOnDevice, hits_that_blend_as_they_are_met_are_refuted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string file = write("met.glsl", R"(#include "shaders/traverse.glsl"
uint blend_hits(uint operation, uint payload, uint count) {
  float closest = 1e9;
  for (uint k = 0u; k < count; ++k) {
    float t = uintBitsToFloat(mmverify_word(3u * k));
    if (t >= closest) continue;
    if (mmverify_word(3u * k + 1u) != 0u) closest = t;
    else payload = mm_blend(operation, payload, mmverify_word(3u * k + 2u));
  }
  return payload;
}
)");
  const Outcome o = shell(
      "MMVERIFY_VULKAN_VALIDATION=1 mmverify replay traverse.blend_before_closest --level 0 --case "
      "max,B2A1,once,rising,neutral --subject " +
      file);
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("expected 0 0 0 0 got 70 71 72 73"));
}

TEST_F(ShaderOnDevice, of_no_such_number_is_not_applicable) {
  const Outcome o = judge(ours("index.glsl"), "index.in_range --levels 0", "--device 99");
  EXPECT_EQ(o.exit_code, 2) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("no Vulkan device 99: there "));
}

TEST_F(ShaderOnDevice, a_second_device_judges_as_well) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge(ours("index.glsl"), "index.equals_reference --levels 0..3", "--device 1");
  if (o.out.find("no Vulkan device 1") != std::string::npos) GTEST_SKIP() << "one device alone";
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("index.glsl@1: device: "));
}

TEST_F(ShaderOnDevice, two_devices_are_judged_in_one_run) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o =
      judge(ours("index.glsl"), "index.equals_reference --levels 3 --no-companions", "--device 0,1,0");
  if (o.out.find("no Vulkan device 1") != std::string::npos) GTEST_SKIP() << "one device alone";
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("index.glsl: device: "));
  EXPECT_THAT(o.out, HasSubstr("index.glsl@1: device: "));
  EXPECT_THAT(o.out, HasSubstr("2 results: 2 proved"));
}

}  // namespace
}  // namespace mmverify::tests
