// Checks the runs in a file against their schemas.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mmverify::gate {

/// Throws NoResult if a run in the file contradicts itself or does not fit the schema that it names. The file
/// holds one run or a list. what() begins with the place, "run.json.results[1].level". Runs of other schemas
/// and shards are skipped.
/// place: the file's name in messages.
void refuse_misfits(const nlohmann::ordered_json& file, const std::string& place);

}  // namespace mmverify::gate
