#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/output/json_text.hpp"
#include "cli/scene/scene.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using Json = nlohmann::ordered_json;

Json to_json(const Footprint& f) {
  Json j{{"micromaps", f.records},
         {"special_indices", f.special},
         {"record_bytes", f.record_bytes},
         {"index_bytes", f.index_bytes},
         {"array_data_bytes", f.array_data},
         {"texture_bytes", f.texture},
         {"vertex_data_bytes", f.vertex_data},
         {"modes", Json::array()}};
  for (std::size_t mode = 0; mode < 2; ++mode)
    j["modes"].push_back({{"states", mode == 0 ? 2 : 4},
                          {"micromaps", f.mode[mode].records},
                          {"data_bytes", f.mode[mode].data},
                          {"tree_bytes", f.mode[mode].tree},
                          {"random_access_tree_bytes", f.mode[mode].our_tree},
                          {"graph_bytes", f.mode[mode].graph},
                          {"bitmask_bytes", f.mode[mode].bitmask}});
  return j;
}

Json to_json(const AnyHitShares& s) {
  return {{"area", s.area}, {"transparent", s.transparent}, {"opaque", s.opaque}, {"unknown", s.unknown}};
}

Json to_json(const VqFootprint& v) {
  return {{"maps", v.maps},       {"uniform", v.uniform}, {"bytes", v.bytes},
          {"regions", v.regions}, {"unknown", v.unknown}, {"substitutions", v.substitutions}};
}

Json to_json(const SubjectFigures& f) {
  const auto& t = f.totals;
  return {{"name", f.name},
          {"triangles", t.triangles},
          {"outside", t.outside},
          {"declined", t.declined},
          {"micro_triangles", t.micro_triangles},
          {"wrong_known", t.wrong_known},
          {"needless_unknown", t.needless_unknown},
          {"ns", t.ns},
          {"our_ns", t.our_ns},
          {"times_ours", f.times_ours()}};
}

Json plan_json(const Scene& scene, const Plan& plan) {
  const TriangleCounts all = count_triangles(scene);
  const PlanCounts baked = counts(plan);
  Json j{{"triangles", all.unique},
         {"triangles_placed", all.placed},
         {"baked_triangles", baked.unique},
         {"baked_triangles_placed", baked.placed},
         {"distinct_triangles", plan.triangles.size()},
         {"reordered_triangles", baked.reordered},
         {"surfaces", Json::array()},
         {"left_out", Json::array()}};
  for (const Surface& s : plan.surfaces)
    j["surfaces"].push_back({{"image", scene.images[s.image].name},
                             {"width", scene.images[s.image].width},
                             {"height", scene.images[s.image].height},
                             {"mode", s.mode == AlphaMode::mask ? "MASK" : "BLEND"},
                             {"filter", filter_of(s.sampler) == Filter::nearest ? "nearest" : "linear"},
                             {"cutoff", s.cutoff},
                             {"factor", double{s.base_color_alpha} * s.vertex_alpha}});
  for (const LeftOutPrimitive& p : plan.left_out) {
    const Primitive& primitive = scene.primitives[p.primitive];
    j["left_out"].push_back({{"mesh", primitive.mesh},
                             {"primitive", primitive.number},
                             {"triangles", primitive.triangles.size()},
                             {"why", sentence(p.why)}});
  }
  return j;
}

Json materials_json(const SceneFigures& f) {
  Json all = Json::array();
  for (const MaterialFigures& m : f.materials) {
    Json levels = Json::array();
    for (std::size_t n = 0; n < m.levels.size(); ++n)
      levels.push_back({{"level", n},
                        {"micromaps", m.levels[n].maps},
                        {"bytes", m.levels[n].bytes},
                        {"unknown", m.levels[n].unknown}});
    all.push_back({{"material", m.material},
                   {"name", f.scene.materials[m.material].name},
                   {"triangles", m.triangles},
                   {"distinct", m.distinct},
                   {"area", m.area},
                   {"levels", levels}});
  }
  return all;
}

}  // namespace

std::string scene_json(const SceneFigures* f, const Scene& scene, const Plan& plan,
                       const std::vector<proofs::scene::LeftOutLaw>& left_out,
                       const std::optional<SubjectFigures>& subject) {
  Json j{{"file", scene.file}, {"plan", plan_json(scene, plan)}};
  if (!scene.notes.empty()) j["notes"] = scene.notes;
  if (subject) j["subject"] = to_json(*subject);
  for (const auto& [what, why] : left_out)
    j["plan"]["left_out_laws"].push_back({{"what", what}, {"why", why}});
  if (f == nullptr) return json_text(j, -1);
  Json levels = Json::object();
  impl::micromap::StateCounts states{};
  for (const BakedTriangle& t : f->made.baked.triangles) {
    Json& count = levels[fmt::format("{}", t.level)];
    count = count.is_null() ? 1 : count.get<std::uint64_t>() + 1;
    for (std::size_t k = 0; k < 4; ++k) states[k] += t.states[k];
  }
  j["bake"] = {{"micro_triangles", f->made.baked.counts.micro_triangles},
               {"leaves", f->made.baked.counts.leaves},
               {"exact", f->made.baked.counts.exact},
               {"triangles_by_level", levels},
               {"lowered", f->made.levels.lowered},
               {"states", {{"T", states[0]}, {"O", states[1]}, {"UT", states[2]}, {"UO", states[3]}}},
               {"load_seconds", f->load_seconds},
               {"bake_seconds", f->made.bake_seconds}};
  j["saved"] = to_json(f->sizes.any_hit);
  j["footprint"] = to_json(f->sizes.footprint);
  j["materials"] = materials_json(*f);
  j["pairs"] = {{"pairs", f->made.pairs.unique},
                {"distinct", f->made.pairs.distinct.size()},
                {"unpaired", f->made.pairs.unpaired}};
  if (f->made.pairs.unique != 0) {
    j["vq2"] = to_json(f->vq2);
    j["vq4"] = to_json(f->vq4);
  }
  for (const auto& at : f->at_levels)
    j["sizes"].push_back({{"level", at.level},
                          {"footprint", to_json(at.sizes.footprint)},
                          {"saved", to_json(at.sizes.any_hit)}});
  return json_text(j, -1);
}

}  // namespace mmverify::cli
