// Whether a file still says what was written into it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mmverify::gate {

/// A checksum of all that the object says but for its own member "seal": CRC-64 (ECMA-182, reflected) of its JSON without
/// spaces, as 16 hexadecimal digits. It finds slips, not forgers.
/// Domain: an object.
std::string seal_of(const nlohmann::ordered_json& run);

/// Whether the object has a seal, and it is that of its content.
bool is_sealed(const nlohmann::ordered_json& run);

}  // namespace mmverify::gate
