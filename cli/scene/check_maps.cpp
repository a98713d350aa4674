#include "cli/scene/check_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/junit.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/sarif.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/scene/loaded.hpp"
#include "cli/scene/wrong_maps.hpp"
#include "cli/validate/validate.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/scene/laws.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"
#include "scene/read/file.hpp"
#include "scene/read/load.hpp"
#include "scene/validate/folder.hpp"
#include "scene/validate/issues.hpp"
#include "scene/validate/kept_records.hpp"
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

/// One file's options, its maps' states known, and what its check has found.
struct Checked {
  CheckMapsOptions options;
  bool two_state = false;
  bool keeps_rules = true;
  int code = complete;
  proofs::Report report = {};
  std::string cause_json = {};
  std::vector<SarifResult> findings = {};
};

/// Prints the rules that a file's micromaps break.
void print_malformed(std::FILE* out, const std::string& file, const std::vector<std::string>& lines) {
  say(out, "{}: its micromaps break rules\n", file);
  for (const std::string& line : lines) say(out, "  {}\n", line);
}

/// Reads the maps.  Records that overlap can be read all the same: they are printed, and keeps_rules is false.
StoredMaps of_file(Checked& checked, const Scene& scene, std::FILE* out) {
  const CheckMapsOptions& options = checked.options;
  Malformed malformed;
  bool readable = true;
  for (const FileViolation& v : validate_micromaps(options.file)) {
    if (issue_of(v.rule).severity != Severity::error) continue;
    malformed.lines.push_back(describe(v));
    checked.findings.push_back(sarif_of(v, options.file));
    readable = readable && v.rule == "record.overlap";
  }
  if (!readable) throw malformed;
  checked.keeps_rules = malformed.lines.empty();
  if (!checked.keeps_rules) print_malformed(out, options.file, malformed.lines);
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
  if (o.states == 2) text += " --states 2";
  if (o.margin != 0) text += fmt::format(" --margin {}", o.margin);
  return text;
}

void print_maps(std::FILE* out, const Checked& checked, const Scene& scene, const StoredMaps& maps) {
  const CheckMapsOptions& options = checked.options;
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
        checked.two_state ? "in 2-state they are not judged" : "T and O are judged, unknown states are not");
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
  if (options.json == "-" && options.sarif == "-")
    throw UsageError("--json and --sarif: one standard output for both");
  refuse_same_file({{"the scene", options.file},
                    {"--data", options.raw.data},
                    {"--records", options.raw.records},
                    {"--indices", options.raw.indices},
                    {"--json", options.json},
                    {"--junit", options.junit},
                    {"--sarif", options.sarif},
                    {"--picture", options.picture}});
}

