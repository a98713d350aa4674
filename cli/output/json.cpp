#include "cli/output/json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/build_info.hpp"
#include "cli/output/json_text.hpp"
#include "cli/output/text.hpp"
#include "cli/tool.hpp"
#include "delivery/gate/seal.hpp"
#include "proofs/engine/kinds.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;
using Json = nlohmann::ordered_json;

Json counterexample(const Result& r, const Counterexample& c) {
  Json j{{"case", c.at}, {"level", c.level}, {"rank", c.simplicity}};
  if (!c.hex.empty()) j["hex"] = c.hex;
  j["expected"] = c.expected;
  j["got"] = c.got;
  j["replay"] = replay_command(r, c);
  return j;
}

Json result(const Result& r) {
  Json by_kind;
  for (std::size_t k = 0; k < kinds; ++k) {
    by_kind[kind_names[k]] = {{"cases", r.by_kind[k].cases}, {"mismatches", r.by_kind[k].mismatches}};
    if (r.by_kind[k].declined != 0) by_kind[kind_names[k]]["declined"] = r.by_kind[k].declined;
    if (r.by_kind[k].allowed != 0) by_kind[kind_names[k]]["allowed"] = r.by_kind[k].allowed;
  }
  Json j{{"law", r.law},       {"topic", r.topic},   {"subject", r.subject},           {"level", r.level},
         {"method", r.method}, {"domain", r.domain}, {"verdict", to_string(r.verdict)}};
  if (!r.at_once.empty()) j["level"] = nullptr;
  if (!r.fingerprint.empty()) j["fingerprint"] = r.fingerprint;
  if (!r.dialect.empty()) j["dialect"] = r.dialect;
  if (!r.reason.empty()) j["reason"] = r.reason;
  if (!r.breaks.empty()) {
    constexpr std::size_t shown = 5;
    j["cases_broken"] = r.breaks.size();
    j["breaks"] = std::vector(
        r.breaks.begin(), r.breaks.begin() + static_cast<std::ptrdiff_t>(std::min(shown, r.breaks.size())));
  }
  j["cases_expected"] = r.cases_expected;
  j["cases_run"] = r.cases_run();
  if (r.resumed != 0) j["cases_resumed"] = r.resumed;
  if (r.share) j["share"] = {{"from", r.share->from}, {"to", r.share->to}, {"of", r.share->of}};
  j["mismatches"] = r.mismatches();
  j["by_kind"] = by_kind;
  j["counterexample"] =
      r.counterexamples.empty() ? Json(nullptr) : counterexample(r, r.counterexamples.front());
  if (r.counterexamples.size() > 1) {
    for (std::size_t k = 1; k < r.counterexamples.size(); ++k)
      j["more_counterexamples"].push_back(counterexample(r, r.counterexamples[k]));
  }
  j["digest"] = fmt::format("{:016x}", r.digest);
  j["seconds"] = r.seconds;
  return j;
}

}  // namespace

std::string to_json(const Report& report, std::uint64_t seed, const std::optional<Shard>& shard,
                    const Identity& identity, const std::string& scene, const std::vector<RunsOn>& runs_on,
                    const std::string& cause) {
  Json j{{"schema", "mmverify.result/1"},
         {"tool", tool({{"threads", report.threads}, {"seed", seed}})},
         {"results", Json::array()},
         {"mutants", Json::array()}};
  j["tool"]["source_hash"] = build::source_hash;
  if (shard) {
    Json run = Json::object();
    for (const auto& [name, value] : identity) run[name] = value;
    j["shard"] = {
        {"number", shard->number}, {"of", shard->of}, {"finished", !report.interrupted}, {"run", run}};
  }
  for (const RunsOn& one : runs_on) {
    Json about = Json::object();
    for (const auto& [key, value] : one.about) about[key] = value;
    j["runs_on"].push_back({{"subject", one.subject}, {"about", about}, {"warnings", one.warnings}});
  }
  if (!scene.empty()) j["scene"] = Json::parse(scene);
  if (!cause.empty()) j["cause"] = Json::parse(cause);
  for (const Result& r : report.results) j["results"].push_back(result(r));
  for (const Diagnosis& d : report.diagnoses)
    j["diagnoses"].push_back({{"law", d.law}, {"subject", d.subject}, {"lines", d.lines}});
  for (const MutantResult& m : report.mutants) {
    Json one{{"law", m.law}, {"mutant", m.mutant}, {"killed", m.killed}};
    one["level"] = m.killed ? Json(m.level) : Json(nullptr);
    one["case"] = m.killed ? Json(m.at) : Json(nullptr);
    j["mutants"].push_back(one);
  }
  // A merge adds shards up, so a change in one would enter the sum unseen; hence the seal.
  if (shard) j["seal"] = gate::seal_of(j);
  return json_text(j);
}

}  // namespace mmverify::cli
