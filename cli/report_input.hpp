// The files that mmverify report shows, read and checked.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mmverify::cli {

struct ReportInput {
  std::string name;                ///< as it was given
  nlohmann::ordered_json content;  ///< one run of schema mmverify.result/1 or mmverify.bench/1
};

/// What prove --json, scene --json or bench --json wrote; a bench of several topics is several inputs.  What
/// their schemas do not name is left out.  Throws EnvironmentError, which names the file and the place in it,
/// where it is missing, is no such file or contradicts itself.
/// Source: docs/result.schema.json and docs/bench.schema.json, by way of gate/schema.hpp.
std::vector<ReportInput> read_report_input(const std::string& path);

}  // namespace mmverify::cli
