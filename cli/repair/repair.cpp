#include "cli/repair/repair.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "cli/output/exit_code.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/repair/output.hpp"
#include "cli/scene/loaded.hpp"
#include "proofs/engine/interrupt.hpp"
#include "scene/edit/edited_file.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/validate/micromaps.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using proofs::scene::FileRepair;
using proofs::scene::RepairReport;

/// Errors: EnvironmentError for a file that is missing, or cannot be read to its end.
void need_whole(const std::string& file) try { EditedFile{file}; } catch (const BadScene& bad) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw;
  const std::string what = bad.what();
  throw EnvironmentError(fmt::format("{}{} repair needs a file that can be read: copy or export it again",
                                     what, what.ends_with('?') ? "" : ";"));
}

/// Errors: UsageError where no primitive has a micromap.
void need_micromaps(const std::string& file) {
  const NamesUsed names = names_used(file);
  if (names.ext) return;
  throw UsageError(fmt::format("{}: no primitive has a micromap{}", file,
                               names.khr ? " of EXT_mesh_opacity_micromap; KHR's are not repaired" : ""));
}

const char* remedy(const RepairReport& report) {
  return report.broken.empty() ? "--bake bakes these maps anew"
                               : "mmverify scene FILE -o OUT bakes all maps anew";
}

/// Commits the repaired file, if it is right; the exit code.
int finished(const RepairOptions& options, FileRepair& repair, RepairOutput& output, std::FILE* out) {
  const RepairReport& report = repair.report();
  if (!report.is_whole()) {
    say(out, "not repaired: {}; nothing was written\n", remedy(report));
    return failed;
  }
  if (repair.file().is_changed()) output.rename_buffers(repair.file());
  WrittenFile written{repair.file().original(), {}};
  if (repair.file().is_changed()) written = repair.file().written();
  if (const std::string wrong = repair.broken_law(written); !wrong.empty()) {
    say(out, "not repaired: the result would not pass check maps: {}; nothing was written\n",
        printable(wrong));
    return failed;
  }
  if (proofs::interrupted()) throw proofs::Interrupted();
  output.commit(repair.file(), written);
  if (report.is_right() && repair.file().is_changed())
    say(out, "{}: its maps are right already; {} has the records of its bake anew\n", printable(options.file),
        printable(options.output));
  else if (report.is_right())
    say(out, "{}: right already; {} is a copy\n", printable(options.file), printable(options.output));
  else
    say(out, "{}: written; validate and check maps pass\n", printable(options.output));
  return complete;
}

}  // namespace

int repair(const RepairOptions& options) try {
  refuse_same_file({{"FILE", options.file}, {"-o", options.output}, {"--json", options.json}});
  const proofs::InterruptGuard guard;
  need_whole(options.file);
  RepairOutput output(options.file, options.output);
  JsonOutput json(options.json);
  std::FILE* const out = json.text();
  FileRepair repair(options.file, options.request);
  need_micromaps(options.file);
  refuse_files_of(options.file, {{"--json", options.json}});
  repair.run();
  const RepairReport& report = repair.report();
  if (report.is_right() && report.judged.empty())
    throw UsageError(
        fmt::format("{}: no map can be judged: {}", options.file,
                    report.not_judged.empty() ? "no triangle has one" : sentence(report.not_judged[0].why)));
  if (!report.is_right() || !report.not_judged.empty()) say(out, "{}\n", printable(options.file));
  print_repairs(out, options, repair.scene(), report);
  std::fflush(out);
  const int code = finished(options, repair, output, out);
  json.write([&] { return repairs_json(options, repair.scene(), repair.report()); });
  return code;
} catch (const std::bad_alloc&) {
  throw EnvironmentError(options.file + ": there is not enough memory to repair it");
}

}  // namespace mmverify::cli