/// Refuses the options of one file for a folder.
void refuse_for_folder(const CheckMapsOptions& options) {
  const std::pair<const char*, const std::string&> of_one[] = {
      {"--data", options.raw.data}, {"--replay", options.replay}, {"--picture", options.picture}};
  for (const auto& [option, value] : of_one)
    if (!value.empty())
      throw UsageError(fmt::format("{}: {} is a folder; name one of its files", option, options.file));
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

/// The wrong cases of a report as results of SARIF; a rule is a law.
void add_findings(Checked& checked, const proofs::scene::SceneLaws& laws, const std::string& file) {
  for (const proofs::Result& result : checked.report.results) {
    const auto law = std::find_if(laws.laws.begin(), laws.laws.end(),
                                  [&](const proofs::Law& l) { return l.id == result.law; });
    if (law == laws.laws.end()) continue;
    const SarifRule rule{law->id, law->says, "mmverify check maps names the cause and the remedy",
                         law->source};
    if (result.verdict == proofs::Verdict::broken)
      checked.findings.push_back({rule, file, fmt::format("level {}", result.level), result.reason});
    for (const proofs::Counterexample& c : result.counterexamples)
      checked.findings.push_back(
          {rule, file, fmt::format("{}@{}", c.level, c.at),
           fmt::format("level {}, {} of {} cases wrong; case {}: expected {}, got {}", c.level,
                       result.mismatches(), result.cases_run(), c.at, c.expected, c.got)});
  }
}

/// The verdict in words, if nothing is wrong.  "judged": some states are not, those of primitives that cannot be read, and
/// unknown ones where vertex alpha varies.
void print_fit(std::FILE* out, const Checked& checked, const StoredMaps& maps, const std::string& judged) {
  const auto& results = checked.report.results;
  if (checked.code != complete || results.empty()) return;
  const bool all_judged = maps.not_judged.empty() && counts(maps.plan).varying == 0;
  const bool is_sample = std::any_of(results.begin(), results.end(), [](const proofs::Result& r) {
    return r.verdict == proofs::Verdict::checked;
  });
  say(out, "{}: {} of {} triangles\n", printable(judged),
      is_sample    ? "a sample found no wrong state in the maps"
      : all_judged ? "every state fits the texture, in the maps"
                   : "every state that was judged fits the texture, in the maps",
      grouped(maps.links.size()));
}

/// Runs the laws on the maps, prints their results.
void judge(Checked& checked, const Scene& scene, const StoredMaps& maps, std::FILE* out,
           OutputFile* picture) {
  const CheckMapsOptions& options = checked.options;
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
      checked.two_state,
      {},
      [&](std::size_t triangle) { return triangle_name(scene, maps.link(triangle)); }};
  const std::string& judged = options.raw.data.empty() ? options.file : options.raw.data;
  const proofs::scene::SceneLaws laws = proofs::scene::map_laws(
      data, sample_of(options.effort, data, 0, proofs::scene::work_of_a_minute), judged, command_of(options));
  if (!options.replay.empty()) {
    checked.code = replayed(laws, options);
    return;
  }
  std::fflush(out);
  TextReport text(out, false);
  proofs::RunOptions run;
  run.seed = options.seed;
  run.errors = options.errors;
  run.show_progress = !options.quiet;
  run.mutants = false;
  checked.report = run_jobs(laws.jobs, run, [&](const proofs::Result& r) { text.add(r); });
  text.finish(checked.report, false);
  if (const auto note = proofs::scene::rationals_text(laws)) say(out, "note: {}\n", *note);
  if (!checked.report.interrupted)
    checked.cause_json = print_why(out, options, checked.two_state, scene, maps, checked.report, picture,
                                   !checked.keeps_rules && repairs_all_rules(options.file, {}));
  add_findings(checked, laws, judged);
  checked.code = exit_code(checked.report);
  print_fit(out, checked, maps, judged);
}

/// 2 or 4: as asked, else as the file's records say, else 4.
bool two_state(const CheckMapsOptions& options, std::FILE* out) {
  if (options.states || !options.raw.data.empty()) return options.states == 2;
  const bool is_two = recorded_states(open_document(options.file), newest_draft) == 2;
  if (is_two) say(out, "note: {}: baked to 2-state, as its record says\n", printable(options.file));
  return is_two;
}

/// Checks one file.  Errors: UsageError if it has no maps to judge; BadScene.
Checked checked_file(const CheckMapsOptions& options, std::FILE* out, OutputFile* picture) {
  Checked checked{.options = options};
  const Scene scene = load(options.file);
  refuse_files_of(options.file, {{"--json", options.json},
                                 {"--junit", options.junit},
                                 {"--sarif", options.sarif},
                                 {"--picture", options.picture}});
  const bool of_scene = options.raw.data.empty();
  StoredMaps maps;
  try {
    maps = of_scene ? of_file(checked, scene, out) : of_buffers(options, scene);
  } catch (const Malformed& malformed) {
    print_malformed(out, of_scene ? options.file : options.raw.data, malformed.lines);
    if (of_scene && repairs_all_rules(options.file, {})) print_repair(out, options.file);
    checked.code = failed;
    return checked;
  }
  for (const std::string& note : scene.notes) say(out, "note: {}\n", printable(note));
  if (maps.baked.triangles.empty() && maps.not_judged.empty()) {
    const std::string other = names_used(options.file).other;
    throw UsageError(fmt::format("{}: no primitive has a micromap{}", options.file,
                                 other.empty() ? "" : "; it has " + other + ", which is not read here"));
  }
  checked.two_state = two_state(options, out);
  if (checked.two_state) checked.options.states = 2;
  print_maps(out, checked, scene, maps);
  judge(checked, scene, maps, out, picture);
  if (!checked.keeps_rules && checked.code == complete) {
    if (repairs_all_rules(options.file, {})) print_repair(out, options.file);
    checked.code = failed;
  }
  return checked;
}

