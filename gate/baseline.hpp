// Baselines as files: what a result said, one thing a line, so that a change shows in a diff.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gate/figures.hpp"

namespace mmverify::gate {

struct Baseline {
  std::string schema;     ///< the result's
  std::string processor;  ///< that it was taken on; empty where nobody said
  Settings settings;
  Groups<Value> groups;
};

/// The figures without their rules.
Baseline baseline_of(const Figures& figures);

/// Whether a file says that it is one.
bool is_baseline(const nlohmann::ordered_json& file);

/// Of a file: a baseline, or a result itself, which may serve as one.  Throws NoResult.
Baseline baseline_of(const nlohmann::ordered_json& file);

/// Schema mmverify.baseline/1:
///   {"schema": .., "of": the result's schema, "processor": .., "settings": {NAME: VALUE ..},
///    "figures": {GROUP: {FIGURE: VALUE ..} ..}}
std::string to_json(const Baseline& baseline);

}  // namespace mmverify::gate
