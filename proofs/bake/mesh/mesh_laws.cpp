// Laws of bakers of whole meshes: each triangle's map by way of its index, and the array around the maps.
#include "proofs/bake/laws.hpp"
#include "proofs/bake/mesh/mesh_judges.hpp"
#include "proofs/bake/mesh/mesh_mutants.hpp"
#include "proofs/bake/mesh/mesh_samples.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr char maps_source[] =
    "VK_KHR_opacity_micromap, opacity states; VkAccelerationStructureTrianglesOpacityMicromapKHR; "
    "spec/bake/state.hpp";
constexpr char mesh_source[] = "VkMicromapTriangleKHR, VkMicromapUsageKHR; mmverify_subject.h, bake_mesh";

std::uint64_t mesh_count(Level n, const Run& run) {
  constexpr std::uint64_t lowest = 4;  // among so many levels the cases asked for are spread
  const std::uint64_t of_tier = run.tier == Tier::fast ? 100 : n < 6 ? 4'000 : 1'000;
  return n < lowest ? std::max(of_tier, (run.cases + lowest - 1) / lowest) : of_tier;
}

std::optional<std::string> bakes_no_meshes(const BakeSubject& s, Level n) {
  if (!s.functions.bake_mesh) return s.name() + " has no entry point bake_mesh";
  if (n > s.functions.support.max_level)
    return fmt::format("it declares levels up to {}", s.functions.support.max_level);
  if (!s.functions.support.four_state) return "it declares no maps in 4-state";
  return std::nullopt;
}

/// Nothing says which texel a rounded coordinate samples.
std::optional<std::string> samples_unknown_texels(const BakeSubject& s) {
  const Support& support = s.functions.support;
  if (support.coordinate_bits == 0 || support.filters.has(Filter::bilinear)) return std::nullopt;
  return "it declares nearest filtering of rounded coordinates alone: which texel it samples is not said";
}

/// A law on meshes, of both formats or of 4-state alone.
Law on_meshes(Law law, MeshCheck check, bool any_format, const UnfitOf<BakeSubject>& lacks = {},
              Denies drawn = nullptr) {
  law.method = Method::sample;
  law.subjects = {"bake"};
  law.tiers = {.fast = {0, 4}, .long_run = {0, 6}, .seconds = 0.5};
  law.domain = mesh_samples_text();
  law.unfit =
      unless_of_topic<BakeSubject>([lacks](const BakeSubject& s, Level n) -> std::optional<std::string> {
        if (auto why = bakes_no_meshes(s, n)) return why;
        return lacks ? lacks(s, n) : std::nullopt;
      });
  DrawnCasesOf<BakeSubject, MeshCase> cases;
  cases.count = mesh_count;
  cases.number = [any_format](Level n, std::uint64_t k, std::uint64_t seed) {
    return mesh_sample(seed, n, k, any_format);
  };
  cases.text = [](Level, const MeshCase& mesh) { return text_of(mesh); };
  cases.read = [](Level n, const std::string& at) { return mesh_from(at, n); };
  cases.check = [check](const BakeSubject& s, Level, const MeshCase& mesh) { return check(s, mesh); };
  cases.chunk = 4;
  cases.fit = [](const BakeSubject& s, const MeshCase& mesh) {
    return fitted(s.functions.support, mesh, mesh.vertices.size());
  };
  if (drawn != nullptr)
    cases.draw = [drawn](const BakeSubject& s, Level, const MeshCase& mesh) {
      return drawn_mesh(s, mesh, drawn);
    };
  return on_drawn_cases(std::move(law), std::move(cases));
}

}  // namespace

std::vector<Law> mesh_laws() {
  return {
      on_meshes(
          {.id = "bake.mesh_conservative",
           .says = "the map that a triangle's index leads to is O or T only where alpha is on all of that "
                   "triangle's own micro-triangle; a special index, on all of the triangle",
           .source = maps_source,
           .mutants = conservative_mesh_mutants()},
          mesh_is_conservative, false, [](const BakeSubject& s, Level) { return samples_unknown_texels(s); },
          not_conservative),
      on_meshes(
          {.id = "bake.mesh_tight",
           .says = "a triangle's micro-triangle is unknown only where it must be, shared map or not",
           .source = maps_source,
           .mutants = tight_mesh_mutants()},
          mesh_is_tight, false,
          [](const BakeSubject& s, Level) -> std::optional<std::string> {
            if (!s.functions.tight) return s.name() + " does not promise that maps are tight";
            return samples_unknown_texels(s);
          },
          not_tight),
      on_meshes(
          {.id = "bake.mesh_alone",
           .says = "a triangle has the states that it has in a mesh of itself alone, but for the side of "
                   "unknown ones",
           .source = "mmverify_subject.h, bake_mesh: maps are shared only where they are right for each",
           .mutants = shared_mesh_mutants()},
          mesh_is_as_alone, false),
      on_meshes({.id = "bake.mesh_force2",
                 .says = "a mesh in 2-state leads to force-2-state of what it leads to in 4-state",
                 .source = "VK_KHR_opacity_micromap, force-2-state; spec/micromap/micromap.hpp",
                 .mutants = two_state_mesh_mutants()},
                mesh_in_both_formats, false,
                [](const BakeSubject& s, Level) -> std::optional<std::string> {
                  if (s.functions.support.two_state) return std::nullopt;
                  return "it declares no maps in 2-state";
                }),
      on_meshes({.id = "bake.mesh_records",
                 .says = "each index leads to a record or is special; a record has the level and the format "
                         "that are asked for, its bytes in the data, zeros behind its states, and no other "
                         "record's bytes",
                 .source = mesh_source,
                 .mutants = record_mesh_mutants()},
                mesh_has_records, true),
      on_meshes(
          {.id = "bake.mesh_counts",
           .says = "the array's usage counts are its records', the geometry's, where the API has any, its "
                   "references'",
           .source = mesh_source,
           .mutants = count_mesh_mutants()},
          mesh_has_counts, true),
  };
}

}  // namespace mmverify::proofs::bake
