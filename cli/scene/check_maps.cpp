#include "cli/scene/check_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/junit.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/scene/loaded.hpp"
#include "cli/scene/wrong_maps.hpp"
#include "cli/validate/validate.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/scene/laws.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/file.hpp"
#include "scene/read/load.hpp"
#include "scene/validate/issues.hpp"
#include "scene/validate/micromaps.hpp"
#include "scene/validate/stored_maps.hpp"

namespace mmverify::cli {
namespace {

namespace micromap = impl::micromap;
using namespace mmverify::scene;
using proofs::Groups;

/// Thrown for maps that break rules and so cannot be judged. Exit code 1.
struct Malformed {
  std::vector<std::string> lines;
};

/// Prints the rules that a file's micromaps break.
void print_malformed(std::FILE* out, const std::string& file, const std::vector<std::string>& lines) {
  say(out, "{}: its micromaps break rules\n", file);
  for (const std::string& line : lines) say(out, "  {}\n", line);
}

/// Reads the maps.  Records that overlap can be read all the same: they are printed, and `keeps_rules` is false.
StoredMaps of_file(const CheckMapsOptions& options, const Scene& scene, std::FILE* out, bool& keeps_rules) {
  Malformed malformed;
  bool readable = true;
  for (const FileViolation& v : validate_micromaps(options.file)) {
    if (issue_of(v.rule).severity != Severity::error) continue;
    malformed.lines.push_back(describe(v));
    readable = readable && v.rule == "record.overlap";
  }
  if (!readable) throw malformed;
  keeps_rules = malformed.lines.empty();
  if (!keeps_rules) print_malformed(out, options.file, malformed.lines);
  return stored_maps(options.file, scene);
}

std::size_t primitive_of(const std::string& text, const Scene& scene) {
  const Groups parts = proofs::groups_of(text, "([0-9]{1,9})/([0-9]{1,9})");
  if (!parts) throw UsageError(fmt::format("--primitive {}: write MESH/PRIMITIVE, for example 0/2", text));
  const auto mesh = std::stoul((*parts)[1]), number = std::stoul((*parts)[2]);
  for (std::size_t p = 0; p < scene.primitives.size(); ++p)
    if (scene.primitives[p].mesh == mesh && scene.primitives[p].number == number) return p;
  throw UsageError(fmt::format("--primitive {}: the scene has no such primitive", text));
}

micromap::Encoding encoding_of(const std::string& name) {
  constexpr std::array<std::pair<const char*, micromap::Encoding>, 5> all{{{"u8", micromap::Encoding::u8},
                                                                           {"u16", micromap::Encoding::u16},
                                                                           {"u32", micromap::Encoding::u32},
                                                                           {"i16", micromap::Encoding::i16},
                                                                           {"i32", micromap::Encoding::i32}}};
  return std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.first == name; })->second;
}

StoredMaps of_buffers(const CheckMapsOptions& options, const Scene& scene) {
  const RawArray& raw = options.raw;
  if (raw.records.empty() || raw.primitive.empty())
    throw UsageError("--data: give --records FILE and --primitive MESH/PRIMITIVE as well");
  const std::size_t primitive = primitive_of(raw.primitive, scene);
  const Bytes data = read_file(raw.data, raw.data, "--data"),
              records = read_file(raw.records, raw.records, "--records");
  Bytes indices;
  micromap::Input in;
  in.sets = micromap::DXR;  // allows levels up to 12 on any device
  in.data = data;
  in.records = records;
  in.record_count = records.size() / micromap::record_bytes;
  in.triangles = scene.primitives[primitive].triangles.size();
  in.base_triangle = raw.base_triangle;
  if (!raw.indices.empty()) {
    indices = read_file(raw.indices, raw.indices, "--indices");
    in.indexed = true;
    in.indices = indices;
    in.encoding = encoding_of(raw.index_type);
    in.index_stride = micromap::width(in.encoding) / 8;
  }
  Malformed malformed;
  for (const micromap::Violation& v : micromap::validate(in)) {
    if (malformed.lines.size() == 8) break;
    // The index encodings of a build are not checked: those of glTF are allowed here.
    if (v.rule != micromap::Rule::index_encoding) malformed.lines.push_back(describe(v));
  }
  if (!malformed.lines.empty()) throw malformed;
  return stored_maps(in, scene, primitive);
}

