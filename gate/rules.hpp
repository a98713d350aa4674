// How each field of a result is compared: one table.
#pragma once

#include <optional>
#include <string>

namespace mmverify::gate {

enum class Rule {
  key,         ///< says what the object is about; part of its figures' name
  setting,     ///< of the run: results of different settings cannot be compared
  verdict,     ///< proved before checked before not_applicable, incomplete, broken and refuted
  yes,         ///< true is better
  more,        ///< a larger number is better
  less,        ///< a smaller number is better
  same,        ///< neither is better
  about_more,  ///< a sum of fractions, equal to within one in 10^9; larger is better
  about_less,  ///< the like; smaller is better
  about,       ///< the like; neither is better
  speed_more,  ///< a ratio of times within the run, compared with a tolerance; larger is better
  speed_less,  ///< the like; smaller is better
  left_out     ///< not compared, nor what it holds: a time, a name of a machine
};

/// What happens to the field at a place, written as "results[].by_kind.vertex.cases"; nothing where no line
/// of the table speaks of it, so that a new field is met with an error and not with silence.  A "*" in it
/// stands for a name.
/// schema: "mmverify.result/1", or "mmverify.bench/1" and a topic, "mmverify.bench/1 tree".
std::optional<Rule> rule_of(const std::string& schema, const std::string& place);

/// The place of a verdict from the worst on: refuted, broken, incomplete, not_applicable, checked, proved;
/// nothing for any other word.
std::optional<int> rank_of_verdict(const std::string& verdict);
inline bool is_verdict(const std::string& word) { return rank_of_verdict(word).has_value(); }

}  // namespace mmverify::gate
