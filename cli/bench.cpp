// mmverify bench: error against run time, by topic.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/index.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output_file.hpp"

namespace mmverify::cli {
namespace {

struct Options {
  std::vector<std::string> topics;
  std::string json;
};

int run_bench(const Options& options) {
  for (const std::string& topic : options.topics)
    if (topic != "index") throw UsageError(fmt::format("no topic is called '{}'; there is index", topic));
  std::optional<OutputFile> file;
  if (!options.json.empty() && options.json != "-") file.emplace(options.json);

  const std::vector<bench::IndexRow> rows = bench::run_index_bench();
  std::FILE* out = options.json == "-" ? stderr : stdout;
  fmt::print(out, "index, 4096 uniform points, one thread\n{:<16} {:>5} {:>12} {:>22}\n", "subject", "level",
             "ns an index", "time / reference-f32");
  nlohmann::ordered_json j{
      {"schema", "mmverify.bench/1"}, {"topic", "index"}, {"rows", nlohmann::ordered_json::array()}};
  for (const bench::IndexRow& row : rows) {
    fmt::print(out, "{:<16} {:>5} {:>12.2f} {:>22.2f}\n", row.name, row.level, row.ns_per_index,
               row.ratio_to_reference_f32);
    j["rows"].push_back({{"subject", row.name},
                         {"level", row.level},
                         {"ns_per_index", row.ns_per_index},
                         {"ratio_to_reference_f32", row.ratio_to_reference_f32}});
  }
  if (file) file->commit(j.dump(1) + "\n");
  if (options.json == "-") fmt::print("{}\n", j.dump(1));
  return ExitCode::complete;
}

}  // namespace

Action add_bench(CLI::App& program) {
  auto* command =
      program.add_subcommand("bench", "error against run time, the fast way beside the obvious one");
  auto options = std::make_shared<Options>();
  command->add_option("topic", options->topics, "topics; all where none is given")->type_name("TOPIC");
  command->add_option("--json", options->json, "write the figures as JSON; - is stdout")->type_name("FILE|-");
  return [options] { return run_bench(*options); };
}

}  // namespace mmverify::cli
