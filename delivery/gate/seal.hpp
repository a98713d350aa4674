// Seals: checksums that show whether a result's file was changed.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mmverify::gate {

/// The checksum of an object without its member "seal": CRC-64 (ECMA-182, reflected) of its JSON without
/// spaces, as 16 hexadecimal digits. It finds slips, not forgers.
/// Domain: an object.
std::string seal_of(const nlohmann::ordered_json& run);

/// Whether the object has a seal that matches its content.
bool is_sealed(const nlohmann::ordered_json& run);

}  // namespace mmverify::gate
