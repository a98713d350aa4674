// The facts that the schema of results states of a field: type, bounds, words, rule, description.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mmverify::bench {

/// How `mmverify gate` compares a field, the schema's x-gate; delivery/gate/rules.hpp explains each.
enum class Rule : std::uint8_t {
  no_rule,  ///< the rule of what the field lies in
  key,
  setting,
  verdict,
  more,
  less,
  same,
  about,
  about_more,
  about_less,
  speed_more,
  speed_less,
  left_out,
};
using enum Rule;

struct Bounds {
  std::optional<std::int64_t> least = {}, most = {};
};

struct Property {
  enum class Type : std::uint8_t { none, integer, number, text, words, object, list };

  std::string name = {};  ///< in JSON; "a.b" is b of an object a; empty: not written
  Type type = Type::none;
  Rule rule = no_rule;
  std::string description = {};
  Bounds bounds = {};                                                ///< of a number; of a list's length
  std::vector<std::variant<std::uint64_t, std::string>> words = {};  ///< the only values
  bool required = true;
  std::string there_if = {};  ///< a JSON Schema of the object: the field is there exactly if it holds
  Bounds elements = {};       ///< of a list of whole numbers: its length

  Property() = default;
  Property(const char* of_name) : name(of_name) {}
  Property(std::string of_name) : name(std::move(of_name)) {}
  Property(std::string of_name, Type of_type, Rule of_rule, std::string says, Bounds within = {})
      : name(std::move(of_name)),
        type(of_type),
        rule(of_rule),
        description(std::move(says)),
        bounds(within) {}

  /// The same property of an object that may lack it.
  Property if_any() && {
    required = false;
    return std::move(*this);
  }
  Property if_so(std::string schema) && {
    there_if = std::move(schema);
    return std::move(*this);
  }
  Property list_of(std::int64_t length) && {
    elements = {length, length};
    return std::move(*this);
  }
};

inline Property whole(std::string name, Rule rule, Bounds bounds, std::string description = {}) {
  return {std::move(name), Property::Type::integer, rule, std::move(description), bounds};
}
inline Property count(std::string name, Rule rule, std::string description = {}) {
  return whole(std::move(name), rule, {0}, std::move(description));
}
inline Property positive(std::string name, Rule rule, std::string description = {}) {
  return whole(std::move(name), rule, {1}, std::move(description));
}
inline Property level(std::int64_t highest, Rule rule = key, std::string description = {}) {
  return whole("level", rule, {0, highest}, std::move(description));
}

inline Property real(std::string name, Rule rule, Bounds bounds, std::string description = {}) {
  return {std::move(name), Property::Type::number, rule, std::move(description), bounds};
}
inline Property number(std::string name, Rule rule, std::string description = {}) {
  return real(std::move(name), rule, {0}, std::move(description));
}
inline Property share(std::string name, Rule rule, std::string description = {}) {
  return real(std::move(name), rule, {0, 1}, std::move(description));
}
inline Property ratio(std::string name, Rule rule,
                      std::string description = "of two times, or of two sizes, of one run") {
  return number(std::move(name), rule, std::move(description));
}
inline Property time(std::string name, std::string description, Rule rule = left_out) {
  return number(std::move(name), rule, std::move(description));
}

inline Property seed_of_all() {
  return count("seed", setting, "of the points, lookups, maps or textures that are generated");
}

/// Texts are not empty.
inline Property text(std::string name, Rule rule, std::string description = {}) {
  return {std::move(name), Property::Type::text, rule, std::move(description)};
}

template <class Word>
Property one_of_range(std::string name, Rule rule, const Word& words, std::string description = {}) {
  Property property{std::move(name), Property::Type::words, rule, std::move(description)};
  for (const auto& word : words) property.words.emplace_back(word);
  return property;
}
inline Property one_of(std::string name, Rule rule, std::initializer_list<const char*> words,
                       std::string description = {}) {
  return one_of_range(std::move(name), rule, std::vector<std::string>(words.begin(), words.end()),
                      std::move(description));
}
inline Property one_of(std::string name, Rule rule, std::initializer_list<std::uint64_t> words,
                       std::string description = {}) {
  return one_of_range(std::move(name), rule, words, std::move(description));
}

inline Property object(std::string name, Rule rule, std::string description = {}) {
  return {std::move(name), Property::Type::object, rule, std::move(description)};
}
inline Property list(std::string name, std::string description = {}, Bounds length = {1},
                     Rule rule = no_rule) {
  return {std::move(name), Property::Type::list, rule, std::move(description), length};
}

}  // namespace mmverify::bench
