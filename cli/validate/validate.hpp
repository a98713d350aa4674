// mmverify validate: its options, the judged files, and their forms.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "cli/output/sarif.hpp"
#include "scene/validate/file.hpp"

namespace mmverify::cli {

struct ValidateOptions {
  std::vector<std::string> files;  ///< files, and folders with files
  std::string json, sarif, draft, limits;
  std::vector<std::string> apis;
  bool warnings_as_errors = false;  ///< a warning ends the command with exit code 1
};

/// A file that was named or found, and its findings.
struct JudgedFile {
  std::string file;
  std::optional<mmverify::scene::Judged> judged;  ///< none if it could not be judged
  std::string unread;                             ///< the reason, a line that begins with the file's name
};

/// Judges the files; prints the findings, writes JSON and SARIF; the exit code, of several files the worst.
/// Errors: UsageError, EnvironmentError.
int validate(const ValidateOptions& options);

/// Prints findings with remedies and VUIDs, then the file's line, and the command that may put it right.
void print(std::FILE* out, const JudgedFile& file, const mmverify::scene::Target& target);

/// Prints the command that judges the maps of a glTF file without errors.
void print_check(std::FILE* out, const JudgedFile& file);

/// Prints the command that may put a file's broken rules right.
void print_repair(std::FILE* out, const std::string& file);

/// Whether repair leaves no error of a glTF file; its maps have to be judged then.
bool repairs_all_rules(const std::string& file, const mmverify::scene::Target& target);

/// Prints how many warnings --warnings-as-errors counts as errors; nothing where there are none.
void print_counted_warnings(std::FILE* out, const std::vector<JudgedFile>& files);

/// Prints the totals of several files.
void print_totals(std::FILE* out, const std::vector<JudgedFile>& files);

/// docs/validate.schema.json; of several files a list.
std::string findings_json(const ValidateOptions& options, const std::vector<JudgedFile>& files, bool is_list);

/// A finding as a result of SARIF.
SarifResult sarif_of(const mmverify::scene::FileViolation& finding, const std::string& file);

/// SARIF 2.1.0 (OASIS): a run with a result for each finding, whose logical location is the finding's pointer.
std::string findings_sarif(const std::vector<JudgedFile>& files);

}  // namespace mmverify::cli
