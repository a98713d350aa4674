// The text of a run: the short answer, or with --details each result as it comes.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "cli/output/text.hpp"

namespace CLI {
class App;
}

namespace mmverify::cli {

/// Adds --details, or --verbose.
void add_details(CLI::App& command, bool& details);

class RunText {
 public:
  /// by_level: whether the details have a line for each level. subjects: those that were named.
  RunText(std::FILE* out, bool details, bool by_level, std::vector<proofs::SubjectPtr> subjects = {})
      : out_(out), details_(details), whole_(out, by_level), subjects_(std::move(subjects)) {}
  /// A line before the results, in both forms.
  void note(const std::string& line);
  /// A line before the results that the short answer leaves out.
  void detail(const std::string& line);
  void add(const proofs::Result& result);
  /// Prints the rest. name_subjects: whether the details end with each subject's verdict. last: lines that bound
  /// the verdict.
  void finish(const proofs::Report& report, bool name_subjects, const std::vector<std::string>& last = {});

 private:
  std::FILE* out_;
  bool details_;
  TextReport whole_;
  std::vector<proofs::SubjectPtr> subjects_;
  std::vector<std::string> notes_;
};

}  // namespace mmverify::cli
