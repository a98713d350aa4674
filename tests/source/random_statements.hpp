// Random statements that C and shading languages have in common: variables, branches, loops.
#pragma once

#include <fmt/format.h>

#include <string>

#include "proofs/engine/random.hpp"

namespace mmverify::tests {

class RandomStatements {
 public:
  virtual ~RandomStatements() = default;

 protected:
  RandomStatements(std::uint64_t seed, std::uint64_t language) : random_(seed, language, 0) {}
  RandomStatements(const RandomStatements&) = default;
  RandomStatements& operator=(const RandomStatements&) = default;

  /// Expressions of the language.
  virtual std::string condition() = 0;
  virtual std::string number() = 0;
  virtual std::string word() = 0;
  /// A statement that the language has besides; empty: it has none.
  virtual std::string further() { return {}; }
  virtual bool has_further() const { return false; }

  template <std::size_t n>
  const char* one_of(const char* const (&all)[n]) {
    return all[random_.below(n)];
  }
  /// A float's name, and a word's.
  std::string x() { return fmt::format("x{}", random_.below(variables)); }
  std::string a() { return fmt::format("a{}", random_.below(variables)); }

  void statements(unsigned count, unsigned depth, const std::string& indent) {
    for (unsigned k = 0; k < count; ++k) {
      const std::uint64_t kind = random_.below(depth >= 2 ? 6 : has_further() ? 10 : 9);
      if (kind < 3)
        text_ += fmt::format("{}{} = {};\n", indent, x(), number());
      else if (kind < 6)
        text_ += fmt::format("{}{} = {};\n", indent, a(), word());
      else if (kind == 6)
        block(fmt::format("if ({})", condition()), depth, indent, true);
      else if (kind == 7)
        block(fmt::format("for (int k = 0; k < {}; ++k)", random_.between(1, 3)), depth, indent, false);
      else if (kind == 8)
        text_ += fmt::format(
            "{0}switch ({1} & 3u) {{\n{0}  case 0u: {2} = {3}; break;\n{0}  case 2u: {4} = {5};\n{0}  "
            "default: {6} ^= 5u;\n{0}}}\n",
            indent, a(), a(), word(), x(), number(), a());
      else
        text_ += indent + further();
    }
  }

  proofs::Random random_;
  std::string text_;

 private:
  static constexpr unsigned variables = 4;

  void block(const std::string& opening, unsigned depth, const std::string& indent, bool other) {
    text_ += fmt::format("{}{} {{\n", indent, opening);
    statements(2, depth + 1, indent + "  ");
    if (other && random_.below(2) == 0) {
      text_ += indent + "} else {\n";
      statements(2, depth + 1, indent + "  ");
    }
    text_ += indent + "}\n";
  }
};

}  // namespace mmverify::tests
