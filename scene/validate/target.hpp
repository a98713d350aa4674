// The API and the device that a file is judged for.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "impl/micromap/validate.hpp"

namespace mmverify::scene {

class Report;

/// The limits and features of a device, and a flag of the pipelines on it.
struct Device {
  impl::micromap::Limits limits = {};
  bool index_uint8 = true;  ///< the feature indexTypeUint8 is on
  /// The pipelines have the flag OPACITY_MICROMAP_DISALLOW_MIXED_SPECIAL_INDEX.
  bool disallow_mixed = false;
};

/// A file's use: the APIs whose rules apply besides the file's own, and the device.
struct Target {
  impl::micromap::Sets apis = 0;      ///< none: those that a sidecar names, or glTF's rules alone
  std::optional<Device> device = {};  ///< none: that of a sidecar, or one without limits of its own
};

/// Reads the object `limits` of a sidecar at `pointer`: docs/array.schema.json.  None, and findings, if a member's value
/// is of another type or range.
std::optional<Device> read_device(const nlohmann::json& given, const std::string& pointer, Report& report);

/// Reads a file that has such an object alone.  Errors: BadScene, which names the file and the member.
Device read_device(const std::string& file);

}  // namespace mmverify::scene
