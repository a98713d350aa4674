#include "gate/rules.hpp"

#include <array>
#include <string_view>

namespace mmverify::gate {
namespace {

struct Line {
  std::string_view schema, place;
  Rule rule;
};

constexpr std::string_view result = "mmverify.result/1", index = "mmverify.bench/1 index",
                           tree = "mmverify.bench/1 tree", vq = "mmverify.bench/1 vq",
                           bake = "mmverify.bench/1 bake", sweep = "mmverify.bench/1 sweep",
                           subject = "mmverify.bench/1 subject", scene = "mmverify.bench/1 scene";

// The first line that fits counts; no schema: every one.
// A line each, which the formatter would not keep.
// clang-format off
constexpr std::array lines{
    Line{"", "schema", Rule::left_out},
    Line{"", "topic", Rule::left_out},
    Line{"", "tool.seed", Rule::setting},
    Line{"", "tool.samples", Rule::setting},
    Line{"", "tool.rounds", Rule::setting},
    Line{"", "tool.maps", Rule::setting},
    Line{"", "tool.*", Rule::left_out},  // what made it, and on what

    Line{result, "results[].law", Rule::key},
    Line{result, "results[].subject", Rule::key},
    Line{result, "results[].level", Rule::key},
    Line{result, "results[].method", Rule::same},
    Line{result, "results[].domain", Rule::same},
    Line{result, "results[].verdict", Rule::verdict},
    Line{result, "results[].cases_expected", Rule::more},
    Line{result, "results[].cases_run", Rule::more},
    Line{result, "results[].mismatches", Rule::less},
    Line{result, "results[].by_kind.*.cases", Rule::more},
    Line{result, "results[].by_kind.*.mismatches", Rule::less},
    Line{result, "results[].by_kind.*.declined", Rule::less},
    // Which of several counterexamples is found, and the digest of answers that were allowed to be what they
    // are, may change with any edit.  Whether there is one is in `mismatches`: contradictions.hpp sees to it.
    Line{result, "results[].counterexample", Rule::left_out},
    Line{result, "results[].more_counterexamples", Rule::left_out},
    Line{result, "results[].digest", Rule::left_out},
    Line{result, "results[].topic", Rule::left_out},
    Line{result, "results[].reason", Rule::left_out},
    Line{result, "results[].seconds", Rule::left_out},
    Line{result, "results[].cases_resumed", Rule::left_out},
    Line{result, "mutants[].law", Rule::key},
    Line{result, "mutants[].mutant", Rule::key},
    Line{result, "mutants[].killed", Rule::yes},
    Line{result, "mutants[].level", Rule::left_out},
    Line{result, "mutants[].case", Rule::left_out},
    Line{result, "diagnoses", Rule::left_out},

    Line{result, "scene.file", Rule::left_out},
    Line{result, "scene.plan.surfaces[].factor", Rule::about},
    Line{result, "scene.plan.surfaces[].cutoff", Rule::about},
    Line{result, "scene.plan.surfaces[].*", Rule::same},
    Line{result, "scene.plan.left_out[].*", Rule::same},
    Line{result, "scene.plan.left_out_laws[].*", Rule::same},
    Line{result, "scene.plan.*", Rule::same},
    Line{result, "scene.bake.states.T", Rule::more},
    Line{result, "scene.bake.states.O", Rule::more},
    Line{result, "scene.bake.states.*", Rule::less},
    Line{result, "scene.bake.triangles_by_level.*", Rule::same},
    Line{result, "scene.bake.micro_triangles", Rule::same},
    Line{result, "scene.bake.leaves", Rule::less},
    Line{result, "scene.bake.exact", Rule::less},
    Line{result, "scene.bake.lowered", Rule::less},
    Line{result, "scene.bake.load_seconds", Rule::left_out},
    Line{result, "scene.bake.bake_seconds", Rule::left_out},
    Line{result, "scene.saved.area", Rule::about},
    Line{result, "scene.saved.unknown", Rule::about_less},
    Line{result, "scene.saved.*", Rule::about_more},
    Line{result, "scene.footprint.modes[].states", Rule::key},
    Line{result, "scene.footprint.modes[].*", Rule::less},
    Line{result, "scene.footprint.special_indices", Rule::more},
    Line{result, "scene.footprint.vertex_data_bytes", Rule::same},
    Line{result, "scene.footprint.texture_bytes", Rule::same},
    Line{result, "scene.footprint.*", Rule::less},
    Line{result, "scene.pairs.unpaired", Rule::less},
    Line{result, "scene.pairs.*", Rule::same},
    Line{result, "scene.vq*.maps", Rule::same},
    Line{result, "scene.vq*.regions", Rule::same},
    Line{result, "scene.vq*.uniform", Rule::more},
    Line{result, "scene.vq*.bytes", Rule::less},
    Line{result, "scene.vq*.unknown", Rule::less},
    Line{result, "scene.vq*.substitutions", Rule::less},
    Line{result, "scene.sizes[].level", Rule::key},
    Line{result, "scene.sizes[].saved.area", Rule::about},
    Line{result, "scene.sizes[].saved.unknown", Rule::about_less},
    Line{result, "scene.sizes[].saved.*", Rule::about_more},
    Line{result, "scene.sizes[].footprint.modes[].states", Rule::key},
    Line{result, "scene.sizes[].footprint.modes[].*", Rule::less},
    Line{result, "scene.sizes[].footprint.special_indices", Rule::more},
    Line{result, "scene.sizes[].footprint.vertex_data_bytes", Rule::same},
    Line{result, "scene.sizes[].footprint.texture_bytes", Rule::same},
    Line{result, "scene.sizes[].footprint.*", Rule::less},

    Line{index, "rows[].subject", Rule::key},
    Line{index, "rows[].level", Rule::key},
    Line{index, "rows[].ratio_to_reference_f32", Rule::speed_less},
    Line{index, "rows[].ns_per_index", Rule::left_out},
    Line{index, "subjects[].subject", Rule::key},
    Line{index, "subjects[].errors[].level", Rule::key},
    Line{index, "subjects[].errors[].inputs", Rule::key},
    Line{index, "subjects[].errors[].samples", Rule::same},
    Line{index, "subjects[].errors[].mismatches", Rule::less},
    Line{index, "subjects[].errors[].off_grid", Rule::less},
    Line{index, "subjects[].errors[].by_kind.*", Rule::less},
    Line{index, "subjects[].errors[].worst_heights", Rule::about_less},
    Line{index, "subjects[].errors[].worst_ulp", Rule::about_less},
    Line{index, "subjects[].growth", Rule::left_out},  // fitted to the errors above
    Line{index, "subjects[].*", Rule::same},

    Line{tree, "rows[].states", Rule::key},
    Line{tree, "rows[].level", Rule::key},
    Line{tree, "rows[].maps", Rule::same},
    Line{tree, "rows[].nodes", Rule::same},
    Line{tree, "rows[].paper_bits_read", Rule::about_less},
    Line{tree, "rows[].forms[].form", Rule::key},
    Line{tree, "rows[].forms[].bits_per_micro_triangle", Rule::about_less},
    Line{tree, "rows[].forms[].cache_lines", Rule::about_less},
    Line{tree, "rows[].forms[].ns_per_lookup", Rule::left_out},
    Line{tree, "rows[].forms[].ns_per_chained_lookup", Rule::left_out},
    Line{tree, "rows[].memory_ours_to_paper", Rule::about_less},
    Line{tree, "rows[].ratio_ours_to_flat", Rule::speed_less},
    Line{tree, "rows[].ratio_paper_to_ours", Rule::speed_more},
    Line{tree, "rows[].ratio_sdsl_to_ours", Rule::speed_more},
    Line{tree, "rows[].ratio_encode_obvious_to_ours", Rule::speed_more},
    Line{tree, "rows[].ratio_decode_obvious_to_ours", Rule::speed_more},
    Line{tree, "rows[].encode_ns", Rule::left_out},
    Line{tree, "rows[].decode_ns", Rule::left_out},

    Line{vq, "left_out[]", Rule::same},
    Line{vq, "left_out", Rule::same},
    Line{vq, "decode.*.ratio_regions_to_map", Rule::speed_more},
    Line{vq, "decode.*.*_ns", Rule::left_out},
    Line{vq, "rows[].map", Rule::key},
    Line{vq, "rows[].savings.*", Rule::about_more},
    Line{vq, "rows[].*[].encoder", Rule::key},
    Line{vq, "rows[].*[].substitutions", Rule::less},
    Line{vq, "rows[].*[].savings", Rule::about_more},
    Line{vq, "rows[].*[].transforms[]", Rule::same},
    Line{vq, "rows[].*[].ms", Rule::left_out},
    Line{vq, "rows[].*[].times_paper", Rule::speed_less},
    Line{vq, "rows[].vq2_bound", Rule::same},
    Line{vq, "rows[].vq4_bound", Rule::more},  // no block needs fewer: what is proved
    Line{vq, "rows[].*", Rule::same},

    Line{bake, "textures", Rule::setting},
    Line{bake, "compared", Rule::same},
    Line{bake, "rows[].level", Rule::key},
    Line{bake, "rows[].unknown", Rule::less},
    Line{bake, "rows[].exact", Rule::less},
    Line{bake, "rows[].bakers[].baker", Rule::key},
    Line{bake, "rows[].bakers[].states", Rule::same},
    Line{bake, "rows[].bakers[].wrong", Rule::less},
    Line{bake, "rows[].bakers[].needless", Rule::less},
    Line{bake, "rows[].bakers[].times_ours", Rule::speed_more},
    Line{bake, "rows[].bakers[].*_per_million", Rule::left_out},  // of the counts above
    Line{bake, "rows[].bakers[].ns", Rule::left_out},
    Line{bake, "sizes[].texels", Rule::key},
    Line{bake, "sizes[].ns", Rule::left_out},
    Line{bake, "sizes[].binary64_ns", Rule::left_out},
    Line{bake, "sizes[].ready_ms", Rule::left_out},
    Line{bake, "margins[].texels", Rule::key},
    Line{bake, "margins[].unknown", Rule::less},
    Line{bake, "margins[].ns", Rule::left_out},

    Line{sweep, "threads", Rule::setting},
    Line{sweep, "levels[].level", Rule::key},
    Line{sweep, "levels[].cells", Rule::same},
    Line{sweep, "levels[].*.ratio", Rule::speed_more},
    Line{sweep, "levels[].*.seconds", Rule::left_out},
    Line{sweep, "levels[].*.per_second", Rule::left_out},
    Line{sweep, "levels[].plain_per_second", Rule::left_out},
    Line{sweep, "levels[].peak_megabytes", Rule::left_out},

    Line{subject, "level", Rule::setting},
    Line{subject, "verdict", Rule::verdict},
    Line{subject, "isolated_ratio", Rule::speed_less},
    Line{subject, "judged_ratio", Rule::speed_less},
    Line{subject, "*", Rule::left_out},  // whose file it is, and times

    Line{scene, "triangles", Rule::same},
    Line{scene, "rows[].level", Rule::key},
    Line{scene, "rows[].micro_triangles", Rule::same},
    Line{scene, "rows[].ratio_centre_to_ours", Rule::speed_more},
    Line{scene, "rows[].*", Rule::left_out},  // times
    Line{scene, "*", Rule::left_out},         // its file, a time
};
// clang-format on

/// Whether the place is the pattern's, whose "*" is any run of characters of a name.
constexpr bool fits(std::string_view pattern, std::string_view place) {
  while (!pattern.empty()) {
    if (pattern.front() == '*') {
      for (std::size_t n = 0;; ++n) {
        if (n != 0 && fits(pattern.substr(1), place.substr(n))) return true;
        if (n == place.size() || place[n] == '.' || place[n] == '[') return false;
      }
    }
    if (place.empty() || pattern.front() != place.front()) return false;
    pattern.remove_prefix(1);
    place.remove_prefix(1);
  }
  return place.empty();
}

}  // namespace

std::optional<int> rank_of_verdict(const std::string& verdict) {
  constexpr std::array<std::string_view, 6> from_worst{"refuted",        "broken",  "incomplete",
                                                       "not_applicable", "checked", "proved"};
  for (std::size_t k = 0; k < from_worst.size(); ++k)
    if (from_worst[k] == verdict) return static_cast<int>(k);
  return std::nullopt;
}

std::optional<Rule> rule_of(const std::string& schema, const std::string& place) {
  for (const Line& line : lines)
    if ((line.schema.empty() || line.schema == schema) && fits(line.place, place)) return line.rule;
  return std::nullopt;
}

}  // namespace mmverify::gate
