// mmverify validate: lists the faults of a file of micromaps.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/json_output.hpp"
#include "cli/json_text.hpp"
#include "cli/output_file.hpp"
#include "cli/streams.hpp"
#include "cli/text.hpp"
#include "cli/tool.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/validate/file.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;

using OrderedJson = nlohmann::ordered_json;

struct ValidateOptions {
  std::string file, json, draft;
  std::optional<Draft> forced() const { return draft_named(draft); }
};

/// The totals in words: "0 errors, 1 warning, 0 pieces of advice".
std::string totals(const Judged& found) {
  const auto many = [](std::uint64_t n, const char* one, const char* more) {
    return fmt::format("{} {}", grouped(n), n == 1 ? one : more);
  };
  return many(found.count(Severity::error), "error", "errors") + ", " +
         many(found.count(Severity::warning), "warning", "warnings") + ", " +
         many(found.count(Severity::advice), "piece of advice", "pieces of advice");
}

std::string kind_in_words(const Judged& found) {
  std::string words = name_of(found.kind);
  for (const Draft draft : found.drafts) words += fmt::format(", draft {}", text(draft).name);
  return words;
}

void print(std::FILE* out, const std::string& file, const Judged& found) {
  for (std::size_t k = 0; k < found.findings.size(); ++k) {
    const FileViolation& finding = found.findings[k];
    const Issue& issue = issue_of(finding.rule);
    say(out, "{:<8} {}  {}: {}\n", name_of(issue.severity), issue.code,
        printable(finding.pointer.empty() ? "/" : finding.pointer), printable(finding.found));
    // Consecutive findings of one code share one remedy.
    if (k + 1 == found.findings.size() || found.findings[k + 1].rule != finding.rule)
      say(out, "         remedy: {}\n", issue.remedy);
  }
  say(out, "{} ({}): {}\n", printable(file), kind_in_words(found), totals(found));
}

std::string findings_json(const ValidateOptions& options, const Judged& found) {
  OrderedJson j{
      {"schema", "mmverify.validate/1"},
      {"tool", tool({{"draft", options.draft.empty() ? OrderedJson(nullptr) : OrderedJson(options.draft)}})},
      {"file", options.file},
      {"kind", name_of(found.kind)},
      {"drafts", OrderedJson::array()},
      {"findings", OrderedJson::array()},
      {"errors", found.count(Severity::error)},
      {"warnings", found.count(Severity::warning)},
      {"advice", found.count(Severity::advice)}};
  for (const Draft draft : found.drafts) j["drafts"].push_back(text(draft).name);
  for (const FileViolation& finding : found.findings) {
    const Issue& issue = issue_of(finding.rule);
    j["findings"].push_back({{"code", std::string(issue.code)},
                             {"severity", name_of(issue.severity)},
                             {"pointer", finding.pointer},
                             {"found", finding.found},
                             {"says", issue.says},
                             {"source", issue.source},
                             {"remedy", issue.remedy}});
  }
  return json_text(j);
}

Judged judged(const ValidateOptions& options) try {
  return validate_file(options.file, options.forced());
} catch (const std::bad_alloc&) {
  throw EnvironmentError(options.file + ": there is not enough memory to judge it");
}

int run_validate(const ValidateOptions& options) {
  std::error_code none;
  if (std::filesystem::equivalent(options.file, options.json, none))
    throw UsageError(fmt::format("--json {}: this is the file that is judged; name another", options.json));
  JsonOutput json(options.json);
  const Judged found = judged(options);
  if (options.forced() && found.kind != FileKind::gltf)
    throw UsageError(
        fmt::format("--draft {}: {} is no glTF; leave --draft out", options.draft, options.file));
  print(json.text(), options.file, found);
  json.write([&] { return findings_json(options, found); });
  return found.count(Severity::error) == 0 ? ExitCode::complete : ExitCode::failed;
}

}  // namespace

Action add_validate(CLI::App& program) {
  auto* command =
      program.add_subcommand("validate", "what is wrong with a file of micromaps, and what to do about it");
  command->footer(
      "The kind is told by content: glTF with opacity micromaps, the JSON sidecar of a raw array "
      "(docs/VALIDATE.md),\n"
      "or one of the library's containers. Exit code 1 where there is an error; docs/ISSUES.md lists all "
      "codes.");
  auto options = std::make_shared<ValidateOptions>();
  command->add_option("file", options->file, "the file")->type_name("FILE")->required();
  command
      ->add_option(
          "--draft", options->draft,
          "glTF: the draft whose rules are asked; where not given, khr for KHR's name, ext-2 for EXT's")
      ->check(CLI::IsMember({"khr", "ext-1", "ext-2"}));
  command->add_option("--json", options->json, "write the findings as JSON; - is stdout")
      ->type_name("FILE|-");
  return [options] { return run_validate(*options); };
}

}  // namespace mmverify::cli
