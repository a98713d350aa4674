// How each field of a result is compared: the keyword "x-gate" of its schema.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "delivery/gate/schema.hpp"

namespace mmverify::gate {

enum class Rule {
  key,         ///< names the object; part of its figures' name
  setting,     ///< a setting of the run: results of different settings cannot be compared
  verdict,     ///< from best: proved, checked, not_applicable, incomplete, broken, refuted
  yes,         ///< true is better
  more,        ///< a larger number is better
  less,        ///< a smaller number is better
  same,        ///< any change counts, neither way is better
  digest,      ///< a digest of the answers to all cases: as `same` if proved, else left out
  about_more,  ///< a sum of fractions, equal to within one in 10^9; larger is better
  about_less,  ///< the same, but smaller is better
  about,       ///< the same, but neither way is better
  speed_more,  ///< a ratio of times within the run, compared with a tolerance; larger is better
  speed_less,  ///< the same, but smaller is better
  left_out     ///< not compared, its members neither: a time, a name of a machine
};

/// The rules of one schema, by the places of its fields.
class Rules {
 public:
  /// header: the members that decide which part of the schema applies, {"topic": "tree"} for a bench.
  /// Throws std::logic_error, which names the place, if a field has no rule and lies in nothing that is left
  /// out: a new field is an error, not ignored.
  Rules(const Schema& schema, const nlohmann::ordered_json& header);
  Rules(Rules&&) noexcept;
  ~Rules();

  /// The rule of the field at a place, such as "results[].by_kind.vertex.cases". Nothing if the schema has no
  /// such field, or the field is an object or a list whose members have rules of their own.
  std::optional<Rule> at(std::string_view place) const;

 private:
  struct Field;
  std::unique_ptr<Field> root_;
};

/// The rule of a field in mmverify's own schemas. schema: "mmverify.result/1", or "mmverify.bench/1" and a
/// topic, "mmverify.bench/1 tree".
std::optional<Rule> rule_of(const std::string& schema, const std::string& place);

/// The rank of a verdict, from the worst: refuted, broken, incomplete, not_applicable, checked, proved.
/// Nothing for any other word.
std::optional<int> rank_of_verdict(const std::string& verdict);
inline bool is_verdict(const std::string& word) { return rank_of_verdict(word).has_value(); }

}  // namespace mmverify::gate
