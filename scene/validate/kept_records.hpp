// The records of bakes that a glTF file keeps beside its maps.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "scene/validate/draft.hpp"

namespace mmverify::scene {

struct Document;

/// A primitive by its mesh and its number there.
using PrimitivePlace = std::pair<std::size_t, std::size_t>;

/// The record of each primitive's extension, as JSON (bake_record()); primitives without one are left out.
std::map<PrimitivePlace, std::string> kept_records(const Document& document, Draft draft);

/// The states that the records say the maps were baked to, 2 or 4; none without records, and where they differ.
std::optional<int> recorded_states(const Document& document, Draft draft);

}  // namespace mmverify::scene
