// Reads and checks the files that mmverify report shows.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mmverify::cli {

struct ReportInput {
  std::string name;                ///< the path as given
  nlohmann::ordered_json content;  ///< one run of schema mmverify.result/1 or mmverify.bench/1
};

/// The runs in a file of prove --json, scene --json or bench --json, without members that the schemas do not
/// name; a bench of several topics is several inputs. Throws EnvironmentError, which names the file and the
/// place in it, if the file is missing, is no such file or contradicts itself.
/// Source: the schemas of results and of benches, by way of delivery/gate/schema.hpp.
std::vector<ReportInput> read_report_input(const std::string& path);

}  // namespace mmverify::cli
