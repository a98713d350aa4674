// The members of a JSON object that docs/array.schema.json describes: their presence, types and ranges.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "scene/validate/report.hpp"

namespace mmverify::scene {

/// Readers of members; each reports what is wrong, at the member's pointer.
class Members {
 public:
  explicit Members(Report& report) : report_(report) {}

  /// Reports a value of another type than `due`.
  void type(const std::string& pointer, const std::string& due, const nlohmann::json& is) const;

  /// Reports each member that is none of `names`.
  void allow(const nlohmann::json& object, const std::string& at,
             std::initializer_list<const char*> names) const;

  bool is_object(const nlohmann::json& json, const std::string& at) const;

  /// Whether the member is there.
  bool there(const nlohmann::json& object, const std::string& at, const char* name) const;

  /// The member, or `otherwise` if it is missing; none, and a finding, if it is no number below `end`.  -0 is
  /// 0, as for the schema.
  std::optional<std::uint64_t> number(const nlohmann::json& object, const std::string& at, const char* name,
                                      std::uint64_t otherwise,
                                      std::uint64_t end = std::numeric_limits<std::uint64_t>::max()) const;

  /// Sets `to` to the member if it is there; false, and a finding, if it is neither true nor false.
  bool yes_or_no(const nlohmann::json& object, const std::string& at, const char* name, bool& to) const;

 private:
  Report& report_;
};

}  // namespace mmverify::scene