std::string command_of(const CheckMapsOptions& o) {
  std::string text = "mmverify check maps " + shell_quoted(o.file);
  if (!o.raw.data.empty()) {
    text += fmt::format(" --data {} --records {} --primitive {}", shell_quoted(o.raw.data),
                        shell_quoted(o.raw.records), o.raw.primitive);
    if (!o.raw.indices.empty())
      text += fmt::format(" --indices {} --index-type {}", shell_quoted(o.raw.indices), o.raw.index_type);
    if (o.raw.base_triangle != 0) text += fmt::format(" --base-triangle {}", o.raw.base_triangle);
  }
  if (o.states != 4) text += " --states 2";
  if (o.margin != 0) text += fmt::format(" --margin {}", o.margin);
  return text;
}

void print_maps(std::FILE* out, const CheckMapsOptions& options, const Scene& scene, const StoredMaps& maps) {
  micromap::StateCounts states{};
  std::array<std::uint64_t, 13> levels{};
  for (const MapLink& link : maps.links) {
    const BakedTriangle& t = maps.baked.triangles[link.planned];
    ++levels[t.level];
    for (std::size_t k = 0; k < 4; ++k) states[k] += t.states[k];
  }
  say(out, "{}: {} triangles with maps, {} distinct; {} of them special indices\n", options.file,
      grouped(maps.links.size()), grouped(maps.plan.triangles.size()), grouped(maps.special));
  std::string by_level;
  for (std::size_t n = 0; n < levels.size(); ++n)
    if (levels[n] != 0)
      by_level += fmt::format("{}{}: {}", by_level.empty() ? "" : ", ", n, grouped(levels[n]));
  say(out, "  by level   {}\n  states     T {}, O {}, UT {}, UO {}\n", by_level, grouped(states[0]),
      grouped(states[1]), grouped(states[2]), grouped(states[3]));
  if (const std::uint64_t varying = counts(maps.plan).varying; varying != 0)
    say(out, "  by bounds  {} triangles, whose vertex alpha varies: {}\n", grouped(varying),
        options.states == 2 ? "in 2-state they are not judged"
                            : "T and O are judged, unknown states are not");
  for (const NotJudged& n : maps.not_judged)
    say(out, "  not judged mesh {} primitive {}, {} triangles: {}\n", scene.primitives[n.primitive].mesh,
        scene.primitives[n.primitive].number, grouped(n.triangles), sentence(n.why));
}

/// A triangle by its primitive's numbers and its material's name.
std::string triangle_name(const Scene& scene, const MapLink& link) {
  const Primitive& primitive = scene.primitives[link.primitive];
  const std::string& material = scene.material_of(primitive).name;
  return fmt::format("mesh {} primitive {} triangle {}{}", primitive.mesh, primitive.number, link.triangle,
                     material.empty() ? "" : fmt::format(" of material {}", material));
}

/// Refuses options that cannot go together.
void refuse_conflicts(const CheckMapsOptions& options) {
  if (options.file.empty()) throw UsageError("check maps: name the scene, FILE.gltf or FILE.glb");
  if (options.replay.empty() != options.at.empty())
    throw UsageError("--replay LAW and --case LEVEL@CASE go together");
  if (options.json == "-" && options.junit == "-")
    throw UsageError("--json and --junit: one standard output for both");
  refuse_same_file({{"the scene", options.file},
                    {"--data", options.raw.data},
                    {"--records", options.raw.records},
                    {"--indices", options.raw.indices},
                    {"--json", options.json},
                    {"--junit", options.junit},
                    {"--picture", options.picture}});
}