/// Checks each glTF file of a folder that has micromaps.  A file that cannot be judged is named, and the others go on.
std::vector<Checked> checked_folder(const CheckMapsOptions& options, std::FILE* out,
                                    std::vector<SarifNotification>& unread) {
  std::vector<Checked> all;
  for (const std::string& file : micromap_files(options.file)) {
    CheckMapsOptions one = options;
    one.file = file;
    try {
      if (mmverify::scene::kind_of(read_file(file, file, "")) != FileKind::gltf) continue;
      open_document(file);  // or a damaged file would be one without micromaps
      if (!names_used(file).ext) continue;
      all.push_back(checked_file(one, out, nullptr));
    } catch (const BadScene& bad) {
      say(out, "{} (not judged)\n", printable(bad.what()));
      unread.push_back({file, bad.what()});
      all.push_back({.options = one, .code = environment});
    } catch (const UsageError& nothing) {
      say(out, "{} (not judged)\n", printable(nothing.what()));
    }
    if (!all.empty() && all.back().report.interrupted) break;
  }
  if (all.empty()) throw UsageError(options.file + ": no file of this folder has micromaps to judge");
  const auto with = [&](int code) {
    return std::count_if(all.begin(), all.end(), [code](const Checked& c) { return c.code == code; });
  };
  say(out, "{} file{} with micromaps: {} right, {} wrong, {} not judged\n", all.size(),
      all.size() == 1 ? "" : "s", with(complete), with(failed), with(environment));
  return all;
}

/// The results of all files, one after the other.
proofs::Report merged(const std::vector<Checked>& all) {
  proofs::Report report = all.front().report;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const proofs::Report& next = all[k].report;
    report.results.insert(report.results.end(), next.results.begin(), next.results.end());
    report.diagnoses.insert(report.diagnoses.end(), next.diagnoses.begin(), next.diagnoses.end());
    report.threads = std::max(report.threads, next.threads);
    report.seconds += next.seconds;
    report.interrupted = report.interrupted || next.interrupted;
  }
  return report;
}

}  // namespace

int check_maps(const CheckMapsOptions& options) {
  refuse_conflicts(options);
  std::error_code none;
  const bool is_folder = std::filesystem::is_directory(options.file, none);
  if (is_folder) refuse_for_folder(options);
  const proofs::InterruptGuard guard;
  JsonOutput json(options.json), sarif_file(options.sarif);
  std::optional<OutputFile> junit, picture;
  if (!options.junit.empty()) junit.emplace(options.junit);
  if (!options.picture.empty()) picture.emplace(options.picture);
  std::FILE* const out = options.sarif == "-" ? stderr : json.text();
  std::vector<SarifNotification> unread;
  std::vector<Checked> all;
  if (is_folder)
    all = checked_folder(options, out, unread);
  else
    all.push_back(checked_file(options, out, picture ? &*picture : nullptr));
  std::vector<SarifResult> findings;
  int worst = complete;
  for (const Checked& checked : all) {
    findings.insert(findings.end(), checked.findings.begin(), checked.findings.end());
    worst = std::max(worst, checked.code);
  }
  sarif_file.write([&] { return sarif(findings, unread); });
  const proofs::Report report = merged(all);
  if (report.results.empty() && worst == failed) return worst;  // rules are broken: no law ran
  if (options.replay.empty()) {
    json.write([&] {
      return to_json(report, options.seed, {}, {}, {}, {}, is_folder ? "" : all.front().cause_json);
    });
    if (junit) junit->commit(to_junit(report));
    if (report.results.empty()) refuse_nothing({});
  }
  return worst;
}

}  // namespace mmverify::cli
