// mmverify merge: combines the shards of one run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/text.hpp"
#include "cli/prove/run_identity.hpp"
#include "cli/results/read_json.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

struct MergeOptions {
  std::vector<std::string> shards;
  std::string out;
};

std::uint64_t number_in(const ShardRun& shard, const std::string& item) {
  for (const auto& [name, value] : shard.identity)
    if (name == item && !value.empty() && value.size() < 20 &&
        value.find_first_not_of("0123456789") == std::string::npos)
      return std::stoull(value);
  throw EnvironmentError(fmt::format("{}: its run names no {}", shard.file, item));
}

/// Throws EnvironmentError if another program made the shard: the merged result will name this program.
void check_program(const ShardRun& shard) {
  for (const auto& [name, value] : program_identity())
    if (std::find(shard.identity.begin(), shard.identity.end(), std::pair(name, value)) ==
        shard.identity.end())
      throw EnvironmentError(fmt::format(
          "{}: another build of mmverify made it: its {} differs; merge with that build", shard.file, name));
}

/// All shards must have run on the same device and driver, since a verdict holds for one of each.
void check_places(const std::string& file, const std::vector<RunsOn>& here, const std::string& first_file,
                  const std::vector<RunsOn>& first) {
  for (const RunsOn& one : first) {
    const auto same =
        std::find_if(here.begin(), here.end(), [&](const RunsOn& o) { return o.subject == one.subject; });
    if (same == here.end())
      throw EnvironmentError(
          fmt::format("{}: does not say where {} ran, as {} does", file, one.subject, first_file));
    for (const auto& [key, value] : one.about) {
      std::string other;
      for (const auto& [its_key, its_value] : same->about)
        if (its_key == key) other = its_value;
      if (other != value)
        throw EnvironmentError(
            fmt::format("{}: {} ran elsewhere: {}: '{}' here, '{}' in {}; run all shards in one place", file,
                        one.subject, key, other, value, first_file));
    }
  }
  if (here.size() > first.size())
    throw EnvironmentError(fmt::format("{}: says where {} subjects ran, and {} where {}", file, here.size(),
                                       first_file, first.size()));
}

/// The first shard whose file was changed after it was written.
std::optional<std::string> first_changed(const std::vector<ShardRun>& shards) {
  for (const ShardRun& shard : shards)
    if (!shard.as_written) return shard.file;
  return std::nullopt;
}

/// Compares shards with each other. A changed shard is blamed for every difference, even if the message names
/// another shard; a message about the changed shard itself stays, since it says more.
template <class Compare>
auto of_shards_as_written(const std::optional<std::string>& changed, Compare compare) {
  const auto blame = [&](const std::string& what) {
    return changed && !what.starts_with(*changed + ": ")
               ? fmt::format(
                     "{}: its seal does not fit its contents, so it was edited; take the file that mmverify "
                     "wrote",
                     *changed)
               : what;
  };
  try {
    return compare();
  } catch (const EnvironmentError& why) {
    throw EnvironmentError(blame(why.what()));
  } catch (const ShardsDoNotAddUp& why) {
    throw EnvironmentError(blame(why.what()));
  }
}

int merge(const MergeOptions& options) {
  std::vector<ShardRun> shards;
  std::vector<std::vector<RunsOn>> places;
  std::error_code none;
  for (const std::string& path : options.shards) {
    if (std::filesystem::equivalent(path, options.out, none))
      throw UsageError(fmt::format("-o {}: this is one of the shards; name another file", options.out));
    shards.push_back(read_shard(path));
    check_program(shards.back());
    places.push_back(read_runs_on(path));
  }
  const std::vector<RunsOn>& runs_on = places.front();
  const std::uint64_t seed = number_in(shards.front(), "seed"), errors = number_in(shards.front(), "errors");
  const auto changed = first_changed(shards);
  const Report report = of_shards_as_written(changed, [&] {
    for (std::size_t k = 1; k < shards.size(); ++k)
      check_places(shards[k].file, places[k], shards.front().file, runs_on);
    Report sum = merge_shards(shards, errors, [](const std::string& id) -> const Law& {
      const Law* law = find_law(id);
      if (law == nullptr) throw ShardsDoNotAddUp(fmt::format("no law is called '{}'", id));
      return *law;
    });
    if (changed) throw ShardsDoNotAddUp("");
    return sum;
  });
  OutputFile out(options.out);
  TextReport text(stdout, true);
  for (const RunsOn& one : runs_on) {
    for (const auto& [key, value] : one.about) text.note(fmt::format("{}: {}: {}", one.subject, key, value));
    for (const std::string& warning : one.warnings) text.note("warning: " + warning);
  }
  for (const Result& r : report.results) text.add(r);
  text.finish(report, false);
  refuse_nothing(report);
  out.commit(to_json(report, seed, {}, {}, {}, runs_on));
  return exit_code(report);
}

}  // namespace

Action add_merge(CLI::App& program) {
  auto* command = program.add_subcommand("merge", "put the results of all shards of a run together");
  auto options = std::make_shared<MergeOptions>();
  command->add_option("shard", options->shards, "what prove --shard K/N --json wrote, for each K from 1 to N")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", options->out, "where the result of the whole run goes")
      ->type_name("FILE")
      ->required();
  return [options] { return merge(*options); };
}

}  // namespace mmverify::cli
