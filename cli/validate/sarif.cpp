// SARIF 2.1.0.  Source: OASIS, Static Analysis Results Interchange Format; its sections stand beside what follows them.
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/build_info.hpp"
#include "cli/output/json_text.hpp"
#include "cli/validate/validate.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using OrderedJson = nlohmann::ordered_json;

/// The level of a severity (3.27.10).
const char* level_of(Severity severity) {
  constexpr const char* levels[] = {"error", "warning", "note"};
  return levels[static_cast<std::size_t>(severity)];
}

/// A path as a URI reference (3.4.4): bytes beside the unreserved ones and / are percent-encoded; an absolute path has
/// its scheme.
std::string uri_of(const std::string& path) {
  constexpr char hex[] = "0123456789ABCDEF";
  constexpr std::string_view plain = "-._~/";
  const std::string generic = std::filesystem::path(path).generic_string();
  std::string uri = generic.starts_with('/') ? "file://" : "";
  for (const char c : generic) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
    if (letter || (byte >= '0' && byte <= '9') || plain.find(c) != plain.npos)
      uri += c;
    else
      uri += {'%', hex[byte >> 4], hex[byte & 15]};
  }
  return uri;
}

OrderedJson location_of(const std::string& file) {
  return {{"physicalLocation", {{"artifactLocation", {{"uri", uri_of(file)}}}}}};
}

/// A rule (3.49), of each code that occurs.
OrderedJson rule_of(const Issue& issue) {
  return {{"id", std::string(issue.code)},
          {"shortDescription", {{"text", issue.says}}},
          {"help", {{"text", issue.remedy}}},
          {"defaultConfiguration", {{"level", level_of(issue.severity)}}},
          {"properties", {{"source", issue.source}}}};
}

/// A result (3.27).
OrderedJson result_of(const FileViolation& finding, const std::string& file, std::size_t rule) {
  const Issue& issue = issue_of(finding.rule);
  OrderedJson location = location_of(file);
  const std::string pointer = finding.pointer.empty() ? "/" : finding.pointer;
  location["logicalLocations"] = OrderedJson::array({{{"fullyQualifiedName", pointer}}});
  OrderedJson result{{"ruleId", std::string(issue.code)},
                     {"ruleIndex", rule},
                     {"level", level_of(issue.severity)},
                     {"message", {{"text", pointer + ": " + finding.found}}},
                     {"locations", OrderedJson::array({location})}};
  if (finding.vuids.empty()) return result;
  result["properties"] = {{"vuids", OrderedJson::array()}};
  for (const std::string_view vuid : finding.vuids)
    result["properties"]["vuids"].push_back(std::string(vuid));
  return result;
}

}  // namespace

std::string findings_sarif(const std::vector<JudgedFile>& files) {
  OrderedJson rules = OrderedJson::array(), results = OrderedJson::array(),
              notifications = OrderedJson::array();
  std::map<std::string_view, std::size_t> numbers;
  for (const JudgedFile& file : files) {
    if (!file.judged) {
      // 3.58: a file that could not be judged.
      notifications.push_back({{"level", "error"},
                               {"message", {{"text", file.unread}}},
                               {"locations", OrderedJson::array({location_of(file.file)})}});
      continue;
    }
    for (const FileViolation& finding : file.judged->findings) {
      const Issue& issue = issue_of(finding.rule);
      const auto [number, is_new] = numbers.try_emplace(issue.code, numbers.size());
      if (is_new) rules.push_back(rule_of(issue));
      results.push_back(result_of(finding, file.file, number->second));
    }
  }
  const OrderedJson invocation{{"executionSuccessful", notifications.empty()},
                               {"toolExecutionNotifications", notifications}};
  const OrderedJson run{
      {"tool", {{"driver", {{"name", "mmverify"}, {"semanticVersion", build::version}, {"rules", rules}}}}},
      {"invocations", OrderedJson::array({invocation})},
      {"results", results}};
  return json_text({{"$schema",
                     "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/"
                     "sarif-schema-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", OrderedJson::array({run})}});
}

}  // namespace mmverify::cli
