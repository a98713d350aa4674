// The table of all findings of `mmverify validate`, each with its remedy.  docs/ISSUES.md is this table.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace mmverify::scene {

/// error: a rule forbids it.  warning: no rule forbids it, but a text advises against it, or nothing was
/// judged.
/// advice: no text mentions it, but a driver is known to crash.
enum class Severity : std::uint8_t { error, warning, advice };

const char* name_of(Severity severity) noexcept;

struct Issue {
  std::string_view
      code;  ///< stable; that of a rule of impl/micromap/rules.hpp or file_rules() if there is one
  Severity severity;
  std::string says;    ///< the rule, as a statement about a good file
  std::string source;  ///< the text that has the rule
  const char* remedy;  ///< one line
};

/// All issues in the order of docs/ISSUES.md, each code once.
std::span<const Issue> issues();

/// The issue of a code.  Errors: std::out_of_range for an unknown code.
const Issue& issue_of(std::string_view code);

}  // namespace mmverify::scene
