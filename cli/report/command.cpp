// mmverify report: writes results as one page that opens from disk.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json_text.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/report/again.hpp"
#include "cli/report/input.hpp"
#include "cli/report/pictures.hpp"
#include "display/report/page.hpp"

namespace mmverify::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ReportOptions {
  std::vector<std::string> results;
  std::string out;
};

/// JSON for a script element: without a "<", no text can end the element.
std::string within_script(const Json& data) {
  std::string text;
  for (const char c : json_text(data, -1)) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

int report(const ReportOptions& options) {
  if (options.out == "-") throw UsageError("-o -: a page is a file; name it");
  std::error_code none;
  for (const std::string& path : options.results)
    if (std::filesystem::equivalent(path, options.out, none))
      throw UsageError(fmt::format("-o {}: this is one of the results; name another file", options.out));
  const std::string_view page = mmverify::report::page();
  if (page.empty())
    throw EnvironmentError(
        fmt::format("report: this program was built without its page: {}", mmverify::report::why_no_page()));
  std::vector<ReportInput> inputs;
  for (const std::string& path : options.results)
    for (ReportInput& input : read_report_input(path)) inputs.push_back(std::move(input));
  OutputFile out(options.out);

  Json data{{"schema", "mmverify.report/1"},
            {"tool",
             {{"version", build::version},
              {"compiler", build::compiler},
              {"spec_hash", build::spec_hash},
              {"source_hash", build::source_hash}}},
            {"files", Json::array()}};
  data.update(asked_again(inputs));
  data.update(pictures_of(inputs));
  for (ReportInput& input : inputs)
    data["files"].push_back({{"name", input.name}, {"content", std::move(input.content)}});

  constexpr std::string_view place = "{data}";
  const std::size_t at = page.find(place);
  if (at == std::string_view::npos) throw std::logic_error("the page has no place for data");
  out.commit(fmt::format("{}{}{}", page.substr(0, at), within_script(data), page.substr(at + place.size())));
  say(stdout, "{}: {} of {} file{}\n", options.out, options.results.size() == 1 ? "a page" : "one page",
      options.results.size(), options.results.size() == 1 ? "" : "s");
  return ExitCode::complete;
}

}  // namespace

Action add_report(CLI::App& program) {
  auto* command = program.add_subcommand(
      "report",
      "one page of what prove, scene, render and bench found, which opens from disk and needs no network");
  auto options = std::make_shared<ReportOptions>();
  command->add_option("result", options->results, "what prove, scene or bench wrote with --json")
      ->type_name("RESULT.json")
      ->required();
  command->add_option("-o,--output", options->out, "where the page goes")->type_name("FILE.html")->required();
  return [options] { return report(*options); };
}

}  // namespace mmverify::cli
