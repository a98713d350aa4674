// Words and conditions as text of SMT-LIB 2; formulas that are used more than once get names.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mmverify::source {

/// A condition: "true", "false", a name or a formula of sort Bool.
using Condition = std::string;

/// A word of `width` bits; a word of no bits is 0.
struct Bits {
  std::string text;
  unsigned width = 0;
  std::optional<std::uint64_t> value = std::nullopt;  ///< the value of a constant below 2^64
};

Condition both(const Condition& a, const Condition& b);
Condition either(const Condition& a, const Condition& b);
Condition negated(const Condition& a);
Condition differ(const Condition& a, const Condition& b);
Condition choose(const Condition& c, const Condition& a, const Condition& b);

Bits constant(std::uint64_t value, unsigned width);
Bits zeros(unsigned width);
Bits ones(unsigned width);

/// Gives each new formula a name.
class Definitions {
 public:
  /// A formula is defined once; names begin with `prefix`.
  explicit Definitions(std::string prefix) : prefix_(std::move(prefix)) {}

  Condition name(const Condition& formula);
  Bits name(const Bits& word);
  /// An unconstrained word.
  Bits free_word(unsigned width);
  Condition free_condition();

  /// Names and formulas, each over earlier names.
  const std::vector<std::pair<std::string, std::string>>& all() const { return all_; }
  /// The commands that declare the unconstrained constants.
  const std::string& declarations() const { return declarations_; }

  // Operations on words; the results have names. Domain: two operands have equal widths.
  Bits unary(const char* head, const Bits& a);
  Bits binary(const char* head, const Bits& a, const Bits& b);
  Bits concat(const Bits& high, const Bits& low);
  Bits extract(const Bits& a, unsigned high, unsigned low);  ///< bits high..low
  Bits widened(const Bits& a, unsigned width);               ///< zeros above
  Bits widened_with_sign(const Bits& a, unsigned width);
  Bits lowest(const Bits& a, unsigned width);  ///< cut, or zeros above
  Bits times_two_to(const Bits& a, unsigned k) { return concat(a, zeros(k)); }
  Bits shifted_down(const Bits& a, unsigned k);  ///< keeps the width
  Bits choose_word(const Condition& c, const Bits& a, const Bits& b);
  Condition equal(const Bits& a, const Bits& b);
  Condition below(const Bits& a, const Bits& b);  ///< unsigned
  Condition asked(const char* head, const Bits& a, const Bits& b);
  Condition is_zero(const Bits& a);
  Condition bit(const Bits& a, unsigned k);
  Bits of_condition(const Condition& c, unsigned width);  ///< 1 or 0

 private:
  std::string defined(const std::string& formula);

  std::string prefix_, declarations_;
  std::vector<std::pair<std::string, std::string>> all_;
  std::map<std::string, std::string> names_;
  std::size_t free_ = 0;
};

}  // namespace mmverify::source
