#include "delivery/gate/runs.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "delivery/gate/contradictions.hpp"
#include "delivery/gate/figures.hpp"
#include "delivery/gate/schema.hpp"

namespace mmverify::gate {

void refuse_misfits(const nlohmann::ordered_json& file, const std::string& place) {
  const bool several = file.is_array();
  for (std::size_t k = 0; k < (several ? file.size() : 1); ++k) {
    const auto& run = several ? file[k] : file;
    if (!run.is_object() || !run.contains("schema") || !run.at("schema").is_string()) continue;
    const auto known = schema_named(run.at("schema").get<std::string>());
    if (!known || run.contains("shard")) continue;  // a shard gets a plainer message elsewhere
    const std::string here = several ? fmt::format("{}[{}]", place, k) : place;
    try {
      refuse_contradictions(run);  // first: its message is plainer than a misfit
    } catch (const NoResult& why) {
      throw NoResult(fmt::format("{}: {}", here, why.what()));
    }
    try {
      known_part(*known, run, here);
    } catch (const Misfit& why) {
      throw NoResult(fmt::format("{}; take the file that mmverify wrote", why.what()));
    }
  }
}

}  // namespace mmverify::gate
