// The findings of the validator as SARIF.
#include "cli/output/sarif.hpp"

#include "cli/validate/validate.hpp"

namespace mmverify::cli {

using namespace mmverify::scene;

SarifResult sarif_of(const FileViolation& finding, const std::string& file) {
  constexpr const char* levels[] = {"error", "warning", "note"};  // 3.27.10
  const Issue& issue = issue_of(finding.rule);
  const std::string pointer = finding.pointer.empty() ? "/" : finding.pointer;
  const char* const level = levels[static_cast<std::size_t>(issue.severity)];
  return {{std::string(issue.code), issue.says, issue.remedy, issue.source, level},
          file,
          pointer,
          pointer + ": " + finding.found,
          {finding.vuids.begin(), finding.vuids.end()}};
}

std::string findings_sarif(const std::vector<JudgedFile>& files) {
  std::vector<SarifResult> results;
  std::vector<SarifNotification> unread;
  for (const JudgedFile& file : files) {
    if (!file.judged) {
      unread.push_back({file.file, file.unread});
      continue;
    }
    for (const FileViolation& finding : file.judged->findings)
      results.push_back(sarif_of(finding, file.file));
  }
  return sarif(results, unread);
}

}  // namespace mmverify::cli
