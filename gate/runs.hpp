// The runs of a file, read by their schemas.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mmverify::gate {

/// Throws NoResult where a run that the file holds, one or a list of them, contradicts itself or does not fit the schema
/// that it names; what() begins with the place, "run.json.results[1].level".  What names no schema of ours, and shards, are passed over.
/// place: what the file is called.
void refuse_misfits(const nlohmann::ordered_json& file, const std::string& place);

}  // namespace mmverify::gate
