// Somebody's shared library, as subjects of every topic that it has entry points of.
#pragma once

#include <string>
#include <vector>

#include "proofs/topics.hpp"

namespace mmverify::proofs {

/// Opens the library once.  The first of its subjects is named as the file, the others FILE:KIND.
/// One batch, or one map or code, may take `timeout_seconds`.
/// Throws dock::CannotLoad, and std::runtime_error where no process can be had.
std::vector<PluginSubject> plugin_subjects(const std::string& file, double timeout_seconds);

/// FILE:KIND in two; the kind is empty where the name has none.
struct PluginName {
  std::string file, kind;
};
PluginName plugin_name(const std::string& name);

}  // namespace mmverify::proofs
