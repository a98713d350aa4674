#include "cli/report/input.hpp"

#include <fmt/format.h>

#include "cli/output/exit_code.hpp"
#include "cli/results/read_json.hpp"
#include "delivery/gate/contradictions.hpp"
#include "delivery/gate/figures.hpp"
#include "delivery/gate/schema.hpp"

namespace mmverify::cli {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw EnvironmentError(fmt::format("{}: {}", place, what));
}

std::string schema_of(const Json& j) {
  return j.is_object() && j.contains("schema") && j["schema"].is_string() ? j["schema"].get<std::string>()
                                                                          : "";
}

}  // namespace

std::vector<ReportInput> read_report_input(const std::string& path) {
  const Json j = read_json(path);
  const bool several = j.is_array() && !j.empty();
  std::vector<ReportInput> inputs;
  for (std::size_t k = 0; k < (several ? j.size() : 1); ++k) {
    const Json& one = several ? j[k] : j;
    const std::string place = several ? fmt::format("{}[{}]", path, k) : path, schema = schema_of(one);
    const auto known = gate::schema_named(schema);
    if (!known)
      refuse(place,
             fmt::format("{}; mmverify report takes what prove, scene, render and bench write with --json",
                         schema.empty() ? "no schema of mmverify"
                                        : fmt::format("schema '{:.60}' is none that it knows", schema)));
    try {
      // Contradictions come first: their messages are plainer than those of a schema's conditions.
      gate::refuse_contradictions(one);
    } catch (const gate::NoResult& why) {
      refuse(place, why.what());
    }
    try {
      inputs.push_back({path, gate::known_part(*known, one, place)});
    } catch (const gate::Misfit& why) {
      throw EnvironmentError(why.what());
    }
  }
  return inputs;
}

}  // namespace mmverify::cli
