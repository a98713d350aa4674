// Reads a result as named figures.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>

#include "delivery/gate/rules.hpp"

namespace mmverify::gate {

/// A file that is no result, or one that cannot be compared; what() names the place.
struct NoResult : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A text, a number, true or false, kept as JSON writes it: 64-bit numbers survive.
struct Value {
  std::string text;
  double number = 0;  ///< the value of a number; 0 for other types
};

/// A JSON text without its quotes; other JSON as it is.
std::string unquoted(const std::string& json);

struct Figure {
  Value value;
  Rule rule;
};

/// Figures by group and name. A group is a law on a subject at a level, a row of a bench, or a scene.
template <class Of>
using Groups = std::map<std::string, std::map<std::string, Of>>;

/// The run's settings: seed, samples and the like.
using Settings = std::map<std::string, std::string>;

struct Figures {
  std::string schema;     ///< "mmverify.result/1" or "mmverify.bench/1"
  std::string processor;  ///< the processor that the result names; empty if none
  Settings settings;
  Groups<Figure> groups;
};

/// Every field that a rule compares, in a run of prove or scene, or in one or more topics of bench.
/// Throws NoResult if the schema is unknown, the result is a shard or has no figures, or a field has no rule.
Figures figures_of(const nlohmann::ordered_json& result);

}  // namespace mmverify::gate
