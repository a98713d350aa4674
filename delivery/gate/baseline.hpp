// Baselines: files of a result's figures, a line for equal ones of a law, so that a change shows in a diff.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "delivery/gate/figures.hpp"

namespace mmverify::gate {

struct Baseline {
  std::string schema;     ///< the result's schema
  std::string processor;  ///< the machine's processor; empty if the result names none
  Settings settings;
  Groups<Value> groups;
};

/// Whether a law does not apply to the subject: such a result is no part of a baseline.
bool is_not_applicable(const Value& verdict);

/// The figures without their rules, and without results whose law does not apply.
Baseline baseline_of(const Figures& figures);

/// Whether the file's schema is that of a baseline.
bool is_baseline(const nlohmann::ordered_json& file);

/// The baseline in a file: the file is a baseline, or a result that serves as one. Throws NoResult.
Baseline baseline_of(const nlohmann::ordered_json& file);

/// Schema mmverify.baseline/1:
///   {"schema": .., "of": the result's schema, "processor": .., "settings": {NAME: VALUE ..},
///    "figures": {GROUP: {"also": [GROUP ..], FIGURE: VALUE ..} ..}}
/// "also" names the groups of the same law that have these figures, too; without such groups it is missing.
std::string to_json(const Baseline& baseline);

}  // namespace mmverify::gate
