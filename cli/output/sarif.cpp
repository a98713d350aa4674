// SARIF 2.1.0.  Source: OASIS, Static Analysis Results Interchange Format; its sections stand beside what follows them.
#include "cli/output/sarif.hpp"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/build_info.hpp"
#include "cli/output/json_text.hpp"

namespace mmverify::cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

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

OrderedJson sarif_location_of(const std::string& file) {
  return {{"physicalLocation", {{"artifactLocation", {{"uri", uri_of(file)}}}}}};
}

OrderedJson sarif_rule_json(const SarifRule& rule) {
  return {{"id", rule.id},
          {"shortDescription", {{"text", rule.says}}},
          {"help", {{"text", rule.help}}},
          {"defaultConfiguration", {{"level", rule.level}}},
          {"properties", {{"source", rule.source}}}};
}

OrderedJson sarif_result_json(const SarifResult& given, std::size_t rule) {
  OrderedJson location = sarif_location_of(given.file);
  location["logicalLocations"] = OrderedJson::array({{{"fullyQualifiedName", given.place}}});
  OrderedJson result{{"ruleId", given.rule.id},
                     {"ruleIndex", rule},
                     {"level", given.rule.level},
                     {"message", {{"text", given.message}}},
                     {"locations", OrderedJson::array({location})}};
  if (!given.vuids.empty()) result["properties"] = {{"vuids", given.vuids}};
  return result;
}

}  // namespace

std::string sarif(const std::vector<SarifResult>& results,
                  const std::vector<SarifNotification>& notifications) {
  OrderedJson rules = OrderedJson::array(), all = OrderedJson::array(), unread = OrderedJson::array();
  for (const SarifNotification& n : notifications)
    unread.push_back({{"level", "error"},
                      {"message", {{"text", n.message}}},
                      {"locations", OrderedJson::array({sarif_location_of(n.file)})}});
  std::map<std::string, std::size_t> numbers;
  for (const SarifResult& result : results) {
    const auto [number, is_new] = numbers.try_emplace(result.rule.id, numbers.size());
    if (is_new) rules.push_back(sarif_rule_json(result.rule));
    all.push_back(sarif_result_json(result, number->second));
  }
  const OrderedJson invocation{{"executionSuccessful", unread.empty()},
                               {"toolExecutionNotifications", unread}};
  const OrderedJson run{
      {"tool", {{"driver", {{"name", "mmverify"}, {"semanticVersion", build::version}, {"rules", rules}}}}},
      {"invocations", OrderedJson::array({invocation})},
      {"results", all}};
  return json_text({{"$schema",
                     "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/"
                     "sarif-schema-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", OrderedJson::array({run})}});
}

}  // namespace mmverify::cli
