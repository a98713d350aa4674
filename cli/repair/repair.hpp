// mmverify repair: puts a file's micromaps right, and leaves the rest of it as it is.
#pragma once

#include <cstdio>
#include <string>

#include "proofs/scene/repair/file_repair.hpp"

namespace mmverify::cli {

struct RepairOptions {
  std::string file, output, json;
  int states = 4;
  bool details = false, quiet = false;
  proofs::scene::RepairRequest request;
};

/// Repairs the file; the exit code.
/// Errors: UsageError, EnvironmentError, BadScene.
int repair(const RepairOptions& options);

/// Prints what was done and what is left, a line for each primitive and kind of repair; with `details` each triangle.
void print_repairs(std::FILE* out, const RepairOptions& options, const mmverify::scene::Scene& scene,
                   const proofs::scene::RepairReport& report);

/// Schema mmverify.repair/1 (docs/REPAIR.md).
std::string repairs_json(const RepairOptions& options, const mmverify::scene::Scene& scene,
                         const proofs::scene::RepairReport& report);

}  // namespace mmverify::cli
