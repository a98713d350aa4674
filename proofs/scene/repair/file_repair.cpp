#include "proofs/scene/repair/file_repair.hpp"

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/scene/laws.hpp"
#include "proofs/scene/repair/repairs.hpp"
#include "scene/edit/index_codes.hpp"
#include "scene/edit/map_edits.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/read/primitives.hpp"
#include "scene/record/bake_record.hpp"
#include "scene/validate/report.hpp"
#include "scene/validate/stored_maps.hpp"

namespace mmverify::proofs::scene {

using namespace mmverify::scene;

template <class Search>
auto FileRepair::searched(const Search& search) const {
  const Document opened = document();
  const Buffers buffers(opened);
  Judged judged{scene_, maps_, request_.margin, request_.two_state};
  judged.uvs = [&](const Primitive& primitive, const BaseColorTexture& texture) {
    try {
      return read_uvs(opened, buffers, primitive, texture);
    } catch (const BadScene&) {
      return std::vector<Uv>();  // no baker took UVs that cannot be read
    }
  };
  return search(judged);
}

void FileRepair::run() {
  RepairedRules rules = repair_rules(file_);
  report_.rules = std::move(rules.repairs);
  report_.broken = std::move(rules.left);
  if (!report_.broken.empty()) return;
  scene_ = load(document());
  unlink_unbakeable();
  maps_ = without_varying_alpha(stored_maps(document(), scene_));
  report_.not_judged = maps_.not_judged;
  if (maps_.plan.triangles.empty()) return;
  relink();
  repair_maps(rules.unlinked);
  if (report_.left.empty()) refresh_records();
}

/// Takes the maps of a bake from primitives that can have none any more: a T in the maps of an opaque material is a hole.
void FileRepair::unlink_unbakeable() {
  for (std::size_t p = 0; p < scene_.primitives.size(); ++p) {
    const Primitive& primitive = scene_.primitives[p];
    nlohmann::json& json = file_.json["meshes"][primitive.mesh]["primitives"][primitive.number];
    const nlohmann::json& extras = member(extension(json, micromap_extension), "extras");
    if (!extras.is_object() || !extras.contains(bake_record_name)) continue;
    const std::string why = why_unbakeable(scene_, primitive);
    if (why.empty() || changes_since(extras[bake_record_name].dump(), scene_, primitive).empty()) continue;
    json["extensions"].erase(micromap_extension);
    if (json["extensions"].empty()) json.erase("extensions");  // glTF has no empty objects
    report_.primitives.push_back({p, "its maps were taken away: " + why});
  }
}

/// Writes the records of bakes anew: all maps are right for the file as it is.
void FileRepair::refresh_records() {
  for (const Primitive& primitive : scene_.primitives) {
    const nlohmann::json& maps =
        extension(file_.json["meshes"][primitive.mesh]["primitives"][primitive.number], micromap_extension);
    const nlohmann::json& extras = member(maps, "extras");
    if (!extras.is_object() || !extras.contains(bake_record_name)) continue;
    if (changes_since(extras[bake_record_name].dump(), scene_, primitive).empty()) continue;
    extension_of(file_, primitive.mesh, primitive.number)["extras"][bake_record_name] =
        nlohmann::json::parse(bake_record(scene_, primitive, {request_.margin, request_.two_state}));
  }
}

std::string FileRepair::broken_law(const WrittenFile& written) {
  const auto open = [&] { return file_.reopened(written); };
  for (const FileViolation& violation : validate_micromaps(open)) return describe(violation);
  const StoredMaps all = stored_maps(open(), scene_);
  if (all.plan.triangles.empty()) return "";
  maps_ = without_varying_alpha(all);
  const std::vector<MapRepair> repairs = searched([](const auto& judged) { return map_repairs(judged); });
  for (std::size_t k = 0; k < repairs.size(); ++k)
    if (repairs[k].kind != MapRepair::Kind::none)
      return "the map of triangle " + std::to_string(maps_.link(k).triangle) + " is still wrong";
  const SceneArrays no_arrays;
  const Pairs no_pairs;
  const SquareMaps no_squares;
  const Data data{scene_,   all.plan,   all.baked,       no_arrays,
                  no_pairs, no_squares, request_.margin, request_.two_state};
  const SceneLaws laws =
      map_laws(data, {.size = request_.samples}, file_.document().file, "mmverify check maps");
  RunOptions run;
  run.seed = request_.seed;
  run.show_progress = request_.show_progress;
  run.mutants = false;
  const Report found = run_jobs(laws.jobs, run, [](const Result&) {});
  if (found.interrupted) throw Interrupted();
  for (const Result& result : found.results)
    if (result.verdict == Verdict::refuted || result.verdict == Verdict::broken)
      return result.law + " is refuted";
  return "";
}

void FileRepair::apply(const Relink& relink, const nlohmann::json& before) {
  const Primitive& primitive = scene_.primitives[relink.primitive];
  nlohmann::json& given = extension_of(file_, primitive.mesh, primitive.number);
  given["micromap"] = relink.micromap;
  if (relink.base != 0)
    given["micromapBaseTriangle"] = relink.base;
  else
    given.erase("micromapBaseTriangle");
  if (!relink.indices_of) return;
  const Primitive& other = scene_.primitives[*relink.indices_of];
  const nlohmann::json& from =
      extension(before["meshes"][other.mesh]["primitives"][other.number], micromap_extension);
  if (from.contains("micromapIndices"))
    given["micromapIndices"] = from["micromapIndices"];
  else
    given.erase("micromapIndices");
}

/// Gives primitives other links, if the file keeps all rules then.
void FileRepair::relink() {
  const std::vector<Relink> all = searched([](const auto& judged) { return relinks(judged); });
  if (all.empty()) return;
  const nlohmann::json before = file_.json;
  for (const Relink& one : all) apply(one, before);
  if (!validate_micromaps([&] { return document(); }).empty()) {
    file_.json = before;
    return;
  }
  maps_ = without_varying_alpha(stored_maps(document(), scene_));
  for (const Relink& one : all) report_.primitives.push_back({one.primitive, one.says});
}

std::set<std::size_t> FileRepair::planned(const std::vector<TriangleOfFile>& triangles) const {
  std::set<std::size_t> all;
  for (const TriangleOfFile& one : triangles)
    for (const MapLink& link : maps_.links) {
      const Primitive& primitive = scene_.primitives[link.primitive];
      if (primitive.mesh == one.mesh && primitive.number == one.number && link.triangle == one.triangle)
        all.insert(link.planned);
    }
  return all;
}

void FileRepair::repair_maps(const std::vector<TriangleOfFile>& unlinked) {
  const std::vector<MapRepair> repairs =
      searched([&](const auto& judged) { return map_repairs(judged, planned(unlinked)); });
  std::vector<BakedTriangle> maps;
  for (const MapRepair& one : repairs) maps.push_back(one.map);
  std::vector<MapEdit> edits;
  for (const MapLink& link : maps_.links) {
    ++report_.judged[link.primitive];
    const MapRepair& one = repairs[link.planned];
    const bool is_baked = one.kind == MapRepair::Kind::baked;
    if (one.kind == MapRepair::Kind::none || (is_baked && one.may_stay && !request_.bake)) continue;
    const Primitive& primitive = scene_.primitives[link.primitive];
    const bool is_left = is_baked && !request_.bake;
    (is_left ? report_.left : report_.triangles)
        .push_back({link.primitive, link.triangle,
                    is_left    ? ""
                    : is_baked ? "baked anew"
                               : one.did});
    if (!is_left) edits.push_back({primitive.mesh, primitive.number, link.triangle, link.planned});
  }
  if (report_.left.empty()) return write_maps(file_, maps, edits);
  const auto cause = searched([](Judged judged) -> std::optional<Cause> {
    judged.until = std::chrono::steady_clock::now() + most_cause_time;
    try {
      return cause_of(judged);
    } catch (const OutOfTime&) {
      return {};
    }
  });
  if (cause && cause->explained == cause->wrong) report_.cause = cause->code + ": " + cause->says;
}

}  // namespace mmverify::proofs::scene
