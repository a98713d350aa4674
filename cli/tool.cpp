#include "cli/tool.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/build_info.hpp"

namespace mmverify::cli {
namespace {

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

}  // namespace

nlohmann::ordered_json tool(const nlohmann::ordered_json& settings) {
  nlohmann::ordered_json all{{"version", build::version},
                             {"compiler", build::compiler},
                             {"flags", build::flags},
                             {"cpu", cpu_name()}};
  all.update(settings);
  all["spec_hash"] = build::spec_hash;
  return all;
}

}  // namespace mmverify::cli
