// The words of `mmverify check maps` on wrong maps: their cause, a picture, and the command that may repair them.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "cli/output/output_file.hpp"
#include "cli/scene/check_maps.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/scene/cause/cause.hpp"
#include "scene/validate/stored_maps.hpp"

namespace mmverify::cli {

/// Prints the command that may repair the file; nothing for the buffers of a build.
void print_repair(std::FILE* out, const CheckMapsOptions& options,
                  const std::optional<proofs::scene::Cause>& cause);

/// Prints why maps are wrong and what to do, and draws the first wrong micro-triangle into `picture`, if there is one.
/// Right maps get a note if most of their unknown states are on the other side.  `rules_first`: the file breaks rules that
/// `repair` puts right, which may be all that is wrong with its maps.
/// Returns the cause as JSON: null, or empty if nothing is wrong.
std::string print_why(std::FILE* out, const CheckMapsOptions& options, bool two_state,
                      const mmverify::scene::Scene& scene, const mmverify::scene::StoredMaps& maps,
                      const proofs::Report& report, OutputFile* picture, bool rules_first);

}  // namespace mmverify::cli
