// All that `mmverify validate` can find, each with what to do about it.  docs/ISSUES.md is this table.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace mmverify::scene {

/// error: a rule forbids it.  warning: no rule forbids it, but a text advises against it, or nothing was judged.
/// advice: no text speaks of it, and a driver is known to crash.
enum class Severity : std::uint8_t { error, warning, advice };

const char* name_of(Severity severity) noexcept;

struct Issue {
  std::string_view
      code;  ///< stable; that of a rule of impl/micromap/rules.hpp or file_rules() where there is one
  Severity severity;
  std::string says;    ///< what is so where all is well
  std::string source;  ///< who says so
  const char* remedy;  ///< one line
};

/// In the order of docs/ISSUES.md, each code once.
std::span<const Issue> issues();

/// The issue of a code.  Errors: std::out_of_range for a code that is none.
const Issue& issue_of(std::string_view code);

}  // namespace mmverify::scene
