// How each field of a result is compared: what its schema says.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "gate/schema.hpp"

namespace mmverify::gate {

enum class Rule {
  key,         ///< says what the object is about; part of its figures' name
  setting,     ///< of the run: results of different settings cannot be compared
  verdict,     ///< proved before checked before not_applicable, incomplete, broken and refuted
  yes,         ///< true is better
  more,        ///< a larger number is better
  less,        ///< a smaller number is better
  same,        ///< neither is better
  digest,      ///< the same, of what is proved: the answers to all cases; of anything else left out
  about_more,  ///< a sum of fractions, equal to within one in 10^9; larger is better
  about_less,  ///< the like; smaller is better
  about,       ///< the like; neither is better
  speed_more,  ///< a ratio of times within the run, compared with a tolerance; larger is better
  speed_less,  ///< the like; smaller is better
  left_out     ///< not compared, nor what it holds: a time, a name of a machine
};

/// The rules of one schema: each field's keyword "x-gate", by the field's place.
class Rules {
 public:
  /// header: the members that decide which part of the schema counts, of a bench {"topic": "tree"}.
  /// Throws std::logic_error, which names the place, where a field has no rule and lies in nothing left out:
  /// a new field is met with an error and not with silence.
  Rules(const Schema& schema, const nlohmann::ordered_json& header);
  Rules(Rules&&) noexcept;
  ~Rules();

  /// The rule of the field at a place, written as "results[].by_kind.vertex.cases"; nothing where the schema
  /// knows no such field, or an object or a list whose fields have their own.
  std::optional<Rule> at(std::string_view place) const;

 private:
  struct Field;
  std::unique_ptr<Field> root_;
};

/// The same of the program's own: "mmverify.result/1", or "mmverify.bench/1" and a topic,
/// "mmverify.bench/1 tree".
std::optional<Rule> rule_of(const std::string& schema, const std::string& place);

/// The place of a verdict from the worst on: refuted, broken, incomplete, not_applicable, checked, proved;
/// nothing for any other word.
std::optional<int> rank_of_verdict(const std::string& verdict);
inline bool is_verdict(const std::string& word) { return rank_of_verdict(word).has_value(); }

}  // namespace mmverify::gate
