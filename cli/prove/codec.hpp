// mmverify prove --source of a codec: its laws for all maps at once, from its source.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::cli {

/// The arguments of `prove` that a codec's source takes.
struct CodecOptions {
  std::string file;
  std::vector<std::string> flags, laws;
  std::optional<proofs::Levels> levels;
  std::optional<std::string> format;  ///< "2-state", "4-state"
  std::optional<std::string> one_case;
  std::string certificates;   ///< a folder
  std::string second_solver;  ///< a program; empty: none
  proofs::Tier tier = proofs::Tier::fast;
  double budget = 60, timeout = 10;
  std::uint64_t seed = 1;
  bool quiet = false, details = false;
  std::string json, junit;
};

/// Whether arguments ask for a codec's laws: neither a function is named nor index.floats.
bool asks_for_codec(const std::vector<std::string>& laws, bool function_named);

/// Proves the laws, or runs one case again.  Returns the exit code.
/// Errors: UsageError, EnvironmentError.
int prove_codec(const CodecOptions& options);

}  // namespace mmverify::cli
