// Findings in files as SARIF 2.1.0, for the systems that show them beside the files.
#pragma once

#include <string>
#include <vector>

namespace mmverify::cli {

/// A rule (3.49).
struct SarifRule {
  std::string id, says, help, source;
  const char* level = "error";  ///< or "warning", "note"
};

/// A result (3.27): `rule` was broken at `place` in `file`.
struct SarifResult {
  SarifRule rule;
  std::string file;
  std::string place;  ///< its logical location: a pointer of JSON, or a case
  std::string message;
  std::vector<std::string> vuids = {};
};

/// A file that could not be judged (3.58).
struct SarifNotification {
  std::string file, message;
};

/// A run of this program.  A rule is listed once, by its id.
/// Source: OASIS, Static Analysis Results Interchange Format.
std::string sarif(const std::vector<SarifResult>& results,
                  const std::vector<SarifNotification>& notifications);

}  // namespace mmverify::cli
