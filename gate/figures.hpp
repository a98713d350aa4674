// What a result says, as named figures.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>

#include "gate/rules.hpp"

namespace mmverify::gate {

/// A file that is no result, or not one that can be compared; what() says where.
struct NoResult : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A text, a number, true or false as JSON writes it, so that 64 bits survive.
struct Value {
  std::string text;
  double number = 0;  ///< of numbers; else 0
};

/// `"proved"` as proved; what is no text as it is.
std::string unquoted(const std::string& json);

struct Figure {
  Value value;
  Rule rule;
};

/// What is compared of one thing, by name: a law on a subject at a level, a row of a bench, a scene.
template <class Of>
using Groups = std::map<std::string, std::map<std::string, Of>>;

/// Of the run: seed, samples and the like.
using Settings = std::map<std::string, std::string>;

struct Figures {
  std::string schema;     ///< "mmverify.result/1" or "mmverify.bench/1"
  std::string processor;  ///< that it says it ran on; empty where it says nothing
  Settings settings;
  Groups<Figure> groups;
};

/// Every field that a rule compares, of a run of prove or scene, or of one or more topics of bench.
/// Throws NoResult: no such schema, a shard, nothing in it, or a field that no rule speaks of.
Figures figures_of(const nlohmann::ordered_json& result);

}  // namespace mmverify::gate
