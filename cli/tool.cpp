#include "cli/tool.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/build_info.hpp"

namespace mmverify::cli {
namespace {

/// The processor's name and numbers: the name alone may stand for several generations, as "AMD EPYC" in a
/// virtual machine.
std::string cpu_name() {
  std::string name = "unknown", numbers;
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line) && !line.empty();) {
    const auto colon = line.find(": ");
    if (colon == std::string::npos) continue;
    const std::string value = line.substr(colon + 2);
    if (line.starts_with("model name")) name = value;
    if (line.starts_with("cpu family")) numbers = " (family " + value;
    if (line.starts_with("model\t")) numbers += ", model " + value + ")";
  }
  return name + numbers;
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
