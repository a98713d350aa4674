#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/output/exit_code.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/output_file.hpp"
#include "cli/validate/validate.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/validate/folder.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;

Target target_of(const ValidateOptions& options) {
  constexpr std::array<std::pair<const char*, impl::micromap::Sets>, 3> known{
      {{"ext", impl::micromap::EXT}, {"khr", impl::micromap::KHR}, {"dxr", impl::micromap::DXR}}};
  Target target;
  for (const auto& [name, set] : known)
    if (std::find(options.apis.begin(), options.apis.end(), name) != options.apis.end())
      target.apis = static_cast<impl::micromap::Sets>(target.apis | set);
  if (!options.limits.empty()) target.device = read_device(options.limits);
  return target;
}

/// The named files, and those of the named folders, each once.
std::vector<std::string> files_of(const ValidateOptions& options) {
  std::vector<std::string> files;
  for (const std::string& named : options.files) {
    std::error_code error;
    if (!std::filesystem::is_directory(named, error)) {
      files.push_back(named);
      continue;
    }
    const std::vector<std::string> found = micromap_files(named);
    files.insert(files.end(), found.begin(), found.end());
  }
  std::vector<std::string> once;
  for (std::string& file : files)
    if (std::find(once.begin(), once.end(), file) == once.end()) once.push_back(std::move(file));
  return once;
}

/// Refuses outputs that a judged file is, or that it names.
void refuse_inputs(const std::vector<std::string>& files, const ValidateOptions& options) {
  const std::array outputs{NamedPath{"--json", options.json}, NamedPath{"--sarif", options.sarif}};
  refuse_same_file({outputs[0], outputs[1], {"--limits", options.limits}});
  const auto refuse = [&](const std::string& path, const char* what) {
    std::error_code none;
    for (const auto& [option, output] : outputs)
      if (!output.empty() && std::filesystem::equivalent(path, output, none))
        throw UsageError(fmt::format("{} {}: this is {}; name another", option, output, what));
  };
  if (options.json.empty() && options.sarif.empty()) return;
  for (const std::string& file : files) {
    refuse(file, "the file that is judged");
    for (const std::string& part : files_named_by(file)) refuse(part, "a file that the judged one names");
  }
}

JudgedFile judged(const std::string& file, std::optional<Draft> draft, const Target& target) try {
  return {file, validate_file(file, draft, target), ""};
} catch (const BadScene& bad) {
  return {file, {}, bad.what()};
} catch (const std::bad_alloc&) {
  return {file, {}, file + ": there is not enough memory to judge it"};
}

int exit_code_of(const JudgedFile& file, bool warnings_as_errors) {
  if (!file.judged) return ExitCode::environment;
  const std::uint64_t warnings = warnings_as_errors ? file.judged->count(Severity::warning) : 0;
  return file.judged->count(Severity::error) + warnings == 0 ? ExitCode::complete : ExitCode::failed;
}

/// A single file that cannot be judged ends the command.
void refuse_unjudged(const JudgedFile& only, const ValidateOptions& options) {
  if (!only.judged) throw EnvironmentError(only.unread);
  if (!options.draft.empty() && only.judged->kind != FileKind::gltf)
    throw UsageError(fmt::format("--draft {}: {} is no glTF; leave --draft out", options.draft, only.file));
}

}  // namespace

int validate(const ValidateOptions& options) {
  if (options.json == "-" && options.sarif == "-")
    throw UsageError("--json and --sarif: one standard output for both");
  const Target target = target_of(options);
  const std::vector<std::string> files = files_of(options);
  const bool several = files.size() != 1 || files[0] != options.files[0];
  refuse_inputs(files, options);
  JsonOutput json(options.json), sarif(options.sarif);
  std::FILE* const out = options.json == "-" || options.sarif == "-" ? stderr : stdout;
  std::vector<JudgedFile> all;
  int worst = ExitCode::complete;
  for (const std::string& file : files) {
    all.push_back(judged(file, draft_named(options.draft), target));
    if (!several) refuse_unjudged(all.back(), options);
    print(out, all.back(), target);
    worst = std::max(worst, exit_code_of(all.back(), options.warnings_as_errors));
  }
  if (several)
    print_totals(out, all);
  else
    print_check(out, all.back());
  if (options.warnings_as_errors) print_counted_warnings(out, all);
  json.write([&] { return findings_json(options, all, several); });
  sarif.write([&] { return findings_sarif(all); });
  return worst;
}

}  // namespace mmverify::cli
