#include "cli/output/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/arguments/arguments.hpp"
#include "cli/output/streams.hpp"
#include "cli/validate/validate.hpp"
#include "scene/edit/rules.hpp"
#include "scene/read/bad_scene.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;

struct Totals {
  std::uint64_t errors = 0, warnings = 0, advice = 0;

  void add(const mmverify::scene::Judged& found) {
    errors += found.count(Severity::error);
    warnings += found.count(Severity::warning);
    advice += found.count(Severity::advice);
  }
  /// "0 errors, 1 warning, 0 pieces of advice"
  std::string words() const {
    const auto many = [](std::uint64_t n, const char* one, const char* more) {
      return fmt::format("{} {}", grouped(n), n == 1 ? one : more);
    };
    return many(errors, "error", "errors") + ", " + many(warnings, "warning", "warnings") + ", " +
           many(advice, "piece of advice", "pieces of advice");
  }
};

std::string kind_in_words(const mmverify::scene::Judged& found) {
  std::string words = name_of(found.kind);
  for (const Draft draft : found.drafts) words += fmt::format(", draft {}", text(draft).name);
  return words;
}

/// Prints the end of consecutive findings of one code: their remedy, and their VUIDs, each once.
void print_remedy(std::FILE* out, const Issue& issue, std::vector<std::string_view> vuids) {
  say(out, "         remedy: {}\n", issue.remedy);
  std::vector<std::string_view> once;
  for (const std::string_view vuid : vuids)
    if (std::find(once.begin(), once.end(), vuid) == once.end()) once.push_back(vuid);
  for (const std::string_view vuid : once) say(out, "         {}\n", vuid);
}

}  // namespace

bool repairs_all_rules(const std::string& file, const Target& target) try {
  EditedFile edited(file);
  repair_rules(edited);
  const auto left =
      validate_micromaps([&] { return edited.reopened(edited.written()); }, newest_draft, target);
  return std::none_of(left.begin(), left.end(), [](const FileViolation& finding) {
    return issue_of(finding.rule).severity == Severity::error;
  });
} catch (const BadScene&) {
  return false;
}

void print_repair(std::FILE* out, const std::string& file) {
  say(out, "next: mmverify repair {} -o OUT{}\n", shell_quoted(file),
      file.ends_with(".gltf") ? ".gltf" : ".glb");
}

void print_check(std::FILE* out, const JudgedFile& file) {
  if (!file.judged || file.judged->kind != FileKind::gltf || file.judged->drafts != std::vector{newest_draft})
    return;
  const bool has_maps =
      std::none_of(file.judged->findings.begin(), file.judged->findings.end(),
                   [](const FileViolation& one) { return one.rule == "file.no_micromaps"; });
  if (has_maps && file.judged->count(Severity::error) == 0)
    say(out, "next: mmverify check maps {} judges the maps by their textures\n", shell_quoted(file.file));
}

void print(std::FILE* out, const JudgedFile& file, const Target& target) {
  if (!file.judged) return say(out, "{} (not judged)\n", printable(file.unread));
  const std::vector<FileViolation>& findings = file.judged->findings;
  std::vector<std::string_view> vuids;
  for (std::size_t k = 0; k < findings.size(); ++k) {
    const FileViolation& finding = findings[k];
    const Issue& issue = issue_of(finding.rule);
    say(out, "{:<8} {}  {}: {}\n", name_of(issue.severity), issue.code,
        printable(finding.pointer.empty() ? "/" : finding.pointer), printable(finding.found));
    vuids.insert(vuids.end(), finding.vuids.begin(), finding.vuids.end());
    // Consecutive findings of one code share one remedy.
    if (k + 1 < findings.size() && findings[k + 1].rule == finding.rule) continue;
    print_remedy(out, issue, std::exchange(vuids, {}));
  }
  Totals totals;
  totals.add(*file.judged);
  say(out, "{} ({}): {}\n", printable(file.file), kind_in_words(*file.judged), totals.words());
  const bool is_wrong = file.judged->drafts == std::vector{newest_draft} && totals.errors != 0;
  if (is_wrong && repairs_all_rules(file.file, target)) print_repair(out, file.file);
}

void print_counted_warnings(std::FILE* out, const std::vector<JudgedFile>& files) {
  std::uint64_t warnings = 0;
  for (const JudgedFile& file : files)
    if (file.judged) warnings += file.judged->count(Severity::warning);
  if (warnings != 0)
    say(out, "--warnings-as-errors: {} warning{} count{} as error{}\n", grouped(warnings),
        warnings == 1 ? "" : "s", warnings == 1 ? "s" : "", warnings == 1 ? "" : "s");
}

void print_totals(std::FILE* out, const std::vector<JudgedFile>& files) {
  Totals totals;
  std::size_t with_errors = 0, unread = 0;
  for (const JudgedFile& file : files)
    if (file.judged) {
      totals.add(*file.judged);
      if (file.judged->count(Severity::error) != 0) ++with_errors;
    } else {
      ++unread;
    }
  say(out, "{} file{}: {} without errors, {} with errors, {} not judged; {}\n", grouped(files.size()),
      files.size() == 1 ? "" : "s", grouped(files.size() - with_errors - unread), grouped(with_errors),
      grouped(unread), totals.words());
}

}  // namespace mmverify::cli
