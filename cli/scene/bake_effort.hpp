// The options that say how many micro-triangles the laws of baking look at.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "proofs/scene/bake_sample.hpp"

namespace mmverify::cli {

/// At most one is given; none: as much work as loading and baking are.
struct BakeEffort {
  std::optional<std::uint64_t> samples;  ///< --samples
  std::optional<double> budget;          ///< --budget, in seconds of all laws of baking
  bool exhaustive = false;               ///< --exhaustive
};

/// Adds the three options; each help text begins with `about`.
void add_effort(CLI::App& command, BakeEffort& effort, const std::string& about = "");

/// The micro-triangles that each law looks at; all if their work is at most `whole`, unless the user says otherwise.
proofs::scene::BakeSample sample_of(const BakeEffort& effort, const proofs::scene::Data& data,
                                    unsigned threads, std::uint64_t whole = 0);

/// The setting as a word, for the identity of a journal.
std::string word_of(const BakeEffort& effort);

}  // namespace mmverify::cli
