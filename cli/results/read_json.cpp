#include "cli/results/read_json.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/output/exit_code.hpp"
#include "delivery/gate/contradictions.hpp"
#include "delivery/gate/seal.hpp"
#include "proofs/engine/kinds.hpp"
#include "scene/read/json_fault.hpp"
#include "scene/read/unique_names.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;
using Json = nlohmann::ordered_json;

Verdict verdict(const std::string& name) {
  for (const Verdict v : {Verdict::proved, Verdict::refuted, Verdict::checked, Verdict::broken,
                          Verdict::not_applicable, Verdict::incomplete})
    if (to_string(v) == name) return v;
  throw std::runtime_error(fmt::format("no verdict is called '{}'", name));
}

Counterexample counterexample(const Json& j) {
  Counterexample c;
  j.at("rank").get_to(c.simplicity);
  j.at("level").get_to(c.level);
  j.at("case").get_to(c.at);
  c.hex = j.value("hex", "");
  j.at("expected").get_to(c.expected);
  j.at("got").get_to(c.got);
  return c;
}

Result result(const Json& j) {
  Result r;
  j.at("law").get_to(r.law);
  j.at("topic").get_to(r.topic);
  j.at("subject").get_to(r.subject);
  if (!j.at("level").is_null()) j.at("level").get_to(r.level);
  j.at("method").get_to(r.method);
  j.at("domain").get_to(r.domain);
  r.verdict = verdict(j.at("verdict").get<std::string>());
  r.fingerprint = j.value("fingerprint", "");
  r.dialect = j.value("dialect", "");
  r.reason = j.value("reason", "");
  j.at("cases_expected").get_to(r.cases_expected);
  for (std::size_t k = 0; k < kinds; ++k) {
    const Json& kind = j.at("by_kind").at(kind_names[k]);
    kind.at("cases").get_to(r.by_kind[k].cases);
    kind.at("mismatches").get_to(r.by_kind[k].mismatches);
    r.by_kind[k].declined = kind.value("declined", std::uint64_t{0});
    r.by_kind[k].allowed = kind.value("allowed", std::uint64_t{0});
  }
  if (!j.at("counterexample").is_null()) r.counterexamples.push_back(counterexample(j.at("counterexample")));
  if (j.contains("more_counterexamples"))
    for (const Json& c : j.at("more_counterexamples")) r.counterexamples.push_back(counterexample(c));
  r.digest = std::stoull(j.at("digest").get<std::string>(), nullptr, 16);
  j.at("seconds").get_to(r.seconds);
  if (j.contains("share")) {
    const Json& s = j.at("share");
    r.share = Share{s.at("from").get<std::uint64_t>(), s.at("to").get<std::uint64_t>(),
                    s.at("of").get<std::uint64_t>()};
    if (r.share->from > r.share->to || r.share->to > r.share->of)
      throw std::runtime_error(fmt::format("{} level {}: its share is no range", r.law, r.level));
  }
  return r;
}

MutantResult mutant(const Json& j) {
  MutantResult m;
  j.at("law").get_to(m.law);
  j.at("mutant").get_to(m.mutant);
  j.at("killed").get_to(m.killed);
  if (m.killed) {
    j.at("level").get_to(m.level);
    j.at("case").get_to(m.at);
  }
  return m;
}

ShardRun shard_run(const Json& j) {
  if (j.value("schema", "") != "mmverify.result/1")
    throw std::runtime_error("not a result of mmverify prove");
  if (!j.contains("shard")) throw std::runtime_error("not a shard: it was written without --shard");
  ShardRun run;
  const Json& shard = j.at("shard");
  shard.at("number").get_to(run.shard.number);
  shard.at("of").get_to(run.shard.of);
  shard.at("finished").get_to(run.finished);
  run.as_written = gate::is_sealed(j);
  if (run.shard.number < 1 || run.shard.number > run.shard.of)
    throw std::runtime_error(fmt::format("no shard {} of {}", run.shard.number, run.shard.of));
  for (const auto& [name, value] : shard.at("run").items())
    run.identity.emplace_back(name, value.get<std::string>());
  j.at("tool").at("threads").get_to(run.report.threads);
  gate::refuse_contradictions(j);  // else a merge would sum up a false count and call it its own
  for (const Json& r : j.at("results")) run.report.results.push_back(result(r));
  if (j.contains("mutants"))
    for (const Json& m : j.at("mutants")) run.report.mutants.push_back(mutant(m));
  if (j.contains("diagnoses"))
    for (const Json& d : j.at("diagnoses"))
      run.report.diagnoses.push_back({d.at("law").get<std::string>(), d.at("subject").get<std::string>(),
                                      d.at("lines").get<std::vector<std::string>>()});
  return run;
}

}  // namespace

std::string read_text(const std::string& path) {
  // Our own files have megabytes; /dev/zero never ends.
  constexpr std::size_t most = std::size_t{256} << 20, a_time = std::size_t{1} << 20;
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    throw EnvironmentError(fmt::format("{}: cannot be read: a folder", path));
  std::ifstream in(path, std::ios::binary);
  if (!in) throw EnvironmentError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  std::string text;
  while (in && text.size() <= most) {
    const std::size_t before = text.size();
    text.resize(before + a_time);
    in.read(text.data() + before, a_time);
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw EnvironmentError(fmt::format("{}: cannot be read to its end", path));
  if (text.size() > most)
    throw EnvironmentError(fmt::format("{}: more than {} MiB; no result is so long", path, most >> 20));
  return text;
}

Json read_json(const std::string& path) {
  const std::string text = read_text(path);
  try {
    // Readers of the JSON recurse for each level, so the depth is bounded.
    static constexpr int deepest = 64;
    Json json = Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
      if (depth > deepest) throw std::runtime_error(fmt::format("nested more than {} deep", int{deepest}));
      return true;
    });
    if (const auto twice = mmverify::scene::twice_named(text))
      throw std::runtime_error(
          fmt::format("{}: an object has two members of this name; which of them is meant?", *twice));
    return json;
  } catch (const Json::parse_error&) {
    throw EnvironmentError(fmt::format("{}: {}", path, mmverify::scene::json_fault(text)));
  } catch (const std::exception& error) {
    throw EnvironmentError(fmt::format("{}: {}", path, error.what()));
  }
}

ShardRun read_shard(const std::string& path) {
  const Json json = read_json(path);
  try {
    ShardRun run = shard_run(json);
    run.file = path;
    return run;
  } catch (const std::exception& error) {
    throw EnvironmentError(fmt::format("{}: {}", path, error.what()));
  }
}

std::vector<RunsOn> read_runs_on(const std::string& path) {
  const Json json = read_json(path);
  std::vector<RunsOn> all;
  if (!json.contains("runs_on")) return all;
  try {
    for (const Json& j : json.at("runs_on")) {
      RunsOn one{j.at("subject").get<std::string>(), {}, j.at("warnings").get<std::vector<std::string>>()};
      for (const auto& [key, value] : j.at("about").items())
        one.about.emplace_back(key, value.get<std::string>());
      all.push_back(one);
    }
    return all;
  } catch (const std::exception& error) {
    throw EnvironmentError(fmt::format("{}: runs_on: {}", path, error.what()));
  }
}

}  // namespace mmverify::cli
