// [release alone, night] Shared libraries that bake whole meshes: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace mesh_plugin_test {

Outcome judge_mesh(const std::string& name, const std::string& what) { return judged(name, what); }

constexpr char every_law[] =
    "bake.mesh_conservative bake.mesh_tight bake.mesh_alone bake.mesh_force2 bake.mesh_records "
    "bake.mesh_counts "
    "--levels 0..3";

// Its triangles' maps are the example baker's, which is far from tight.
TEST(MeshSubject, the_example_in_c_keeps_the_laws) {
  expect_said(judge_mesh("mesh_example",
                         "bake.mesh_conservative bake.mesh_alone bake.mesh_force2 bake.mesh_records "
                         "bake.mesh_counts --levels 0..3"),
              0, each_of("checked    bake.mesh_", {"conservative", "alone", "force2", "records", "counts"}),
              {"declined"});
}

// This library's baker of one triangle behind the example's meshes.  It has no entry point for triangles itself.
TEST(MeshSubject, of_a_tight_baker_is_tight) {
  expect_said(
      judge_mesh("mesh_nothing", every_law), 0,
      each_of("checked    bake.mesh_", {"conservative", "tight", "alone", "force2", "records", "counts"}));
}

TEST(WrongMeshes, are_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string shared = ", which triangle 0 has, too: micro-triangle ";
  expect_each_refuted(
      judge_mesh,
      {{"mesh_shares_by_quarters", "bake.mesh_conservative --levels 3..4", shared},
       {"mesh_shares_by_quarters", "bake.mesh_alone --levels 3..4", " as in a mesh of itself alone got "},
       {"mesh_shares_turned", "bake.mesh_conservative --levels 1..3", shared},
       {"mesh_shares_rewound", "bake.mesh_conservative --levels 1..3", shared},
       {"mesh_special_of_unbaked", "bake.mesh_conservative --levels 0..2", "), special T: micro-triangle 0 ",
        " got T"},
       {"mesh_overlaps", "bake.mesh_records --levels 2", "expected record 1 apart from record 0, bytes "},
       {"mesh_pads_with_ones", "bake.mesh_records --levels 0..2",
        "expected record 0: zeros after the last state got others"},
       {"mesh_takes_one_level", "bake.mesh_records --levels 1..2", "expected triangle ",
        ": level 0 got level "},
       {"mesh_chooses_levels_untold", "bake.mesh_records --levels 1..2", "expected triangle ", ": level "},
       {"mesh_counts_triangles", "bake.mesh_counts --levels 0..2", " of level "}});
}

TEST(MeshSubject, may_choose_lower_levels_if_it_says_so) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_mesh("mesh_chooses_levels", every_law), 0,
              each_of("checked    bake.mesh_", {"conservative", "tight", "alone", "records", "counts"}));
}

TEST(MeshSubject, what_it_declines_is_counted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_mesh("mesh_declines_levels", "bake.mesh_conservative --levels 0..2"), 0,
              {"checked    bake.mesh_conservative", "declined: "});
}

TEST(BrokenMeshes, are_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(judge_mesh, " --levels 1", "baking the mesh texels=",
                     {{"mesh_crash", "bake.mesh_counts", "crashed (signal "},
                      {"mesh_throws", "bake.mesh_counts", "threw an exception: no second triangle"},
                      {"mesh_reads_past", "bake.mesh_counts", "read past"},
                      {"mesh_overrun", "bake.mesh_counts", "it touched memory outside its output"},
                      {"mesh_counts_calls", "bake.mesh_counts", "non-deterministic"}});
}

TEST(MeshSubject, alone_is_asked_for_meshes_and_a_baker_of_both_for_triangles_too) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  // A law that was named is not judged.
  expect_said(judge_mesh("mesh_nothing", "bake.conservative bake.mesh_counts --levels 0"), 2,
              {"n/a        bake.conservative", "checked    bake.mesh_counts"});
  expect_said(judge_mesh("mesh_bakes_triangles_too", "bake.conservative bake.mesh_counts --levels 0"), 0,
              {"proved     bake.conservative", "checked    bake.mesh_counts"});
}

TEST(MeshSubject, built_before_there_were_meshes_it_has_none) {
  expect_said(judge_mesh("mesh_old_header", "bake.mesh_counts --levels 0"), 2,
              {"n/a        bake.mesh_counts"}, {"checked"});
}

}  // namespace mesh_plugin_test
}  // namespace mmverify::tests
