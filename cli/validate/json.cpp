#include <nlohmann/json.hpp>

#include "cli/output/json_text.hpp"
#include "cli/tool.hpp"
#include "cli/validate/validate.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using OrderedJson = nlohmann::ordered_json;

OrderedJson null_or(const std::string& text) {
  return text.empty() ? OrderedJson(nullptr) : OrderedJson(text);
}

OrderedJson json_of(const FileViolation& finding) {
  const Issue& issue = issue_of(finding.rule);
  OrderedJson j{{"code", std::string(issue.code)},
                {"severity", name_of(issue.severity)},
                {"pointer", finding.pointer},
                {"found", finding.found},
                {"says", issue.says},
                {"source", issue.source},
                {"vuids", OrderedJson::array()},
                {"remedy", issue.remedy}};
  for (const std::string_view vuid : finding.vuids) j["vuids"].push_back(std::string(vuid));
  return j;
}

OrderedJson json_of(const ValidateOptions& options, const JudgedFile& file) {
  const auto count = [&](Severity severity) { return file.judged ? file.judged->count(severity) : 0; };
  OrderedJson apis = OrderedJson::array();
  for (const std::string& api : options.apis) apis.push_back(api);
  OrderedJson j{{"schema", "mmverify.validate/1"},
                {"tool", tool({{"draft", null_or(options.draft)}, {"apis", apis}})},
                {"file", file.file},
                {"kind", file.judged ? name_of(file.judged->kind) : "unread"},
                {"unread", null_or(file.unread)},
                {"drafts", OrderedJson::array()},
                {"findings", OrderedJson::array()},
                {"errors", count(Severity::error)},
                {"warnings", count(Severity::warning)},
                {"advice", count(Severity::advice)}};
  if (!file.judged) return j;
  for (const Draft draft : file.judged->drafts) j["drafts"].push_back(text(draft).name);
  for (const FileViolation& finding : file.judged->findings) j["findings"].push_back(json_of(finding));
  return j;
}

}  // namespace

std::string findings_json(const ValidateOptions& options, const std::vector<JudgedFile>& files,
                          bool is_list) {
  if (!is_list) return json_text(json_of(options, files.at(0)));
  OrderedJson all = OrderedJson::array();
  for (const JudgedFile& file : files) all.push_back(json_of(options, file));
  return json_text(all);
}

}  // namespace mmverify::cli