int replayed(const proofs::scene::SceneLaws& laws, const CheckMapsOptions& options) {
  const auto colon = options.at.find('@');
  if (colon == std::string::npos) throw UsageError("--case " + options.at + ": write LEVEL@CASE");
  const proofs::Level level = parse_level(options.at.substr(0, colon));
  for (const proofs::Job& job : laws.jobs) {
    if (job.law->id != options.replay || job.levels.first != level) continue;
    try {
      const std::string at = options.at.substr(colon + 1);
      const proofs::Replayed r = job.law->replay(*job.subject, level, at);
      say(stdout, "{} {} level {} case {} expected {} got {}\n", r.holds ? "holds" : "refuted", job.law->id,
          level, at, r.expected, r.got);
      return r.holds ? complete : failed;
    } catch (const proofs::BadCase& bad) {
      throw UsageError(fmt::format("--case {}", bad.what()));
    }
  }
  throw UsageError(
      fmt::format("--replay {}: no law of that name has cases of that level here", options.replay));
}

/// Runs the laws on the maps, prints and writes their results.
int judged(const CheckMapsOptions& options, const Scene& scene, const StoredMaps& maps, JsonOutput& json,
           std::optional<OutputFile>& junit, OutputFile* picture) {
  std::FILE* const out = json.text();
  const SceneArrays no_arrays;
  const Pairs no_pairs;
  const SquareMaps no_squares;
  const proofs::scene::Data data{
      scene,
      maps.plan,
      maps.baked,
      no_arrays,
      no_pairs,
      no_squares,
      options.margin,
      options.states == 2,
      {},
      [&](std::size_t triangle) { return triangle_name(scene, maps.link(triangle)); }};
  const proofs::scene::SceneLaws laws = proofs::scene::map_laws(
      data, sample_of(options.effort, data, 0, proofs::scene::work_of_a_minute),
      options.raw.data.empty() ? options.file : options.raw.data, command_of(options));
  if (!options.replay.empty()) return replayed(laws, options);
  std::fflush(out);
  TextReport text(out, false);
  proofs::RunOptions run;
  run.seed = options.seed;
  run.errors = options.errors;
  run.show_progress = !options.quiet;
  run.mutants = false;
  const proofs::Report report = run_jobs(laws.jobs, run, [&](const proofs::Result& r) { text.add(r); });
  text.finish(report, false);
  std::string cause_json;
  if (!report.interrupted) cause_json = print_why(out, options, scene, maps, report, picture);
  json.write([&] { return to_json(report, options.seed, {}, {}, {}, {}, cause_json); });
  if (junit) junit->commit(to_junit(report));
  if (laws.jobs.empty()) refuse_nothing({});
  return exit_code(report);
}

}  // namespace

int check_maps(const CheckMapsOptions& options) {
  refuse_conflicts(options);
  const proofs::InterruptGuard guard;
  JsonOutput json(options.json);
  std::optional<OutputFile> junit;
  if (!options.junit.empty()) junit.emplace(options.junit);
  std::optional<OutputFile> picture;
  if (!options.picture.empty()) picture.emplace(options.picture);
  std::FILE* const out = json.text();
  const Scene scene = load(options.file);
  refuse_files_of(options.file,
                  {{"--json", options.json}, {"--junit", options.junit}, {"--picture", options.picture}});
  StoredMaps maps;
  bool keeps_rules = true;
  try {
    maps = options.raw.data.empty() ? of_file(options, scene, out, keeps_rules) : of_buffers(options, scene);
  } catch (const Malformed& malformed) {
    print_malformed(out, options.raw.data.empty() ? options.file : options.raw.data, malformed.lines);
    if (options.raw.data.empty() && repairs_all_rules(options.file, {})) print_repair(out, options.file);
    return failed;
  }
  for (const std::string& note : scene.notes) say(out, "note: {}\n", printable(note));
  if (maps.baked.triangles.empty() && maps.not_judged.empty()) {
    const std::string other = names_used(options.file).other;
    throw UsageError(fmt::format("{}: no primitive has a micromap{}", options.file,
                                 other.empty() ? "" : "; it has " + other + ", which is not read here"));
  }
  print_maps(out, options, scene, maps);
  const int code = judged(options, scene, maps, json, junit, picture ? &*picture : nullptr);
  if (!keeps_rules && code == complete && repairs_all_rules(options.file, {}))
    print_repair(out, options.file);
  return keeps_rules || code != complete ? code : failed;
}

}  // namespace mmverify::cli
