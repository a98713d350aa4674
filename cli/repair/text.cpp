#include "cli/output/text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/arguments/arguments.hpp"
#include "cli/output/json_text.hpp"
#include "cli/output/streams.hpp"
#include "cli/repair/repair.hpp"
#include "cli/tool.hpp"
#include "scene/validate/issues.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using proofs::scene::RelinkedPrimitive;
using proofs::scene::RepairedTriangle;
using proofs::scene::RepairReport;
using OrderedJson = nlohmann::ordered_json;

/// Lines of triangles' repairs that are printed without --details.
constexpr std::size_t most_lines = 16;

/// A repair without its numbers: "linked to the map of record 3" and "... of record 7" are of one kind.
std::string kind_of(const std::string& did) {
  std::string kind;
  for (std::size_t at = 0; at < did.size();) {
    const auto record = did.find("record ", at);
    kind += did.substr(at, record - at);
    if (record == std::string::npos) break;
    kind += "another record";
    at = record + 7;
    while (at < did.size() && did[at] >= '0' && did[at] <= '9') ++at;
  }
  return kind;
}

using Counts = std::map<std::pair<std::size_t, std::string>, std::size_t>;

/// The triangles by primitive and kind of repair.
Counts counted(const std::vector<RepairedTriangle>& triangles) {
  Counts counts;
  for (const RepairedTriangle& one : triangles) ++counts[{one.primitive, kind_of(one.did)}];
  return counts;
}

std::string name_of(const Scene& scene, std::size_t primitive) {
  return fmt::format("mesh {} primitive {}", scene.primitives[primitive].mesh,
                     scene.primitives[primitive].number);
}

std::string result_of(const RepairReport& report) {
  return report.is_right() ? "right" : report.is_whole() ? "repaired" : "left";
}

OrderedJson triangles_json(const Scene& scene, const std::vector<RepairedTriangle>& triangles) {
  OrderedJson all = OrderedJson::array();
  for (const RepairedTriangle& one : triangles) {
    OrderedJson j{{"mesh", scene.primitives[one.primitive].mesh},
                  {"primitive", scene.primitives[one.primitive].number},
                  {"triangle", one.triangle}};
    if (!one.did.empty()) j["did"] = one.did;
    all.push_back(j);
  }
  return all;
}

void print_not_judged(std::FILE* out, const Scene& scene, const RepairReport& report) {
  for (const NotJudged& one : report.not_judged)
    say(out, "  not judged: {}, {} triangles: {}\n", name_of(scene, one.primitive), grouped(one.triangles),
        sentence(one.why));
}

void print_left(std::FILE* out, const RepairOptions& options, const Scene& scene,
                const RepairReport& report) {
  for (const FileViolation& one : report.broken) say(out, "  left: {}\n", printable(describe(one)));
  for (const auto& [key, count] : counted(report.left))
    say(out, "  left: {}: {} of {} triangles fit no map of the file\n", name_of(scene, key.first),
        grouped(count), grouped(report.judged.at(key.first)));
  if (options.details)
    for (const RepairedTriangle& one : report.left)
      say(out, "    {} triangle {}: left\n", name_of(scene, one.primitive), one.triangle);
  if (!report.cause.empty()) say(out, "cause: {}\n", report.cause);
}

}  // namespace

void print_repairs(std::FILE* out, const RepairOptions& options, const Scene& scene,
                   const RepairReport& report) {
  for (const RuleRepair& one : report.rules)
    say(out, "  {}: {}: {}\n", one.rule, printable(one.pointer), one.did);
  for (const RelinkedPrimitive& one : report.primitives)
    say(out, "  {}: {}\n", name_of(scene, one.primitive), one.did);
  const Counts counts = counted(report.triangles);
  std::size_t lines = 0;
  for (const auto& [key, count] : counts) {
    if (++lines > most_lines && !options.details) break;
    say(out, "  {}: {} of {} triangles {}\n", name_of(scene, key.first), grouped(count),
        grouped(report.judged.at(key.first)), key.second);
  }
  if (counts.size() > most_lines && !options.details)
    say(out, "  and {} more such lines: {} triangles in all; --details prints them\n",
        grouped(counts.size() - most_lines), grouped(report.triangles.size()));
  if (options.details)
    for (const RepairedTriangle& one : report.triangles)
      say(out, "    {} triangle {}: {}\n", name_of(scene, one.primitive), one.triangle, one.did);
  print_not_judged(out, scene, report);
  print_left(out, options, scene, report);
}

std::string repairs_json(const RepairOptions& options, const Scene& scene, const RepairReport& report) {
  OrderedJson j{
      {"schema", "mmverify.repair/1"},
      {"tool",
       tool(
           {{"bake", options.request.bake}, {"states", options.states}, {"margin", options.request.margin}})},
      {"file", options.file},
      {"output", options.output},
      {"result", result_of(report)},
      {"rules", OrderedJson::array()},
      {"primitives", OrderedJson::array()},
      {"triangles", triangles_json(scene, report.triangles)},
      {"left", {{"rules", OrderedJson::array()}, {"triangles", triangles_json(scene, report.left)}}},
      {"cause", report.cause.empty() ? OrderedJson(nullptr) : OrderedJson(report.cause)}};
  for (const RuleRepair& one : report.rules)
    j["rules"].push_back({{"code", one.rule}, {"pointer", one.pointer}, {"did", one.did}});
  for (const RelinkedPrimitive& one : report.primitives)
    j["primitives"].push_back({{"mesh", scene.primitives[one.primitive].mesh},
                               {"primitive", scene.primitives[one.primitive].number},
                               {"did", one.did}});
  for (const FileViolation& one : report.broken)
    j["left"]["rules"].push_back(
        {{"code", std::string(one.rule)}, {"pointer", one.pointer}, {"found", one.found}});
  return json_text(j);
}

}  // namespace mmverify::cli
